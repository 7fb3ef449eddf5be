// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "core/image/image.h"
#include "core/image/pixels_view.h"

namespace etak {

// Texels that are not used themselves but that filtering reads: the gutter around a region, and the texels of
// alpha 0. They are filled from the texels in use, so that no foreign colour bleeds in.

/// Gives each texel of `cell` outside of `box` the value of the nearest texel of `box`, in all channels: the
/// edges and corners of the box are repeated. The box must lie inside the cell, and the cell inside the page.
///   Value   std::uint8_t or float
template <class Value>
void replicate_edges(const PixelsViewOf<Value>& page, const PixelBox& box, const PixelBox& cell);

/// Fills the texels whose alpha (the fourth channel of `a`) is 0: the three colour channels of `a`, and all
/// channels of `b` if it has data.
///
/// The method is pull-push with this rule: a texel is visible where its alpha is above 0. A block of level
/// l + 1 covers up to 2 x 2 blocks of level l and is visible where one of them is; its value is the plain
/// mean of the visible ones, colours in linear light and gloss as 1/e. Each texel that is not visible gets
/// the value of the smallest visible block around it, rounded half up. Blocks start at even columns and rows.
/// Texels are neither weighted by alpha nor blurred, so that the filled texels form flat squares, which
/// compress well.
///
/// Visible texels do not change, and a picture without visible texels does not change at all. Since alpha
/// stays, filling a second time changes nothing.
///   Value     std::uint8_t; or float, with colours in linear light, which may lie outside of 0..1 and are
///             not rounded
///   a, b      4 channels, of one size; b.data may be null
///   returns   how many texels were filled
template <class Value>
std::size_t bleed_under_alpha(const PixelsViewOf<Value>& a, const PixelsViewOf<Value>& b);
template <class Value>
std::size_t bleed_under_alpha(Pixels<Value>& a, Pixels<Value>& b) {
  return bleed_under_alpha(view(a), view(b));
}

}  // namespace etak
