// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "core/rects/rects.h"

namespace etak {

/// Largest width or height that a list of rectangles may ask for.
inline constexpr int largest_rect_side = 1 << 22;

/// The rectangles of a list as packing benchmarks exchange them: a line "w h" each, in whole texels from 1 to
/// largest_rect_side; empty lines and lines that begin with '#' are skipped. Throws Error naming `file` and
/// line.
std::vector<RectSize> parse_rects(std::string_view text, std::string_view file);

}  // namespace etak
