// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/image/image.h"

namespace etak {

/// What a region rule means, as a picture for people: plateau red with slanted stripes, transition yellow
/// with dots (so that the two differ without colour), the rest at 25 % of its codes.
///   picture   3 or 4 channels; opacity or gloss is left out
///   marks     one channel of the same size: 0 nothing, 1 transition, 2 plateau (region_picture in
///             core/validate/engine.h)
///   returns   RGB
Image8 mask_picture(const Image8& picture, const Image8& marks);

/// Marks where a finding without a region lies: everything in its box is 2.
Image8 box_marks(int width, int height, int x, int y, int box_width, int box_height);

}  // namespace etak
