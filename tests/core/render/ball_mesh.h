// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/math/mesh.h"
#include "core/math/sphere_mesh.h"

namespace etak::test {

/// sphere_mesh() as a mesh that can be drawn.
inline Mesh ball_mesh(int slices, int stacks) {
  const SphereMesh from = sphere_mesh(slices, stacks);
  Mesh out;
  for (std::size_t i = 0; i < from.points.size(); ++i)
    out.vertices.push_back({from.points[i], from.points[i], from.uvs[i]});
  for (std::size_t i = 0; i + 2 < from.triangles.size(); i += 3)
    out.triangles.push_back({from.triangles[i], from.triangles[i + 1], from.triangles[i + 2]});
  return out;
}

}  // namespace etak::test
