// SPDX-License-Identifier: Apache-2.0
// Fits the light that one reflection of a rough surface of F = 1 loses between its facets, and prints the functions of
// core/brdf/lost_light.glsl:
//   fit_lost_light
// The error of each fit goes to stderr.
// Based on:
//   Lawson 1961: weights that grow with the error turn least squares into the least of the largest errors
//   Kulla and Conty 2017, "Revisiting Physically Based Shading at Imageworks": what the functions are for
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "core/brdf/integrals/albedo.h"
#include "core/brdf/models.h"
#include "core/math/solve.h"

namespace etak {
namespace {

using Row = std::vector<double>;

struct Sample {
  Row terms;
  double value, weight = 1;
};

// Solves A x = b by Gauss.
Row solved(std::vector<Row> A, Row b) {
  solve_definite(A, b, b.size());
  return b;
}

double sum_of(const Row& factors, const Row& terms) {
  double sum = 0;
  for (std::size_t i = 0; i < terms.size(); ++i) sum += factors[i] * terms[i];
  return sum;
}

// A number as it is printed.
double printed(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return std::strtod(text, nullptr);
}

// The factors of the terms whose largest error is least, and that error.
std::pair<Row, double> fitted(std::vector<Sample> samples) {
  const std::size_t n = samples.front().terms.size();
  Row best;
  double least = 1e300;
  for (int round = 0; round < 1000; ++round) {
    std::vector<Row> A(n, Row(n));
    Row b(n);
    for (const Sample& s : samples)
      for (std::size_t i = 0; i < n; ++i) {
        b[i] += s.weight * s.terms[i] * s.value;
        for (std::size_t j = 0; j < n; ++j) A[i][j] += s.weight * s.terms[i] * s.terms[j];
      }
    for (std::size_t i = 0; i < n; ++i) A[i][i] *= 1 + 1e-12;
    Row factors = solved(A, b);
    std::ranges::transform(factors, factors.begin(), printed);
    double worst = 0, sum = 0;
    for (Sample& s : samples) {
      const double off = std::abs(sum_of(factors, s.terms) - s.value);
      worst = std::max(worst, off);
      s.weight *= off + 1e-5;
      sum += s.weight;
    }
    for (Sample& s : samples) s.weight *= double(samples.size()) / sum;
    if (worst < least) least = worst, best = factors;
  }
  return {best, least};
}

// f0 + a (f1 + a (f2 + ...)) as text, in lines of up to six factors.
std::string horner(const double* factors, std::size_t count) {
  std::string out;
  for (std::size_t i = 0; i < count; ++i) {
    char text[40];
    std::snprintf(text, sizeof text, "real(%.6g)", factors[i]);
    out += text;
    if (i + 1 < count) out += i % 6 == 5 ? " +\n      a * (" : " + a * (";
  }
  return out + std::string(count - 1, ')');
}

// The mean of what is lost over a diffuse hemisphere of directions.
double mean_of(const std::function<double(double c, double a)>& lost, double a) {
  double sum = 0;
  constexpr int steps = 2000;
  for (int k = 0; k < steps; ++k) {
    const double s = (k + 0.5) / steps, c = s * s;
    sum += 2 * c * 2 * s * lost(c, a) / steps;
  }
  return sum;
}

struct Furnace {
  double c, a, albedo;
};

void fit(const char* name, const char* id, double share, std::size_t in_t, std::size_t in_a) {
  constexpr int widths = 28, views = 32;
  const Model& model = *find_model(id);
  std::vector<Sample> samples;
  std::vector<Furnace> furnace;
  const auto terms = [&](double c, double a) {
    const double t = c / (c + share * a);
    Row out;
    for (std::size_t i = 0; i < in_t; ++i)
      for (std::size_t j = 0; j < in_a; ++j)
        out.push_back(t * std::pow(2 * t - 1, double(i)) * std::pow(2 * a - 1, double(j)));
    return out;
  };
  for (int i = 0; i <= widths; ++i)
    for (int j = 0; j <= views; ++j) {
      const double r = 0.1 + 0.9 * i / widths, s = 0.1 + 0.9 * j / views, a = r * r, c = s * s;
      const std::vector<double> values{1, 1, 1, a};
      AlbedoOptions options;
      options.lobe_width = a;
      options.error = 1e-6;
      const double albedo = directional_albedo(
          [&](const Directions& d) {
            double rgb[3];
            model.f64(d, values.data(), rgb);
            return rgb[0];
          },
          std::acos(std::min(c, 1.0)) * 180 / 3.14159265358979323846, options);
      samples.push_back({terms(c, a), 1 - albedo});
      furnace.push_back({c, a, albedo});
    }
  const auto [factors, off] = fitted(samples);
  // Less by the error, so that no light is gained.
  const double less = std::ceil(off * 1e4 + 0.5) / 1e4;
  const auto lost = [&](double c, double a) { return std::max(sum_of(factors, terms(c, a)) - less, 0.0); };
  // Its mean. What counts is the relative error times the most that is lost, which the furnace shows; the mean is above
  // the fit's by it, so that no light is gained.
  std::vector<Sample> means;
  constexpr std::size_t in_mean = 11;
  for (int i = 0; i <= 64; ++i) {
    const double r = 0.1 + 0.9 * i / 64, a = r * r;
    const double mean = mean_of(lost, a);
    double most = 0;
    for (int k = 1; k <= 100; ++k) most = std::max(most, lost(k / 100.0, a));
    Row row;
    for (std::size_t j = 0; j < in_mean; ++j)
      row.push_back(most * a * a * std::pow(2 * r - 1, double(j)) / mean);
    means.push_back({row, most});
  }
  const double mean_off = fitted(means).second * 1.05;
  for (Sample& each : means) each.value += mean_off;
  const Row mean = fitted(means).first;
  double darkest = 2, brightest = 0;
  for (const auto& [c, a, albedo] : furnace) {
    const double r = std::sqrt(a);
    double of_fit = 0;
    for (std::size_t j = 0; j < in_mean; ++j) of_fit += mean[j] * a * a * std::pow(2 * r - 1, double(j));
    const double all = albedo + lost(c, a) * mean_of(lost, a) / of_fit;
    darkest = std::min(darkest, all);
    brightest = std::max(brightest, all);
  }
  std::fprintf(stderr, "%s: lost light %.4f too low to exact, white furnace %.4f to %.4f\n", name, off + less,
               darkest, brightest);
  std::printf(
      "\nreal lost_%s(real c, real alpha) {\n  real t = c / max(c + real(%g) * alpha, tiny);\n"
      "  real u = 2 * t - 1;\n  real a = 2 * alpha - 1;\n",
      name, share);
  for (std::size_t i = 0; i < in_t; ++i)
    std::printf("  real k%zu = %s;\n", i, horner(&factors[i * in_a], in_a).c_str());
  std::string sum;
  for (std::size_t i = 0; i < in_t; ++i)
    sum += "k" + std::to_string(i) + (i + 1 < in_t ? " + u * (" : std::string(in_t - 1, ')'));
  std::printf("  return max(t * (%s) - real(%g), real(0));\n}\n", sum.c_str(), less);
  std::printf(
      "\nreal mean_lost_%s(real alpha) {\n  real a = 2 * max(sqrt(alpha), real(0.1)) - 1;\n"
      "  return alpha * alpha * (%s);\n}\n",
      name, horner(mean.data(), in_mean).c_str());
}

}  // namespace
}  // namespace etak

int main() {
  std::printf(
      "// SPDX-License-Identifier: Apache-2.0\n"
      "// Written by tests/bench/fit_lost_light.cpp: the share of light that a rough surface of F = 1 loses, because one\n"
      "// reflection sends it to other facets, for Smith's height-correlated masking; and its mean over a diffuse hemisphere.\n"
      "// At most 0.0071 below the integral and never above it, so that no light is gained, for widths from 0.01 to 1.\n"
      "//   c       cosine of the direction and the normal, [0, 1]\n"
      "//   alpha   width, (0, 1]\n");
  etak::fit("ggx", "microfacet:ggx,schlick,smith-height", 0.5, 7, 4);
  etak::fit("beckmann", "microfacet:beckmann,schlick,smith-height", 2, 6, 6);
}
