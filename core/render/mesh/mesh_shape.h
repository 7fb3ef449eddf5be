// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/math/mat3.h"
#include "core/math/mesh.h"

namespace etak {

/// The mesh moved and scaled to the place of the ball: the middle of its box is the origin, and its farthest vertex
/// has the distance 1. Throws Error for one without triangles or size.
///   place   of the error
Mesh in_place_of_ball(Mesh mesh, const std::string& place);

/// The name that stands for shader_ball() in place of a file.
inline constexpr const char* shader_ball_name = "shader-ball";

/// A ball on a foot, with a groove around its middle and a hollow in its top: a shape of its own for looking at
/// materials. Its UVs run once around and from the bottom to the top.
Mesh shader_ball();

/// A mesh that is drawn in place of the ball, and the light that it keeps from itself and from the ground.
class MeshShape {
 public:
  /// Casts the rays of its shadows on `threads` threads; the shape is the same for any number.
  explicit MeshShape(Mesh mesh, unsigned threads = 1);

  const Mesh& mesh() const { return mesh_; }
  double ground() const { return ground_; }  // y of the lowest vertex, on which the mesh stands

  /// The share of a texture in a square of the side 1, as the mean over all triangles.
  double uv_share() const { return uv_share_; }

  /// The share of light from all around that reaches a vertex, [0, 1], weighed by the cosine to its normal.
  ///   turned   of the other side of the surface
  float open(std::size_t vertex, bool turned) const { return open_[2 * vertex + (turned ? 1 : 0)]; }

  /// How far the mesh stands on the ground, from the middle towards a direction.
  double foot_reach(const Vec3& way) const;

  /// The share of light from everywhere above that reaches a place of the ground, [0, 1].
  double ground_light(double x, double z) const;

  /// Whether triangles lie on the way from a point of the surface. Those within `nearest` do not count, since a
  /// normal between vertices is not the normal of its triangle.
  ///   way      of length 1
  ///   length   of the way, in radii of the ball
  bool hides(const Vec3& from, const Vec3& way, double length) const;
  static constexpr double nearest = 0.02;

 private:
  using Point = std::array<float, 3>;
  struct Triangle {
    Point corner, along, across;
  };
  // A box around triangles. Its first child is the next node.
  struct Node {
    Point least, most;
    std::uint32_t second = 0;            // the other child; 0: the node has triangles
    std::uint32_t first = 0, count = 0;  // of its triangles
  };
  void build(std::vector<std::uint32_t>& order, std::size_t first, std::size_t last);
  bool meets(const Vec3& from, const Vec3& way, double least, double most) const;
  double open_sky(const Vec3& from, const Vec3& normal, std::size_t rays, double least) const;

  Mesh mesh_;
  double ground_ = 0, uv_share_ = 0;
  std::vector<Node> nodes_;
  std::vector<Triangle> triangles_;
  std::vector<float> open_, ground_light_;
};

}  // namespace etak
