// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "core/image/image.h"
#include "core/image/pixels_view.h"

namespace etak {

// What lies around and under the texels in use, so that filtering finds nothing foreign.

/// Texels of `cell` outside of `box` become those of `box` that are nearest (edges and corners repeated).
/// `box` lies in `cell`, and `cell` in the page. All channels.
///   Value   std::uint8_t or float
template <class Value>
void replicate_edges(const PixelsViewOf<Value>& page, const PixelBox& box, const PixelBox& cell);

/// Fills texels of alpha 0 (the fourth channel of `a`) in all channels of A but alpha, and in B, if B has
/// data.
///
/// Pull-push with this rule: a texel is visible where alpha is above 0. A block of level l + 1 covers up to
/// 2 x 2 of level l and is visible where one of them is; its value is the plain mean of the visible ones,
/// colours in linear light and gloss as 1/e. Each texel that is not visible gets the value of the smallest
/// block around it that is, rounded half up. Blocks lie at even columns and rows; texels are neither weighted
/// by alpha nor blurred, so that what is filled stays in flat squares, which compress well.
///
/// Visible texels do not change; nothing changes where none is visible. Idempotent as alpha stays.
///   Value     std::uint8_t, or float: colours in linear light, which may lie outside of 0..1; nothing is
///             rounded
///   a, b      4 channels, of one size; b.data may be null
///   returns   how many texels were filled
template <class Value>
std::size_t bleed_under_alpha(const PixelsViewOf<Value>& a, const PixelsViewOf<Value>& b);
template <class Value>
std::size_t bleed_under_alpha(Pixels<Value>& a, Pixels<Value>& b) {
  return bleed_under_alpha(view(a), view(b));
}

}  // namespace etak
