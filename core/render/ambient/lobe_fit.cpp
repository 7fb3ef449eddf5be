// SPDX-License-Identifier: Apache-2.0
#include "core/render/ambient/lobe_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/math/functions.h"
#include "core/math/solve.h"
#include "core/render/ambient/round_lobe.h"

namespace etak {
namespace {

// The planes lie at these tangents of the angle from the lobe's middle, on both sides.
constexpr std::size_t planes = 14;
constexpr double first_tangent = 0.004, next_tangent = 1.6;

// The light of a lobe beyond the planes, and where the lobe's middle is.
struct LobeShares {
  double middle = 0, total = 0;
  std::array<double, 2 * planes> along{};  // beyond planes at +angle, then at -angle
  std::array<double, planes> across{};     // beyond planes at +angle
};

const std::array<double, planes>& plane_angles() {
  static const auto angles = [] {
    std::array<double, planes> out{};
    for (std::size_t i = 0; i < planes; ++i)
      out[i] = math::atan(first_tangent * math::pow(next_tangent, double(i)));
    return out;
  }();
  return angles;
}

// How many of the planes at one side are passed at a tangent.
std::size_t passed(float tangent, bool behind) {
  if (behind) return planes;
  if (!(tangent > float(first_tangent))) return 0;
  static const float scale = 1 / math::log2(float(next_tangent));
  const float at = (math::log2(tangent) - math::log2(float(first_tangent))) * scale;
  return std::min(planes, static_cast<std::size_t>(at) + 1);
}

LobeShares shares_of(std::span<const LobeSample> samples) {
  LobeShares out;
  for (const LobeSample& s : samples) out.total += double(s.weight);
  if (!(out.total > 0)) return out;
  // The middle is where the sum of the distances is least (Weiszfeld's iteration): near the peak of a skewed lobe, on
  // which a mean would not lie.
  float x = 0, z = 0, nearest = 2;
  for (int round = 0; round < 4; ++round) {
    float along = 0, up = 0;
    for (const LobeSample& s : samples) {
      const float dx = s.along - x, dz = s.up - z;
      const float weight = s.weight / std::max(std::sqrt(dx * dx + dz * dz + s.across * s.across), nearest);
      along += weight * s.along;
      up += weight * s.up;
    }
    out.middle = math::atan2(double(along), double(up));
    x = float(math::sin(out.middle));
    z = float(math::cos(out.middle));
    nearest = 0.02f;
  }
  const float c = float(math::cos(out.middle)), sine = float(math::sin(out.middle));
  std::array<std::array<double, planes + 1>, 3> bins{};
  for (const LobeSample& s : samples) {
    if (!(s.weight > 0)) continue;
    const float off = s.along * c - s.up * sine, on = s.along * sine + s.up * c;
    const bool behind = !(on > 0);
    const float inverse = behind ? 0 : 1 / on;
    bins[off < 0 ? 1 : 0][passed(std::abs(off) * inverse, behind)] += double(s.weight);
    bins[2][passed(std::abs(s.across) * inverse, behind)] += double(s.weight);
  }
  double beyond[3] = {0, 0, 0};
  for (std::size_t i = planes; i-- > 0;) {
    for (std::size_t side = 0; side < 3; ++side) beyond[side] += bins[side][i + 1] / out.total;
    out.along[i] = beyond[0];
    out.along[planes + i] = beyond[1];
    out.across[i] = beyond[2] / 2;
  }
  return out;
}

constexpr std::size_t unknowns = 3 * probe_count - 1;
constexpr std::size_t rows = 3 * planes + unknowns;
using Unknowns = std::array<double, unknowns>;
using Residuals = std::array<double, rows>;

// Angles, then levels, then the shares of all probes but the last.
Probes probes_of(const Unknowns& x) {
  Probes out;
  out.back().share = 1;
  for (std::size_t k = 0; k < probe_count; ++k) {
    out[k].angle = x[k];
    out[k].level = x[probe_count + k];
    if (k + 1 == probe_count) break;
    out[k].share = x[2 * probe_count + k];
    out.back().share -= out[k].share;
  }
  return out;
}

Unknowns unknowns_of(const Probes& probes) {
  Unknowns out{};
  for (std::size_t k = 0; k < probe_count; ++k) {
    out[k] = probes[k].angle;
    out[probe_count + k] = probes[k].level;
    if (k + 1 < probe_count) out[2 * probe_count + k] = probes[k].share;
  }
  return out;
}

// A probe without a share would have no slope that brings it back.
constexpr double least_share = 0.15;

// Far from the start costs a little, so that an unknown that the lobe does not decide stays where it is.
constexpr double hold = 0.01;
double scale_of(std::size_t i) {
  return i < probe_count ? 0.2 : i < 2 * probe_count ? 1 : 0.3;
}

Residuals residuals(const LobeShares& lobe, const Unknowns& x, const Unknowns& start) {
  const Probes probes = probes_of(x);
  const auto& angles = plane_angles();
  Residuals out{};
  for (std::size_t i = 0; i < planes; ++i) {
    double up = 0, down = 0, across = 0;
    for (const Probe& p : probes) {
      const double off = p.angle - lobe.middle;
      up += p.share * share_beyond(p.level, off - angles[i]);
      down += p.share * share_beyond(p.level, -off - angles[i]);
      across += p.share * share_beyond(p.level, -math::asin(math::sin(angles[i]) * math::cos(off)));
    }
    out[i] = up - lobe.along[i];
    out[planes + i] = down - lobe.along[planes + i];
    out[2 * planes + i] = std::numbers::sqrt2 * (across - lobe.across[i]);
  }
  for (std::size_t i = 0; i < unknowns; ++i) out[3 * planes + i] = hold * (x[i] - start[i]) / scale_of(i);
  return out;
}

double squares(const Residuals& r) {
  double out = 0;
  for (const double each : r) out += each * each;
  return out;
}

void keep_in_range(Unknowns& x, double sharpest) {
  double left = 1;
  for (std::size_t k = 0; k < probe_count; ++k) {
    x[k] = std::clamp(x[k], -std::numbers::pi / 2, std::numbers::pi / 2);
    x[probe_count + k] = std::clamp(x[probe_count + k], sharpest, double(lobe_levels - 1));
    if (k + 1 == probe_count) break;
    double& share = x[2 * probe_count + k];
    share = std::clamp(share, least_share, left - least_share * double(probe_count - 1 - k));
    left -= share;
  }
}

// The probes around the level that is closest to the lobe alone.
Unknowns one_level(const LobeShares& lobe) {
  const auto at = [&](double level, double apart) {
    Probes probes;
    for (std::size_t k = 0; k < probe_count; ++k)
      probes[k] = {lobe.middle, level + apart * (double(k) - 0.5 * (probe_count - 1)), 1.0 / probe_count};
    Unknowns out = unknowns_of(probes);
    keep_in_range(out, 0);
    return out;
  };
  double best = 0, least = 1e300;
  for (double level = 0; level <= lobe_levels - 1; level += 0.5) {
    const Unknowns x = at(level, 0);
    const double off = squares(residuals(lobe, x, x));
    if (off < least) best = level;
    least = std::min(off, least);
  }
  return at(best, 1.5);
}

// The closest unknowns near `first`, by Levenberg and Marquardt's method.
Unknowns closest(const LobeShares& lobe, Unknowns first, double sharpest) {
  keep_in_range(first, sharpest);
  Unknowns x = first;
  Residuals r = residuals(lobe, x, first);
  double damping = 1e-3;
  for (int round = 0; round < 6; ++round) {
    std::array<Residuals, unknowns> slopes;
    for (std::size_t i = 0; i < unknowns; ++i) {
      Unknowns moved = x;
      const double step =
          0.02 * scale_of(i) * (i >= probe_count && i < 2 * probe_count && x[i] > 7.9 ? -1 : 1);
      moved[i] += step;
      slopes[i] = residuals(lobe, moved, first);
      for (std::size_t row = 0; row < rows; ++row) slopes[i][row] = (slopes[i][row] - r[row]) / step;
    }
    std::array<Unknowns, unknowns> normal{};
    Unknowns right{};
    for (std::size_t i = 0; i < unknowns; ++i) {
      for (std::size_t j = 0; j < unknowns; ++j)
        for (std::size_t row = 0; row < rows; ++row) normal[i][j] += slopes[i][row] * slopes[j][row];
      for (std::size_t row = 0; row < rows; ++row) right[i] -= slopes[i][row] * r[row];
    }
    for (std::size_t i = 0; i < unknowns; ++i) normal[i][i] *= 1 + damping;
    solve_definite(normal, right, unknowns);
    Unknowns next = x;
    for (std::size_t i = 0; i < unknowns; ++i) next[i] += right[i];
    keep_in_range(next, sharpest);
    const Residuals better = residuals(lobe, next, first);
    if (squares(better) < squares(r)) {
      x = next;
      r = better;
      damping = std::max(damping / 5, 1e-6);
    } else {
      damping *= 10;
    }
  }
  return x;
}

}  // namespace

Probes fitted_probes(std::span<const LobeSample> samples, const Probes* before, double angle,
                     double sharpest) {
  const LobeShares lobe = shares_of(samples);
  Probes start = before != nullptr ? *before : Probes{};
  if (!(lobe.total > 0)) {
    for (Probe& each : start) each = {angle, each.level, 1.0 / probe_count};
    return start;
  }
  if (before == nullptr) {
    start = probes_of(one_level(lobe));
  } else {
    // Probes move with the lobe from one view to the next.
    double middle = 0;
    for (const Probe& p : start) middle += p.share * p.angle;
    for (Probe& p : start) p.angle += lobe.middle - middle;
  }
  return probes_of(closest(lobe, unknowns_of(start), sharpest));
}

}  // namespace etak
