// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

namespace etak {

using Uv = std::array<double, 2>;

/// uv' = translation * rotation * scale * uv, as KHR_texture_transform defines it:
///   u' = offset_u + cos(rotation) scale_u u + sin(rotation) scale_v v
///   v' = offset_v - sin(rotation) scale_u u + cos(rotation) scale_v v
/// (0, 0) is the left upper corner of the picture, so v points down and this is counter-clockwise to the eye.
///   from   the extension's text and its first example (offset 0 1, rotation pi/2, scale 1/2: "the lower left
///          quadrant"); its GLSL snippet, read with columns first, turns the other way and misses that
///          quadrant
struct UvTransform {
  std::array<double, 2> offset{0, 0}, scale{1, 1};
  double rotation = 0;  // radians
  friend bool operator==(const UvTransform&, const UvTransform&) = default;
};

/// The transform as numbers: u' = m[0] u + m[1] v + m[2], v' = m[3] u + m[4] v + m[5]. Quarter turns are
/// exact.
using UvMatrix = std::array<double, 6>;
UvMatrix uv_matrix(const UvTransform& transform);

constexpr Uv operator*(const UvMatrix& m, const Uv& uv) {
  return {m[0] * uv[0] + m[1] * uv[1] + m[2], m[3] * uv[0] + m[4] * uv[1] + m[5]};
}
/// First b, then a.
UvMatrix operator*(const UvMatrix& a, const UvMatrix& b);

Uv transformed(const UvTransform& transform, const Uv& uv);

/// First `inner`, then `outer`; none when the two make a shear, which no such transform can say (a turn by
/// other than quarter turns under unequal scales).
std::optional<UvTransform> composed(const UvTransform& outer, const UvTransform& inner);

/// Where a box of a texture was placed on a page.
///   box, texture_width, texture_height   x, y, width, height of the box in texels, and the size of the
///                                        texture that it is a part of
///   place, page_width, page_height       x, y, width, height of what the box takes on the page, and the
///                                        size of the page
///   rotated                              the box was turned clockwise by a quarter: its texel (i, j) lies
///                                        in column place.x + place.width - 1 - j and row place.y + i, and
///                                        place.width is the box's height
/// The sizes of `box` and `place` may differ (the box was scaled).
struct PlacedBox {
  std::array<int, 4> box{};
  int texture_width = 0, texture_height = 0;
  std::array<int, 4> place{};
  bool rotated = false;
  int page_width = 0, page_height = 0;
};

/// From the UVs of the texture to those of the page.
UvTransform region_transform(const PlacedBox& of);

}  // namespace etak
