// SPDX-License-Identifier: Apache-2.0
#include "app/cli/output/terminal.h"

#include <algorithm>
#include <cstdlib>

#include "core/base/number.h"
#include "core/base/system.h"

namespace etak::cli {
namespace {

// Widths are clamped to this range: nobody reads narrower text, and no terminal is wider.
constexpr double least_columns = 20, most_columns = 10000;

}  // namespace

std::size_t columns_of(int descriptor) {
  const char* const asked = std::getenv("COLUMNS");
  if (double value = 0; asked != nullptr && parse_number(asked, value) && value > 0)
    return static_cast<std::size_t>(std::clamp(value, least_columns, most_columns));
  const unsigned columns = sys::terminal_columns(descriptor);
  return columns == 0 ? 0
                      : static_cast<std::size_t>(std::clamp<double>(columns, least_columns, most_columns));
}

}  // namespace etak::cli
