// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/atlas/sources/sources.h"
#include "core/atlas/texels/page_memory.h"
#include "core/image/image.h"
#include "core/image/material_pair.h"
#include "core/image/pixels_view.h"

namespace etak {

// A material's pictures in memory as codes; floats.h has them as floats.

/// The material's whole pair, from planes or function; what was clamped is added to `remarks`.
MaterialPair load_pair(const PackInput& material, std::vector<std::string>& remarks);

/// The planes of a material that has no function of its own but for a base colour.
PairPlanes planes_of(const PackInput& material);

/// Reads both textures row by row.
class PairRows {
 public:
  /// Opens the planes, which must outlive this object. Throws Error where a file is no longer as large as when it was
  /// looked at.
  ///   first   the first row, as of PlaneRows
  explicit PairRows(const PairPlanes& planes, int first = 0);
  /// The next row: 4 bytes a texel.
  void read(std::uint8_t* diffuse_alpha, std::uint8_t* specular_gloss);

 private:
  const PairPlanes* planes_;
  std::array<FileBytes, 4> files_;
  std::vector<PlaneRows> rows_;
};

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
