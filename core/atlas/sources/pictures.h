// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/atlas/sources/sources.h"
#include "core/image/image.h"
#include "core/image/material_pair.h"
#include "core/image/pixels_view.h"

namespace etak {

// A material's pictures in memory as codes; floats.h has them as floats.

/// The material's whole pair, from planes or function; what was clamped is added to `remarks`.
MaterialPair load_pair(const PackInput& material, std::vector<std::string>& remarks);

/// The part of a material's normal map that belongs to a box of its pictures, RGB. Throws Error for a map of
/// another size than the pictures.
Image8 normals_of(const PackInput& material, const PixelBox& box);

/// A box of a picture.
template <class Value>
Pixels<Value> part_of(const Pixels<Value>& picture, const PixelBox& box) {
  Pixels<Value> out(box.width, box.height, picture.channels);
  paste(picture, -box.x, -box.y, out);
  return out;
}

}  // namespace etak
