// SPDX-License-Identifier: Apache-2.0
#include "core/render/backdrop.h"

#include <algorithm>
#include <cmath>

#include "core/math/functions.h"
#include "core/render/mesh/mesh_shape.h"

namespace etak {
namespace {
namespace f64 {
#include "core/math/real_f64.h"

#include "core/light/ground.glsl"
}  // namespace f64

// Tangent of half the field of view of 30 degrees, which the picture's height of 2.2 radii fills.
constexpr double slope_of_view = 0.2679491924311227 / 1.1;

}  // namespace

BackdropRays::BackdropRays(const Camera& camera)
    : distance(camera.perspective() ? camera.distance() : 1 / slope_of_view),
      slope(camera.perspective() ? camera.spread() : slope_of_view) {}

SceneBackdrop::SceneBackdrop(const Scene& scene, const Environment* environment, const Camera& camera)
    : color_(scene.background),
      axes_(camera.axes()),
      rays_(camera),
      turn_(scene.environment_turn_deg),
      ground_(scene.backdrop.ground && scene.shape == Shape::sphere),
      mesh_(scene.mesh.get()) {
  // Parallel rays see the foot of a mesh where its middle is, and those of the backdrop, which part, its front nearer by.
  // The shadow is moved, so that it begins where the foot ends.
  if (ground_ && mesh_ != nullptr && !camera.perspective()) {
    const Vec3& back = axes_[2];
    const double reach = mesh_->foot_reach({back[0], 0, back[2]});
    const double length = std::max(math::hypot(back[0], back[2]), 1e-9);
    shift_ = {back[0] / length * reach, back[2] / length * reach};
  }
  if (scene.backdrop.environment && environment != nullptr) seen_ = environment->blurred(scene.backdrop.blur);
}

Vec3 SceneBackdrop::at(double x, double y) const {
  if (is_plain()) return color_;
  const auto& [right, up, back] = axes_;
  const double a = x * rays_.slope, b = y * rays_.slope, length = std::sqrt(a * a + b * b + 1);
  Vec3 sight{}, eye{};
  for (std::size_t i = 0; i < 3; ++i) {
    sight[i] = (right[i] * a + up[i] * b - back[i]) / length;
    eye[i] = back[i] * rays_.distance;
  }
  const Vec3 seen = seen_ ? seen_->at(turn_.to_map(sight)) : color_;
  if (!ground_) return seen;
  if (mesh_ != nullptr) {
    const double above = eye[1] - mesh_->ground();
    if (!(sight[1] < 0) || !(above > 0)) return seen;
    const double t = above / std::max(-sight[1], 1e-4);
    return scaled(seen,
                  mesh_->ground_light(eye[0] + sight[0] * t + shift_[0], eye[2] + sight[2] * t + shift_[1]));
  }
  return scaled(seen, f64::ground_light({eye[0], eye[1], eye[2]}, {sight[0], sight[1], sight[2]}));
}

}  // namespace etak
