// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/output.h"

#include <cerrno>

#include "core/base/files/read_places.h"
#include "core/base/signals.h"
#include "core/base/system.h"

namespace etak {

void put_in_place(std::span<Output* const> outputs) {
  const auto each = [&](void (Output::*step)()) {
    for (Output* const output : outputs)
      if (output != nullptr) (output->*step)();
  };
  each(&Output::prepare);
  {
    const SignalsHeld held;
    for (auto output = outputs.rbegin(); output != outputs.rend(); ++output)
      if (*output != nullptr) (*output)->place();
  }
  each(&Output::flush);
  each(&Output::tidy);
}

void Output::refuse_input(const sys::FileInfo& info, const std::string& path) const {
  if (read_) read_->refuse(info, path);
}

bool Output::names_to_disk(int folder) {
  return sys::to_disk(folder) || (errno != EIO && errno != ENOSPC);
}

void Output::commit() {
  Output* const alone[] = {this};
  put_in_place(alone);
}

}  // namespace etak
