// SPDX-License-Identifier: Apache-2.0
#include "core/fresnel/curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <valarray>

#include "core/color/delta_e.h"
#include "core/math/functions.h"
#include "core/math/solve.h"

namespace etak {
namespace {

namespace text {
#include "core/math/real_f64.h"

#include "core/fresnel/curve.glsl"
}  // namespace text

constexpr std::size_t count = FresnelCurve::count, samples = 64;
using Row = std::valarray<double>;

// Square roots of cosines, denser towards both ends, where a curve has no neighbours to hold it.
double root_of(std::size_t sample) {
  return (1 - math::cos(std::numbers::pi * (double(sample) + 0.5) / samples)) / 2;
}

// What each colour takes of each sample: the solution of the normal equations. Grazing and normal incidence, which
// everybody looks at, weigh ten times as much as the others.
std::array<Row, count> shares_of_samples() {
  std::array<Row, count> shares;
  shares.fill(Row(samples));
  std::array<std::array<double, count>, count> normal{};
  for (std::size_t m = 0; m < samples; ++m) {
    const double x = 1 + 13 * root_of(m), weight = m == 0 || m + 1 == samples ? 10 : 1;
    for (std::size_t i = 0; i < count; ++i) {
      shares[i][m] = weight * text::curve_weight(x - double(i));
      for (std::size_t j = 0; j < count; ++j)
        normal[i][j] += shares[i][m] * text::curve_weight(x - double(j));
    }
  }
  solve_definite(normal, shares, count);
  return shares;
}

}  // namespace

Vec3 FresnelCurve::at(double cosine) const {
  std::array<text::vec3, count> r;
  for (std::size_t i = 0; i < count; ++i) r[i] = text::vec3(colors[i][0], colors[i][1], colors[i][2]);
  const text::vec3 f = text::f_curve(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8], r[9], r[10], r[11],
                                     r[12], r[13], r[14], r[15], cosine);
  return {f.x, f.y, f.z};
}

FresnelCurve fitted_curve(const std::function<Vec3(double)>& seen) {
  static const std::array<Row, count> shares = shares_of_samples();
  FresnelCurve out;
  for (std::size_t m = 0; m < samples; ++m) {
    const Vec3 value = seen(root_of(m) * root_of(m));
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t c = 0; c < 3; ++c) out.colors[i][c] += shares[i][m] * value[c];
  }
  out.off = fresnel_difference([&](double cosine) { return out.at(cosine); }, seen);
  return out;
}

FresnelDifference fresnel_difference(const std::function<Vec3(double)>& a,
                                     const std::function<Vec3(double)>& b) {
  constexpr int steps = 96;
  FresnelDifference out;
  for (int i = 0; i <= steps; ++i) {
    const double root = double(i) / steps, cosine = root * root;
    const double de = delta_e2000(to_lab(to_rgb(a(cosine))), to_lab(to_rgb(b(cosine))));
    if (!(de > out.de2000)) continue;
    out.de2000 = de;
    out.at_deg = math::acos(cosine) * 180 / std::numbers::pi;
  }
  return out;
}

}  // namespace etak
