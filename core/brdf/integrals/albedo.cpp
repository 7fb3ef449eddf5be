// SPDX-License-Identifier: Apache-2.0
#include "core/brdf/integrals/albedo.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/math/functions.h"
#include "core/math/quadrature.h"

namespace etak {
namespace {

using std::numbers::pi;

double sin_deg(double x) {
  const double r = std::remainder(x, 360);  // exact
  if (r == 0 || r == 180 || r == -180) return 0;
  if (r == 90 || r == -90) return r / 90;
  return math::sin(r * (pi / 180));
}

// The half vectors at one polar angle, as a function of the azimuth, for one viewer.
class Ring {
 public:
  Ring(const Vec3& v, double theta, const std::optional<Vec3>& half_space)
      : v_(v), s_(math::sin(theta)), c_(math::cos(theta)), half_space_(half_space) {}

  double vh(double phi) const { return v_[0] * s_ * math::cos(phi) + v_[2] * c_; }
  Vec3 light(double phi) const {
    const double twice = 2 * vh(phi);
    return {twice * s_ * math::cos(phi) - v_[0], twice * s_ * math::sin(phi), twice * c_ - v_[2]};
  }

  // The azimuths in [0, end] between which the integrand is smooth. They are where the light crosses the
  // horizon, where nl = nv, and where 2 nh nv / vh or 2 nh nl / vh is 1. Each is a certain value of vh, which
  // is linear in cos(phi).
  std::vector<double> edges(double end) const {
    std::vector<double> out{0, end};
    const double slope = v_[0] * s_;
    const double thresholds[] = {v_[2] / (2 * c_), v_[2] / c_, 2 * c_ * v_[2],
                                 2 * c_ * v_[2] / (4 * c_ * c_ - 1)};
    const auto add = [&](double vh) {
      const double cosine = (vh - v_[2] * c_) / slope;
      if (!(std::abs(cosine) < 1)) return;
      const double phi = math::acos(cosine);
      out.push_back(phi);
      if (end > pi) out.push_back(2 * pi - phi);
    };
    for (const double each : thresholds) add(each);
    // At the most grazing views, models that divide by powers of vh (Schueler's Optimized) rise and fall
    // within a millionth of the ring next to the light's horizon, so there the pieces grow by a factor.
    if (v_[2] < 1e-4)
      for (double vh = 8 * thresholds[0]; vh < 0.25; vh *= 8) add(vh);
    if (half_space_) add_crossings(out);
    std::sort(out.begin(), out.end());
    return out;
  }

 private:
  double beyond(double phi) const {
    const Vec3 l = light(phi);
    return l[0] * (*half_space_)[0] + l[1] * (*half_space_)[1] + l[2] * (*half_space_)[2];
  }

  // Adds the azimuths where the light crosses the edge of the half space. There are at most four, since
  // beyond() has two harmonics. Extremes between the samples are looked for too, since two close roots would
  // be missed otherwise.
  void add_crossings(std::vector<double>& out) const {
    constexpr int samples = 48;
    std::vector<double> at;
    for (int i = 0; i <= samples; ++i) at.push_back(2 * pi * i / samples);
    for (int i = 0; i < samples; ++i) {
      const double a = 2 * pi * (i - 1) / samples, b = 2 * pi * (i + 1) / samples;
      const double here = beyond(2 * pi * i / samples);
      const double sign = here > 0 ? 1 : -1;  // of an extreme that points towards zero
      if (sign * beyond(a) >= sign * here && sign * beyond(b) >= sign * here) {
        double lo = a, hi = b;
        for (int round = 0; round < 60; ++round) {
          const double m1 = lo + (hi - lo) / 3, m2 = hi - (hi - lo) / 3;
          (sign * beyond(m1) < sign * beyond(m2) ? hi : lo) = sign * beyond(m1) < sign * beyond(m2) ? m2 : m1;
        }
        if (lo > 0 && lo < 2 * pi) at.push_back(lo);
      }
    }
    std::sort(at.begin(), at.end());
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
      double lo = at[i], hi = at[i + 1];
      const bool up = beyond(lo) > 0;
      if (up == (beyond(hi) > 0)) continue;
      for (int round = 0; round < 52; ++round) ((beyond((lo + hi) / 2) > 0) == up ? lo : hi) = (lo + hi) / 2;
      out.push_back(lo);
    }
  }

