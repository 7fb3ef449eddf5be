// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace etak::cli {

/// Columns that text on `descriptor` (STDOUT_FILENO, STDERR_FILENO) has: COLUMNS of the environment where it
/// is a number, else the terminal's own; 0 where neither says one, so that files and pipes get whole lines.
std::size_t columns_of(int descriptor);

}  // namespace etak::cli
