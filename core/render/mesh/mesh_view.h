// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/render/camera.h"
#include "core/render/mesh/mesh_shape.h"

namespace etak {

/// What pixels see of a mesh. A pixel has 4 x 4 samples; those of one surface are shaded once, at their mean.
class MeshView {
 public:
  /// A part of a surface in one pixel, in the space of the scene. The normal is that of the side that is seen; one that
  /// leans away from the viewer, as at the rim of a coarse mesh, is bent until it faces the camera as the ball's rim does.
  struct Fragment {
    int column;
    double share;  // of the pixel, (0, 1]
    Vec3 position, normal, viewer;
    std::array<double, 2> uv;
    Vec3 tangent, bitangent;  // where u grows and where v falls, of length 1 beside the normal; 0 without UVs
    double open;              // share of light from all around that reaches it
  };
  /// The memory of one thread.
  struct Samples {
    std::vector<float> depth;  // towards the camera; -2: nothing is seen
    std::vector<std::uint32_t> triangle;
    std::vector<std::array<float, 2>> place;  // the shares of the triangle's second and third vertex
    std::vector<Fragment> fragments;          // of the last row that was asked for, by column
  };

  MeshView(const MeshShape& shape, const Camera& camera, int width, int height);

  /// Fills the fragments of a row of pixels.
  void see(int row, Samples& samples) const;

 private:
  void cover(int row, std::uint32_t triangle, Samples& samples) const;
  void gather(int column, Samples& samples) const;

  const MeshShape& shape_;
  const Mesh& mesh_;
  const Camera& camera_;
  int width_;
  // The place of each vertex in the picture in homogeneous coordinates, and how far it is towards the camera.
  std::vector<Vec3> seen_;
  std::vector<float> near_;
  std::vector<std::size_t> first_;      // of each row and its end: where its triangles begin
  std::vector<std::uint32_t> of_rows_;  // triangles, row by row
};

}  // namespace etak
