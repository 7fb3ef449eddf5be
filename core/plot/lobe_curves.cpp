// SPDX-License-Identifier: Apache-2.0
#include "core/plot/lobe_curves.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "core/math/functions.h"

namespace etak {
namespace {

// Unit vectors in the plane of incidence, at angles from the normal towards the mirror side.
Directions in_plane(double light_deg, double viewer_deg) {
  const double light = light_deg * std::numbers::pi / 180, viewer = viewer_deg * std::numbers::pi / 180;
  return {math::sin(light), 0, math::cos(light), math::sin(viewer), 0, math::cos(viewer)};
}

std::vector<double> even_angles(double first_deg, double step_deg) {
  std::vector<double> out;
  const auto steps = static_cast<int>(std::lround((90 - first_deg) / step_deg));
  for (int i = 0; i <= steps; ++i) out.push_back(first_deg + (90 - first_deg) * i / steps);
  return out;
}

// The curve over the angle of the viewer, of a model or a term.
template <class Formula>
LobeCurve over_viewer(const Formula& formula, std::span<const double> values, double theta_l_deg,
                      double step_deg) {
  LobeCurve out{even_angles(-90, step_deg), {}, -theta_l_deg};
  const auto mirror = std::lower_bound(out.angle_deg.begin(), out.angle_deg.end(), theta_l_deg);
  if (mirror == out.angle_deg.end() || *mirror != theta_l_deg) out.angle_deg.insert(mirror, theta_l_deg);
  for (const double angle : out.angle_deg)
    formula.f64(in_plane(-theta_l_deg, angle), values.data(), out.rgb.emplace_back().data());
  return out;
}

}  // namespace

LobeCurve lobe_curve(const Model& model, std::span<const double> values, double theta_l_deg,
                     double step_deg) {
  assert(values.size() == model.value_count());
  return over_viewer(model, values, theta_l_deg, step_deg);
}

LobeCurve term_curve(const Term& term, std::span<const double> values, double theta_l_deg, double step_deg) {
  assert(values.size() == number_count(term.parameters));
  if (term.kind == TermKind::visibility) return over_viewer(term, values, theta_l_deg, step_deg);
  LobeCurve out{even_angles(0, step_deg), {}, 0};
  for (const double angle : out.angle_deg) {
    // F depends on the angle between light and half vector, D on that between half vector and normal.
    const double light = term.kind == TermKind::fresnel ? -angle : angle;
    term.f64(in_plane(light, angle), values.data(), out.rgb.emplace_back().data());
  }
  return out;
}

}  // namespace etak
