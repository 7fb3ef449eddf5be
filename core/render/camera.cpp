// SPDX-License-Identifier: Apache-2.0
#include "core/render/camera.h"

#include <algorithm>
#include <cmath>

#include "core/math/functions.h"

namespace etak {

Mat3 camera_axes(const View& view) {
  constexpr double degree = 3.14159265358979323846 / 180;
  const double ct = math::cos(view.turn_deg * degree), st = math::sin(view.turn_deg * degree),
               cr = math::cos(view.rise_deg * degree), sr = math::sin(view.rise_deg * degree);
  return {{{ct, 0, -st}, {-st * sr, cr, -ct * sr}, {st * cr, sr, ct * cr}}};
}

Camera::Camera(const Scene& scene)
    : shape_(scene.shape),
      perspective_(scene.perspective),
      width_(scene.width),
      pixel_(2.2 / scene.height),
      centre_column_(scene.width / 2.0),
      centre_row_(scene.height / 2.0) {
  if (perspective_) {
    spread_ = math::tan(scene.field_of_view_deg / 2 * (3.14159265358979323846 / 180)) / 1.1;
    distance_ = std::sqrt(1 + 1 / (spread_ * spread_));
    side_ = 1 / (spread_ * distance_);
  }
  if (!scene.view) return;
  pixel_ /= scene.view->zoom;
  centre_column_ -= scene.view->pan_x / pixel_;
  centre_row_ += scene.view->pan_y / pixel_;
  turned_ = scene.view->turn_deg != 0 || scene.view->rise_deg != 0;
  axes_ = camera_axes(*scene.view);
  const auto& [right, up, back] = axes_;
  // The map from a place in the picture along its ray to the plane z = 0, in homogeneous coordinates.
  if (!perspective_) {
    for (std::size_t i = 0; i < 2; ++i)
      plane_[i] = {right[i] * back[2] - right[2] * back[i], up[i] * back[2] - up[2] * back[i], 0};
    plane_[2] = {0, 0, back[2]};
  } else {
    // The ray starts at distance * back and has the direction (x spread) right + (y spread) up - back.
    for (std::size_t i = 0; i < 2; ++i)
      plane_[i] = {distance_ * spread_ * (back[2] * right[i] - back[i] * right[2]),
                   distance_ * spread_ * (back[2] * up[i] - back[i] * up[2]), 0};
    plane_[2] = {-spread_ * right[2], -spread_ * up[2], back[2]};
  }
  if (back[2] < 0)
    for (Vec3& row : plane_)
      for (double& each : row) each = -each;
}

Vec3 Camera::out_of(const Vec3& seen) const {
  Vec3 out{};
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = seen[0] * axes_[0][i] + seen[1] * axes_[1][i] + seen[2] * axes_[2][i];
  return out;
}

Vec3 Camera::on_plane(double x, double y) const {
  return plane_ * Vec3{x, y, 1};
}

Camera::Span Camera::covered(int row) const {
  if (shape_ == Shape::quad && turned_) {
    // A turned square reaches no farther than its corners. In perspective it may be anywhere in the picture.
    const double reach = std::sqrt(2.0) + pixel_;
    if (perspective_) return {0, width_};
    if (std::abs(y(row + 0.5)) >= reach) return {0, 0};
    return {static_cast<int>(std::clamp(std::floor(centre_column_ - reach / pixel_), 0.0, double(width_))),
            static_cast<int>(std::clamp(std::ceil(centre_column_ + reach / pixel_), 0.0, double(width_)))};
  }
  const double at = std::abs(y(row + 0.5));
  // Pixels are covered in part up to half a pixel outside of the edge.
  const double reach = shape_ == Shape::sphere ? 1 + pixel_ / 2 : side_ + pixel_ / 2;
  if (at >= reach) return {0, 0};
  const double half = shape_ == Shape::sphere ? std::sqrt(reach * reach - at * at) : reach;
  const double first = std::floor(centre_column_ - half / pixel_ - 0.5),
               last = std::ceil(centre_column_ + half / pixel_ + 0.5);
  return {static_cast<int>(std::clamp(first, 0.0, double(width_))),
          static_cast<int>(std::clamp(last, 0.0, double(width_)))};
}

Camera::Span Camera::whole(int row) const {
  const double at = std::abs(y(row + 0.5));
  if (shape_ == Shape::quad && turned_) return {0, 0};
  const double limit =
      shape_ == Shape::sphere ? std::min(silhouette_limit, 1 - pixel_ / 2) : side_ - pixel_ / 2;
  if (at > limit) return {0, 0};
  const double half = shape_ == Shape::sphere ? std::sqrt(limit * limit - at * at) : limit;
  const double first = std::ceil(centre_column_ - half / pixel_ - 0.5),
               last = std::floor(centre_column_ + half / pixel_ - 0.5) + 1;
  const int from = static_cast<int>(std::clamp(first, 0.0, double(width_)));
  return {from, std::max(from, static_cast<int>(std::clamp(last, 0.0, double(width_))))};
}

double Camera::coverage(double x, double y) const {
  const auto inside = [&](double margin) { return std::clamp(0.5 + margin / pixel_, 0.0, 1.0); };
  if (shape_ == Shape::sphere) return inside(1 - std::sqrt(x * x + y * y));
  if (!turned_) return inside(side_ - std::abs(x)) * inside(side_ - std::abs(y));
  const Vec3 at = on_plane(x, y);
  if (std::abs(axes_[2][2]) < least_facing || at[2] <= 1e-6) return 0;
  double share = 1;
  for (std::size_t i = 0; i < 2; ++i) {
    // The distance to the edge in the picture, from the gradient of the place on the square over the picture.
    const double place = at[i] / at[2];
    const double slope =
        math::hypot(plane_[i][0] - place * plane_[2][0], plane_[i][1] - place * plane_[2][1]);
    share *= inside((1 - std::abs(place)) * at[2] / std::max(slope, 1e-6));
  }
  return share;
}

bool Camera::meets(double x, double y) const {
  if (shape_ == Shape::sphere) return x * x + y * y < 1;
  if (!turned_) return std::abs(x) < side_ && std::abs(y) < side_;
  const Vec3 at = on_plane(x, y);
  return std::abs(axes_[2][2]) >= least_facing && at[2] > 1e-6 && std::abs(at[0]) < at[2] &&
         std::abs(at[1]) < at[2];
}

Camera::Sight Camera::sight(double x, double y) const {
  if (shape_ == Shape::sphere) {
    const double scale = std::min(1.0, silhouette_limit / std::max(std::sqrt(x * x + y * y), 1e-6));
    x *= scale;
    y *= scale;
    const double r2 = x * x + y * y;
    const double depth = std::sqrt((1 - std::sqrt(r2)) * (1 + std::sqrt(r2)));
    Vec3 place{x, y, depth}, viewer{0, 0, 1};
    if (perspective_) {
      // The ray from the camera has the direction (x spread, y spread, -1); the root of the discriminant is
      // `depth`.
      const double t = (distance_ - depth) / (1 + r2 * spread_ * spread_);
      const double length = std::sqrt(1 + r2 * spread_ * spread_);
      place = {x * spread_ * t, y * spread_ * t, distance_ - t};
      viewer = {-x * spread_ / length, -y * spread_ / length, 1 / length};
    }
    if (!turned_) return {place, viewer, place};
    const Vec3 turned = out_of(place);
    return {turned, out_of(viewer), turned};
  }
  if (turned_) {
    const Vec3 at = on_plane(x, y);
    const double depth = std::max(at[2], 1e-6);
    const Vec3 place{std::clamp(at[0] / depth, -1.0, 1.0), std::clamp(at[1] / depth, -1.0, 1.0), 0};
    Vec3 viewer = axes_[2];
    if (perspective_) {
      for (std::size_t i = 0; i < 3; ++i) viewer[i] = viewer[i] * distance_ - place[i];
      const double length = std::sqrt(viewer[0] * viewer[0] + viewer[1] * viewer[1] + viewer[2] * viewer[2]);
      for (double& each : viewer) each /= length;
    }
    return {place, viewer, {0, 0, facing()}};
  }
  const double limit = side_;
  x = std::clamp(x, -limit, limit);
  y = std::clamp(y, -limit, limit);
  if (!perspective_) return {{x, y, 0}, {0, 0, 1}, {0, 0, 1}};
  const double length = std::sqrt(1 + (x * x + y * y) * spread_ * spread_);
  return {{x * spread_ * distance_, y * spread_ * distance_, 0},
          {-x * spread_ / length, -y * spread_ / length, 1 / length},
          {0, 0, 1}};
}

}  // namespace etak
