// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/functions.h"
#include "core/render/mesh/mesh_shape.h"

namespace etak {
namespace {

using Place = std::array<double, 2>;  // the distance from the axis, and the height

constexpr double ball_radius = 0.78, ball_height = 0.16, groove_radius = 0.7;

// An arc of the ball, or of another circle about the axis, between two angles above its middle.
std::vector<Place> arc(const Place& middle, double radius, double from_deg, double to_deg, int steps) {
  std::vector<Place> out;
  for (int i = 0; i <= steps; ++i) {
    const double at = std::lerp(from_deg, to_deg, double(i) / steps) * std::numbers::pi / 180;
    out.push_back({middle[0] + radius * math::cos(at), middle[1] + radius * math::sin(at)});
  }
  return out;
}

// The outline from the bottom to the top, in pieces between which the surface has an edge.
std::vector<std::vector<Place>> outline() {
  const Place middle{0, ball_height};
  const auto of_ball = [&](double deg) { return arc(middle, ball_radius, deg, deg, 1).front(); };
  const auto of_groove = [&](double deg) { return arc(middle, groove_radius, deg, deg, 1).front(); };
  std::vector<Place> foot{{0.56, -0.98}, {0.6, -0.95}};
  for (const Place& each : arc({0.56, -0.91}, 0.05, 0, 90, 8)) foot.push_back(each);
  foot.push_back({0.4, -0.84});
  for (const Place& each : arc({0.4, -0.72}, -0.12, 90, 0, 8)) foot.push_back(each);
  foot.push_back({0.27, -0.55});
  // A hollow in the top: the sphere that fills it has its middle above the ball.
  const double rim_deg = 62;
  const Place rim = of_ball(rim_deg);
  const double hollow = 0.55, down = std::sqrt(hollow * hollow - rim[0] * rim[0]);
  const double rim_angle = -std::numbers::pi / 2 + math::asin(rim[0] / hollow);
  return {{{0, -0.98}, {0.56, -0.98}},
          foot,
          arc(middle, ball_radius, -72, -9, 48),
          {of_ball(-9), of_groove(-9)},
          arc(middle, groove_radius, -9, 9, 16),
          {of_groove(9), of_ball(9)},
          arc(middle, ball_radius, 9, rim_deg, 40),
          arc({0, rim[1] + down}, hollow, rim_angle * 180 / std::numbers::pi, -90, 32)};
}

}  // namespace

Mesh shader_ball() {
  constexpr std::uint32_t around = 128;
  const std::vector<std::vector<Place>> pieces = outline();
  double whole = 0, so_far = 0;
  const auto step = [](const Place& a, const Place& b) { return math::hypot(b[0] - a[0], b[1] - a[1]); };
  for (const std::vector<Place>& piece : pieces)
    for (std::size_t i = 1; i < piece.size(); ++i) whole += step(piece[i - 1], piece[i]);
  Mesh out;
  for (const std::vector<Place>& piece : pieces) {
    const auto begin = static_cast<std::uint32_t>(out.vertices.size());
    for (std::size_t i = 0; i < piece.size(); ++i) {
      if (i > 0) so_far += step(piece[i - 1], piece[i]);
      const Place &before = piece[i == 0 ? 0 : i - 1], &behind = piece[std::min(i + 1, piece.size() - 1)];
      const double length = step(before, behind);
      const double out_by = (behind[1] - before[1]) / length, up_by = (before[0] - behind[0]) / length;
      for (std::uint32_t k = 0; k <= around; ++k) {
        const double u = double(k) / around, phi = 2 * std::numbers::pi * u;
        const double c = math::cos(phi), s = math::sin(phi), radius = piece[i][0];
        out.vertices.push_back({{float(radius * c), float(piece[i][1]), float(-radius * s)},
                                {float(out_by * c), float(up_by), float(-out_by * s)},
                                {float(u), float(1 - so_far / whole)}});
      }
    }
    for (std::uint32_t i = 0; i + 1 < piece.size(); ++i)
      for (std::uint32_t k = 0; k < around; ++k) {
        const std::uint32_t a = begin + i * (around + 1) + k, b = a + around + 1;
        out.triangles.push_back({a, a + 1, b + 1});
        out.triangles.push_back({a, b + 1, b});
      }
  }
  return in_place_of_ball(std::move(out), "shader ball");
}

}  // namespace etak
