// SPDX-License-Identifier: Apache-2.0
#include "core/render/camera.h"

#include <algorithm>
#include <cmath>

namespace etak {

Camera::Camera(const Scene& scene)
    : shape_(scene.shape),
      perspective_(scene.perspective),
      width_(scene.width),
      pixel_(2.2 / scene.height),
      half_width_(scene.width / 2.0),
      half_height_(scene.height / 2.0) {
  if (!perspective_) return;
  spread_ = std::tan(scene.field_of_view_deg / 2 * (3.14159265358979323846 / 180)) / 1.1;
  distance_ = std::sqrt(1 + 1 / (spread_ * spread_));
  side_ = 1 / (spread_ * distance_);
}

Camera::Span Camera::covered(int row) const {
  const double at = std::abs(y(row + 0.5));
  // Coverage ends half a pixel outside the edge.
  const double reach = shape_ == Shape::sphere ? 1 + pixel_ / 2 : side_ + pixel_ / 2;
  if (at >= reach) return {0, 0};
  const double half = shape_ == Shape::sphere ? std::sqrt(reach * reach - at * at) : reach;
  const double first = std::floor(half_width_ - half / pixel_ - 0.5),
               last = std::ceil(half_width_ + half / pixel_ + 0.5);
  return {static_cast<int>(std::clamp(first, 0.0, double(width_))),
          static_cast<int>(std::clamp(last, 0.0, double(width_)))};
}

Camera::Span Camera::whole(int row) const {
  const double at = std::abs(y(row + 0.5));
  const double limit =
      shape_ == Shape::sphere ? std::min(silhouette_limit, 1 - pixel_ / 2) : side_ - pixel_ / 2;
  if (at > limit) return {0, 0};
  const double half = shape_ == Shape::sphere ? std::sqrt(limit * limit - at * at) : limit;
  const double first = std::ceil(half_width_ - half / pixel_ - 0.5),
               last = std::floor(half_width_ + half / pixel_ - 0.5) + 1;
  const int from = static_cast<int>(std::clamp(first, 0.0, double(width_)));
  return {from, std::max(from, static_cast<int>(std::clamp(last, 0.0, double(width_))))};
}

double Camera::coverage(double x, double y) const {
  const auto inside = [&](double margin) { return std::clamp(0.5 + margin / pixel_, 0.0, 1.0); };
  if (shape_ == Shape::sphere) return inside(1 - std::sqrt(x * x + y * y));
  return inside(side_ - std::abs(x)) * inside(side_ - std::abs(y));
}

bool Camera::meets(double x, double y) const {
  return shape_ == Shape::sphere ? x * x + y * y < 1 : std::abs(x) < side_ && std::abs(y) < side_;
}

Camera::Sight Camera::sight(double x, double y) const {
  if (shape_ == Shape::sphere) {
    const double scale = std::min(1.0, silhouette_limit / std::max(std::sqrt(x * x + y * y), 1e-6));
    x *= scale;
    y *= scale;
    const double r2 = x * x + y * y;
    const double depth = std::sqrt((1 - std::sqrt(r2)) * (1 + std::sqrt(r2)));
    if (!perspective_) return {{x, y, depth}, {0, 0, 1}};
    // Along (x spread, y spread, -1) from the camera; the root of the discriminant is `depth`.
    const double t = (distance_ - depth) / (1 + r2 * spread_ * spread_);
    const double length = std::sqrt(1 + r2 * spread_ * spread_);
    return {{x * spread_ * t, y * spread_ * t, distance_ - t},
            {-x * spread_ / length, -y * spread_ / length, 1 / length}};
  }
  const double limit = side_;
  x = std::clamp(x, -limit, limit);
  y = std::clamp(y, -limit, limit);
  if (!perspective_) return {{x, y, 0}, {0, 0, 1}};
  const double length = std::sqrt(1 + (x * x + y * y) * spread_ * spread_);
  return {{x * spread_ * distance_, y * spread_ * distance_, 0},
          {-x * spread_ / length, -y * spread_ / length, 1 / length}};
}

}  // namespace etak
