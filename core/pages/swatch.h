// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "core/color/rgb.h"

namespace etak {

/// A swatch for a terminal: `columns` blanks on a background of 24-bit colour, as ANSI escape sequences.
inline std::string swatch(const Srgb8& color, std::size_t columns) {
  return "\x1b[48;2;" + std::to_string(color.r) + ';' + std::to_string(color.g) + ';' +
         std::to_string(color.b) + 'm' + std::string(columns, ' ') + "\x1b[0m";
}

}  // namespace etak
