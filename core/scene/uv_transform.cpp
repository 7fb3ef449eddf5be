// SPDX-License-Identifier: Apache-2.0
#include "core/scene/uv_transform.h"

#include <cmath>
#include <numbers>

#include "core/math/functions.h"

namespace etak {

UvMatrix uv_matrix(const UvTransform& t) {
  double c = math::cos(t.rotation), s = math::sin(t.rotation);
  // cos(pi/2) is 6e-17 in doubles; a texel lookup should not see it.
  if (std::abs(c) < 1e-15) c = 0;
  if (std::abs(s) < 1e-15) s = 0;
  return {c * t.scale[0], s * t.scale[1], t.offset[0], -s * t.scale[0], c * t.scale[1], t.offset[1]};
}

UvMatrix operator*(const UvMatrix& a, const UvMatrix& b) {
  const Uv origin = a * Uv{b[2], b[5]};
  return {a[0] * b[0] + a[1] * b[3], a[0] * b[1] + a[1] * b[4], origin[0],
          a[3] * b[0] + a[4] * b[3], a[3] * b[1] + a[4] * b[4], origin[1]};
}

Uv transformed(const UvTransform& transform, const Uv& uv) {
  return uv_matrix(transform) * uv;
}

std::optional<UvTransform> composed(const UvTransform& outer, const UvTransform& inner) {
  UvTransform out;
  const UvMatrix m = uv_matrix(outer) * uv_matrix(inner);
  out.offset = {m[2], m[5]};
  if (outer.rotation == 0 && inner.rotation == 0) {
    out.scale = {outer.scale[0] * inner.scale[0], outer.scale[1] * inner.scale[1]};
    return out;
  }
  // The columns of the matrix are scale_u (cos, -sin) and scale_v (sin, cos).
  const double u = math::hypot(m[0], m[3]), v = math::hypot(m[1], m[4]);
  if (std::abs(m[0] * m[1] + m[3] * m[4]) > 1e-12 * u * v) return std::nullopt;
  out.rotation = u > 0 ? math::atan2(-m[3], m[0]) : math::atan2(m[1], m[4]);
  const bool mirrored = m[0] * m[4] - m[1] * m[3] < 0;
  out.scale = {u, mirrored ? -v : v};
  return out;
}

UvTransform region_transform(const PlacedBox& of) {
  const auto& [box, texture_width, texture_height, place, rotated, page_width, page_height] = of;
  const auto [bx, by, bw, bh] = box;
  const auto [px, py, pw, ph] = place;
  // Page texels per texel of the box, along the page's axes; 1 exactly where nothing was scaled.
  const double along_x = static_cast<double>(pw) / (rotated ? bh : bw);
  const double along_y = static_cast<double>(ph) / (rotated ? bw : bh);
  if (!rotated)
    return {{(px - bx * along_x) / page_width, (py - by * along_y) / page_height},
            {texture_width * along_x / page_width, texture_height * along_y / page_height},
            0};
  // Clockwise to the eye is rotation -pi/2: u' = offset - scale_v v, v' = offset + scale_u u.
  return {{(px + pw + by * along_x) / page_width, (py - bx * along_y) / page_height},
          {texture_width * along_y / page_height, texture_height * along_x / page_width},
          -std::numbers::pi / 2};
}

}  // namespace etak
