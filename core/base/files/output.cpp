// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/output.h"

#include "core/base/signals.h"

namespace etak {

void put_in_place(std::span<Output* const> outputs) {
  const auto each = [&](void (Output::*step)()) {
    for (Output* const output : outputs)
      if (output != nullptr) (output->*step)();
  };
  each(&Output::prepare);
  {
    const SignalsHeld held;
    each(&Output::place);
  }
  each(&Output::tidy);
}

void Output::commit() {
  Output* const alone[] = {this};
  put_in_place(alone);
}

}  // namespace etak
