// SPDX-License-Identifier: Apache-2.0
#include "core/render/ambient/round_lobe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/color/gloss.h"
#include "core/math/functions.h"

namespace etak {
namespace {

using std::numbers::pi;
constexpr std::size_t share_steps = 64;

// The shares of a whole level over the angles from 0 to pi / 2; those of negative angles are the complement. The steps
// are even in angle / (angle + width), so that they are narrow where the lobe is.
struct Shares {
  double width = 1;
  std::array<double, share_steps + 2> values{};

  double at(double angle) const {
    const double away = std::abs(angle), place = away / (away + width) * scale();
    const auto i = static_cast<std::size_t>(place);
    const double share = values[i] + (values[i + 1] - values[i]) * (place - static_cast<double>(i));
    return angle < 0 ? 1 - share : share;
  }
  double scale() const { return static_cast<double>(share_steps) * (pi / 2 + width) / (pi / 2); }
};

Shares shares_of(int level) {
  constexpr int rings = 600;
  const double e = exponent_of_gloss(gloss_of_level(level));
  Shares out;
  out.width = 2 / std::sqrt(e + 2);
  double total = 0;
  std::array<double, share_steps + 1> sums{};
  for (int i = 0; i < rings; ++i) {
    // Rings around the axis, densest near to it.
    const double t = (i + 0.5) / rings, away = pi / 2 * t * t * t;
    const double weight = round_lobe(e, math::cos(away)) * math::sin(away) * t * t;
    total += weight;
    for (std::size_t j = 0; j <= share_steps; ++j) {
      const double u = static_cast<double>(j) / out.scale();
      const double angle = std::min(u / (1 - u) * out.width, pi / 2 - 1e-9);
      sums[j] += weight * math::acos(std::clamp(-math::tan(angle) / math::tan(away), -1.0, 1.0)) / pi;
    }
  }
  for (std::size_t j = 0; j <= share_steps; ++j) out.values[j] = sums[j] / total;
  out.values[share_steps + 1] = 1;
  return out;
}

}  // namespace

double round_lobe(double e, double c) {
  return c > 0 ? math::exp2((e / 2 - 1) * math::log2((1 + c) / 2)) * c : 0;
}

double share_beyond(double level, double angle) {
  static const auto levels = [] {
    std::array<Shares, lobe_levels> out;
    for (int i = 0; i < lobe_levels; ++i) out[static_cast<std::size_t>(i)] = shares_of(i);
    return out;
  }();
  // A plane that is turned further than a right angle comes back to the axis from the other side.
  if (angle > pi / 2) angle = pi - angle;
  if (angle < -pi / 2) angle = -pi - angle;
  const auto first = std::min(static_cast<std::size_t>(level), std::size_t{lobe_levels - 2});
  const double share = level - static_cast<double>(first);
  return levels[first].at(angle) * (1 - share) + levels[first + 1].at(angle) * share;
}

}  // namespace etak
