// SPDX-License-Identifier: Apache-2.0
#include "core/render/backdrop.h"

#include <cmath>

#include "core/math/functions.h"

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
      ground_(scene.backdrop.ground && scene.shape == Shape::sphere) {
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
  return scaled(seen, f64::ground_light({eye[0], eye[1], eye[2]}, {sight[0], sight[1], sight[2]}));
}

}  // namespace etak
