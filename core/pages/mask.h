// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/image/image.h"

namespace etak {

/// Shows on a picture which texels a region rule has found: plateau texels red with slanted stripes,
/// transition texels yellow with dots (the patterns differ for readers who see no colour), all others at 25 %
/// of their codes.
///   picture   1, 3 or 4 channels; the fourth (opacity or gloss) is left out
///   marks     one channel of the same size: 0 nothing, 1 transition, 2 plateau (region_picture in
///             core/judge/engine.h)
///   returns   RGB
Image8 mask_picture(const Image8& picture, const Image8& marks);

/// Marks for a finding that has a box but no region: every texel in the box is 2, all others 0.
Image8 box_marks(int width, int height, int x, int y, int box_width, int box_height);

}  // namespace etak
