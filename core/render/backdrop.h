// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "core/render/camera.h"
#include "core/render/environment.h"

namespace etak {

/// The ray behind a place of the picture, in the space of the scene: eye + t sight. In perspective pictures it
/// is the camera's own; in orthographic ones that of a camera which sees the object as large, with a field of
/// view of 30 degrees. So a backdrop has a horizon, and the ground reaches the object where both touch.
struct BackdropRays {
  double distance, slope;  // sight = (x slope, y slope, -1) in the camera's axes
  explicit BackdropRays(const Camera& camera);
};

/// What is seen beside the object and through it, by the scene's Backdrop: the background's colour or the
/// environment, times the light that the ball or the mesh leaves on the ground.
class SceneBackdrop {
 public:
  ///   environment   null: none, and its colour is the background's
  SceneBackdrop(const Scene& scene, const Environment* environment, const Camera& camera);

  bool is_plain() const { return !seen_ && !ground_; }  // the background's colour everywhere
  bool shows_environment() const { return seen_.has_value(); }
  bool has_ground() const { return ground_; }

  /// The radiance at a place of the picture (Camera::x(), Camera::y()).
  Vec3 at(double x, double y) const;

 private:
  Vec3 color_;
  Mat3 axes_;
  BackdropRays rays_;
  EnvironmentTurn turn_;
  std::optional<Environment::Blurred> seen_;
  bool ground_;
  std::array<double, 2> shift_{};  // of the mesh's shadow along x and z
  const MeshShape* mesh_;          // whose shadow the ground has; null: the ball's
};

}  // namespace etak
