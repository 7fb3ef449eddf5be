// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace etak::cli {

/// The number of columns for text on `descriptor` (standard_output of core/base/system.h): COLUMNS of the environment
/// where it is a number above 0, else the width of the terminal. 0 where neither is known: lines are then not
/// broken, as in files and pipes.
std::size_t columns_of(int descriptor);

}  // namespace etak::cli
