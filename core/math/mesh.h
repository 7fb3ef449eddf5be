// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/math/mat3.h"

namespace etak {

/// Triangles with a normal and a UV at each vertex, for a picture of a shape of one's own.
struct Mesh {
  /// A corner of triangles.
  ///   normal   of length 1; to which side it points does not matter
  ///   uv       from the top left corner of a texture
  struct Vertex {
    std::array<float, 3> position, normal;
    std::array<float, 2> uv{};
  };
  std::vector<Vertex> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  bool has_uvs = true;
};

constexpr Vec3 widened(const std::array<float, 3>& v) {
  return {double{v[0]}, double{v[1]}, double{v[2]}};
}

constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace etak
