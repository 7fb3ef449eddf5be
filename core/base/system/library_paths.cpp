// SPDX-License-Identifier: Apache-2.0
#ifndef __wasm__

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "core/base/system.h"

// What the C++ library does on POSIX systems and on Windows alike.

namespace etak::sys {

namespace fs = std::filesystem;

fs::path working_folder() {
  std::error_code failure;
  return fs::current_path(failure);
}

fs::path absolute(const fs::path& path) {
  std::error_code failure;
  return path.empty() ? path : fs::absolute(path, failure);
}

fs::path canonical(const fs::path& path) {
  std::error_code failure;
  fs::path out = fs::canonical(path, failure);
  if (!failure) return out;
  errno = failure.default_error_condition().value();
  return {};
}

}  // namespace etak::sys

#endif
