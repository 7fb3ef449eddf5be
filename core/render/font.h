// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "core/image/image.h"

namespace etak {

/// A character's box in write_text: 6 x 9 pixels at scale 1, strokes 5 x 7 in it.
inline constexpr int glyph_width = 6, glyph_height = 9;

/// Writes capitals, digits and "-.,/()+=:%" (small letters as capitals, others as a blank box) with the left
/// upper corner at x, y; what lies outside is left out.
///   value   for every channel but a fourth one
void write_text(Image& image, int x, int y, int scale, std::string_view text, float value);

}  // namespace etak
