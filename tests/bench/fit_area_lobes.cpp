// SPDX-License-Identifier: Apache-2.0
// Fits the linearly transformed cosines of core/light/area_lobes.h and writes resources/area_lobes.csv:
//   fit_area_lobes > resources/area_lobes.csv
// The error of each lobe's fit, which models.md states, goes to stderr.
// Based on:
//   Heitz, Dupuy, Hill and Neubelt 2016, "Real-Time Polygonal-Light Shading with Linearly Transformed Cosines"
//   Marquardt 1963, "An Algorithm for Least-Squares Estimation of Nonlinear Parameters"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "core/brdf/models.h"
#include "core/light/area_lobes.h"
#include "core/math/solve.h"

namespace etak {
namespace {

using std::numbers::pi;
constexpr int polar_steps = 56, around_steps = 40;

// A light direction with f nl and the solid angle that it stands for; half of the hemisphere, which is even in y.
struct Sample {
  double x, y, z, value, weight;
};

std::vector<Sample> samples_of(const Model& model, const std::vector<double>& values, double alpha,
                               double nv) {
  std::vector<Sample> out;
  const double s = std::sqrt((1 - nv) * (1 + nv));
  for (int i = 0; i < polar_steps; ++i) {
    // tan(theta) = alpha w / (1 - w)^2 with even steps in w: most half vectors lie in the lobe.
    const double w = (i + 0.5) / polar_steps, left = 1 - w;
    const double tangent = 1.3 * alpha * w / (left * left),
                 slope = 1.3 * alpha * (1 + w) / (left * left * left) / polar_steps;
    const double ct = 1 / std::sqrt(1 + tangent * tangent), st = tangent * ct;
    for (int j = 0; j < around_steps; ++j) {
      const double phi = pi * (j + 0.5) / around_steps;
      const double hx = st * std::cos(phi), hy = st * std::sin(phi), vh = hx * s + ct * nv;
      if (vh <= 0) continue;
      const Sample l{2 * vh * hx - s, 2 * vh * hy, 2 * vh * ct - nv, 0, 0};
      if (l.z <= 0) continue;
      double rgb[3];
      model.f64({l.x, l.y, l.z, s, 0, nv}, values.data(), rgb);
      out.push_back({l.x, l.y, l.z, rgb[0] * l.z, 2 * 4 * vh * st * slope * ct * ct * pi / around_steps});
    }
  }
  return out;
}

double mass_above_horizon(const AreaLobe& m) {
  return (1 + m.a / std::hypot(m.a, m.d)) / 2;
}

// A transformed cosine with its mass above the horizon scaled to 1.
double cosine_at(const AreaLobe& m, double mass, const Sample& l) {
  const double x = m.a * l.x + m.b * l.z, z = m.d * l.x + m.e * l.z, length2 = x * x + l.y * l.y + z * z;
  return z <= 0 ? 0 : z * (m.a * m.e - m.b * m.d) / (pi * length2 * length2 * mass);
}

// The numbers that are fitted: the transform, whose second row is 0 1 0, with d and e divided by alpha.
constexpr std::size_t numbers = 5;
using Fit = std::array<double, numbers>;

double share_of(const Fit& p) {
  return 1 / (1 + std::exp(-p[4]));
}

AreaLobe shape_of(const Fit& p, double alpha) {
  return {p[0], p[1], p[2] * alpha, p[3] * alpha, share_of(p)};
}

// What one lobe is fitted to, and the differences from it; their squares add up to the squared misfit, relative to
// the mean square of the lobe.
struct Target {
  double alpha;
  std::vector<Sample> samples;
  double total = 0, square = 0;
  bool upright;  // seen from the normal, where the lobe is round
  Fit near;      // the fit next to this one
  double pull;   // how much the numbers are held near to it

