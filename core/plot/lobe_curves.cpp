// SPDX-License-Identifier: Apache-2.0
#include "core/plot/lobe_curves.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace etak {

LobeCurve lobe_curve(const Model& model, std::span<const double> values, double theta_l_deg,
                     double step_deg) {
  assert(values.size() == model.value_count());
  LobeCurve out;
  out.light_deg = -theta_l_deg;
  const auto steps = static_cast<int>(std::lround(180 / step_deg));
  for (int i = 0; i <= steps; ++i) out.angle_deg.push_back(-90 + 180.0 * i / steps);
  const auto mirror = std::lower_bound(out.angle_deg.begin(), out.angle_deg.end(), theta_l_deg);
  if (mirror == out.angle_deg.end() || *mirror != theta_l_deg) out.angle_deg.insert(mirror, theta_l_deg);
  const double radian = std::numbers::pi / 180, light = theta_l_deg * radian;
  for (const double angle : out.angle_deg) {
    const double viewer = angle * radian;
    const Directions d{-std::sin(light), 0, std::cos(light), std::sin(viewer), 0, std::cos(viewer)};
    Vec3 rgb{};
    model.f64(d, values.data(), rgb.data());
    out.rgb.push_back(rgb);
  }
  return out;
}

}  // namespace etak
