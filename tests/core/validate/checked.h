// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/image/image_io.h"
#include "core/validate/files/files.h"

namespace etak::test {

/// What is found in one target whose files lie on the disk.
inline CheckedFile checked(const CheckTarget& target, const Settings& settings = {}, unsigned threads = 1) {
  return check(target, image_io_decoder(), settings, threads);
}

}  // namespace etak::test