  std::vector<double> differences(const Fit& p) const {
    const AreaLobe shape = shape_of(p, alpha);
    const double mass = mass_above_horizon(shape);
    std::vector<double> out;
    out.reserve(samples.size() + numbers);
    for (const Sample& l : samples) {
      const double fitted = (1 - shape.cosine) * cosine_at(shape, mass, l) + shape.cosine * l.z / pi;
      out.push_back((l.value - total * fitted) * std::sqrt(l.weight / square));
    }
    for (std::size_t i = 0; i < numbers; ++i) out.push_back(pull * (p[i] - near[i]));
    return out;
  }
  double misfit(const Fit& p) const {
    const std::vector<double> all = differences(p);
    double sum = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) sum += all[i] * all[i];
    return std::sqrt(sum);
  }
};

bool possible(const Fit& p) {
  return p[0] > 5e-4 && p[3] > 0.05 && p[0] * p[3] - p[1] * p[2] > 1e-9 && p[4] > -6 && p[4] < 1;
}

double squares(const std::vector<double>& all) {
  double sum = 0;
  for (const double each : all) sum += each * each;
  return sum;
}

// Solves (A + damping diag(A)) x = b by Gauss.
Fit solved(std::array<Fit, numbers> A, Fit b, double damping) {
  for (std::size_t i = 0; i < numbers; ++i) A[i][i] += damping * A[i][i] + 1e-14;
  solve_definite(A, b, numbers);
  return b;
}

// Levenberg and Marquardt's minimum from `p` on.
Fit minimum(const Target& target, Fit p) {
  std::vector<double> here = target.differences(p);
  double damping = 1e-2;
  for (int turn = 0; turn < 80; ++turn) {
    std::array<std::vector<double>, numbers> slopes;
    for (std::size_t i = 0; i < numbers; ++i) {
      slopes[i].assign(here.size(), 0);
      // Seen from the normal, a = 1 and b = d = 0.
      if (target.upright && i != 3 && i != 4) continue;
      Fit q = p;
      const double step = 1e-5 * std::max(0.1, std::abs(p[i]));
      q[i] += step;
      slopes[i] = target.differences(q);
      for (std::size_t k = 0; k < here.size(); ++k) slopes[i][k] = (slopes[i][k] - here[k]) / step;
    }
    std::array<Fit, numbers> A{};
    Fit b{};
    for (std::size_t i = 0; i < numbers; ++i)
      for (std::size_t k = 0; k < here.size(); ++k) {
        b[i] -= slopes[i][k] * here[k];
        for (std::size_t j = 0; j <= i; ++j) A[i][j] += slopes[i][k] * slopes[j][k];
      }
    for (std::size_t i = 0; i < numbers; ++i)
      for (std::size_t j = i + 1; j < numbers; ++j) A[i][j] = A[j][i];
    const double before = squares(here);
    bool better = false;
    while (!better && damping < 1e8) {
      Fit q = solved(A, b, damping);
      for (std::size_t i = 0; i < numbers; ++i) q[i] += p[i];
      if (possible(q)) {
        std::vector<double> there = target.differences(q);
        if (squares(there) < before) {
          p = q, here = std::move(there), better = true;
          break;
        }
      }
      damping *= 4;
    }
    if (!better || squares(here) > before * (1 - 1e-6)) break;
    damping = std::max(damping / 8, 1e-9);
  }
  return p;
}

void fit(std::string_view distribution, std::string_view visibility, double f0) {
  const std::string id =
      std::string(distribution) + ',' + std::string(visibility) + " of F0 " + std::to_string(f0);
  const Model& model =
      *find_model("microfacet:" + std::string(distribution) + ",schlick," + std::string(visibility));
  double worst = 0, sum = 0, worst_alpha = 0, worst_nv = 0;
  std::array<Fit, area_lobe_columns> before{};
  for (int row = 0; row < area_lobe_rows; ++row) {
    const double alpha = area_lobe_alpha(row);
    std::vector<double> values;
    for (const Parameter& each : model.parameters) {
      const double width = each.role == Role::exponent ? std::max(0.0, 2 / (alpha * alpha) - 2) : alpha;
      values.insert(values.end(), each.color ? 3 : 1, each.color ? f0 : width);
    }
    Fit last = row == 0 ? Fit{1, 0, 0, 2, -5} : before[0];
    for (int column = 0; column < area_lobe_columns; ++column) {
      const double nv = area_lobe_cosine(column);
      Target target{
          alpha, samples_of(model, values, alpha, nv), 0, 0, column == 0, last, column == 0 ? 0 : 5e-3};
      for (const Sample& l : target.samples) {
        target.total += l.value * l.weight;
        target.square += l.value * l.value * l.weight;
      }
      // Where the lobe is narrow, it is the mirrored cone of half vectors, as wide as twice alpha in the plane.
      const double sine = std::sqrt((1 - nv) * (1 + nv));
      const Fit mirrored{nv * nv, nv * sine, -2 * nv * sine, 2 * nv * nv, last[4]};
      Fit best = minimum(target, mirrored);
      for (const Fit& from : {last, before[std::size_t(column)]})
        if (possible(from))
          if (const Fit other = minimum(target, from); target.misfit(other) < target.misfit(best))
            best = other;
      last = before[std::size_t(column)] = best;
      const double e = target.misfit(best);
      sum += e;
      if (e > worst) worst = e, worst_alpha = alpha, worst_nv = nv;
      std::printf("%.4f, %.4f, %.4f, %.4f, %.4f\n", best[0], best[1], best[2], best[3], share_of(best));
    }
  }
  std::fprintf(stderr, "%s: rms misfit of the lobe %.3f on average, %.3f at most (alpha %.2f, nv %.2f)\n",
               id.c_str(), sum / (area_lobe_rows * area_lobe_columns), worst, worst_alpha, worst_nv);
}

}  // namespace
}  // namespace etak

int main() {
  std::printf(
      "# SPDX-License-Identifier: Apache-2.0\n"
      "# Written by tests/bench/fit_area_lobes.cpp for core/light/area_lobes.h: a, b, d / alpha, e / alpha and the share\n"
      "# of the plain cosine. Lobes of Trowbridge and Reitz, Beckmann and Phong of F = 1, and of Trowbridge and Reitz of F0 = 0.04;\n"
      "# for each the widths, for each of them the cosines of the viewer.\n");
  etak::fit("ggx", "smith-ggx-height", 1);
  etak::fit("beckmann", "smith-beckmann-height", 1);
  etak::fit("phong", "kelemen", 1);
  etak::fit("ggx", "smith-ggx-height", 0.04);
}
