// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "core/image/image.h"

namespace etak {

/// The box of a character in write_text(), in pixels at scale 1; its strokes take 5 x 7 of them.
inline constexpr int glyph_width = 6, glyph_height = 9;

/// Writes a text with its top left corner at column x, row y. The characters are capitals, digits and
/// "-.,/()+=:%"; small letters are written as capitals, and all others as blanks. Pixels outside of the image
/// are left out.
///   value   what the first three channels of the strokes get; a fourth channel is not changed
void write_text(Image& image, int x, int y, int scale, std::string_view text, float value);

}  // namespace etak