  Vec3 v_;
  double s_, c_;
  std::optional<Vec3> half_space_;
};

}  // namespace

// Cosines are taken as sines of the complement, because 90 - theta is exact where the cosine is small.
Vec3 direction_deg(double theta_deg, double phi_deg) {
  const double s = sin_deg(theta_deg);
  return {s * sin_deg(90 - phi_deg), s * sin_deg(phi_deg), sin_deg(90 - theta_deg)};
}

double directional_albedo(const BrdfFunction& f, double theta_v_deg, const AlbedoOptions& options) {
  const Vec3 v = direction_deg(theta_v_deg, 0);
  if (!(v[2] > 0)) return 0;
  const bool half_ring = options.isotropic && !options.half_space;
  const double end = half_ring ? pi : 2 * pi;

  const auto integrate = [&](double error) {
    const auto over_ring = [&](double theta) {
      const Ring ring(v, theta, options.half_space);
      const double s = math::sin(theta);
      const auto integrand = [&](double phi) {
        const double vh = ring.vh(phi);
        if (!(vh > 0)) return 0.0;
        const Vec3 l = ring.light(phi);
        if (!(l[2] > 0)) return 0.0;
        if (options.half_space) {
          const Vec3& z = *options.half_space;
          if (!(dot(l, z) > 0)) return 0.0;
        }
        return f({l[0], l[1], l[2], v[0], v[1], v[2]}) * l[2] * 4 * vh;
      };
      const double inner_error = error * 0.01 / (s * theta);
      double sum = 0;
      const std::vector<double> edges = ring.edges(end);
      for (std::size_t i = 0; i + 1 < edges.size(); ++i)
        if (edges[i + 1] > edges[i]) {
          // A piece beyond the horizon is zero throughout.
          const double middle = (edges[i] + edges[i + 1]) / 2;
          if (ring.light(middle)[2] > 0 && ring.vh(middle) > 0)
            sum += adaptive_integral(integrand, edges[i], edges[i + 1], inner_error, 14);
        }
      return sum * s * (half_ring ? 2 : 1);
    };
    double sum = 0, from = 0;
    for (double to = std::clamp(options.lobe_width / 4, 1e-9, 0.2); from < pi / 2; to *= 2) {
      to = to > 0.8 ? pi / 2 : to;
      sum += adaptive_integral(over_ring, from, to, error / 16, 14);
      from = to;
    }
    return sum;
  };
  double first = integrate(std::max(options.error, 1e-4));
  return options.error >= 1e-4 ? first : integrate(options.error * std::max(1.0, first));
}

double integral_of_distribution(const std::function<double(double, double)>& D, double lobe_width) {
  const auto integrand = [&](double s2) { return D(std::sqrt(1 - s2), s2); };
  double sum = 0, from = 0;
  for (double to = std::clamp(lobe_width * lobe_width, 1e-12, 0.5); from < 1; to *= 4) {
    to = to > 0.9 ? 1 : to;
    sum += adaptive_integral(integrand, from, to, 1e-13, 40);
    from = to;
  }
  return pi * sum;
}

// A + B / 2 = 1 - x / (2 (x + 0.33)) + 0.225 x / (x + 0.09) with x = sigma^2; its slope is zero where
// (x + 0.33) / (x + 0.09) = sqrt(0.165 / 0.02025).
double oren_nayar_grazing_albedo_max() {
  const double ratio = std::sqrt(0.165 / 0.02025);
  const double x = (0.33 - 0.09 * ratio) / (ratio - 1);
  return 1 - 0.5 * x / (x + 0.33) + 0.225 * x / (x + 0.09);
}

}  // namespace etak
