// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/math/functions.h"

namespace etak {

/// A unit sphere of triangles, +y up, counter-clockwise from outside.
///   points     positions, which are the normals too: stacks + 1 rings of slices + 1, the first and the last
///              of a ring in one place
///   uvs        u around, v from the north pole down
struct SphereMesh {
  std::vector<std::array<float, 3>> points;
  std::vector<std::array<float, 2>> uvs;
  std::vector<std::uint16_t> triangles;
};

/// (slices + 1) (stacks + 1) must be at most 65536.
inline SphereMesh sphere_mesh(int slices, int stacks) {
  SphereMesh out;
  for (int j = 0; j <= stacks; ++j)
    for (int i = 0; i <= slices; ++i) {
      const double u = static_cast<double>(i) / slices, v = static_cast<double>(j) / stacks;
      const double phi = 2 * std::numbers::pi * u, theta = std::numbers::pi * v;
      out.points.push_back({static_cast<float>(math::sin(theta) * math::cos(phi)),
                            static_cast<float>(math::cos(theta)),
                            static_cast<float>(-math::sin(theta) * math::sin(phi))});
      out.uvs.push_back({static_cast<float>(u), static_cast<float>(v)});
    }
  const auto at = [&](int i, int j) { return static_cast<std::uint16_t>(j * (slices + 1) + i); };
  for (int j = 0; j < stacks; ++j)
    for (int i = 0; i < slices; ++i) {
      if (j > 0) out.triangles.insert(out.triangles.end(), {at(i, j), at(i, j + 1), at(i + 1, j)});
      if (j + 1 < stacks)
        out.triangles.insert(out.triangles.end(), {at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
    }
  return out;
}

}  // namespace etak
