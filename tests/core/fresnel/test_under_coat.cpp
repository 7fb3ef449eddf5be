// SPDX-License-Identifier: Apache-2.0
// F0 and F82 under a coat from those in air, by core/fresnel/under_coat.glsl.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "core/base/text/text.h"
#include "core/color/delta_e.h"
#include "core/color/rgb.h"
#include "core/fresnel/fresnel.h"
#include "core/material/f0/f0_settings.h"
#include "core/material/f0_coat.h"
#include "core/material/library.h"
#include "tests/core/material/library_support.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

struct EdgeOfIndex {
  double f0, f82;
};

EdgeOfIndex edge_of_index(double n, double k) {
  return {f64::f0(n, k), f64::fresnel_exact(n, k, f82_cosine)};
}

// What pictures show of it.
Lab shown(const LinearRgb& c) {
  return to_lab(LinearRgb{std::clamp(c.r, 0.0, 1.0), std::clamp(c.g, 0.0, 1.0), std::clamp(c.b, 0.0, 1.0)});
}

template <class Formula>
LinearRgb by_channel(const LinearRgb& a, const LinearRgb& b, const Formula& formula) {
  return {formula(a.r, b.r), formula(a.g, b.g), formula(a.b, b.b)};
}

// The dielectric of F0 under a coat: no k.
double rescaled(double f0_value, double n) {
  const double root = std::sqrt(std::clamp(f0_value, 0.0, 1 - 1e-12)), index = (1 + root) / (1 - root);
  return (index - n) / (index + n) * ((index - n) / (index + n));
}

struct MeanAndMost {
  double sum = 0, most = 0;
  int count = 0;
  void add(double value) {
    sum += value;
    most = std::max(most, value);
    ++count;
  }
  double mean() const { return sum / count; }
};

}  // namespace

TEST_CASE("F0 and F82 in air have one n and k, which gives those under any coat") {
  std::mt19937 random(38);
  std::uniform_real_distribution<double> log_n(-4, 1.8), log_k(-3, 2.3), coat(0.5, 3);
  for (int i = 0; i < 4000; ++i) {
    const double n = std::exp(log_n(random)), k = std::exp(log_k(random)), c = coat(random);
    const EdgeOfIndex in_air = edge_of_index(n, k), expected = edge_of_index(n / c, k / c);
    if (in_air.f0 < 0.02) continue;
    INFO(n << " " << k << " under " << c);
    CHECK(f64::f0_under(in_air.f0, in_air.f82, c) == Approx(expected.f0).margin(1e-8));
    CHECK(f64::f82_under(in_air.f0, in_air.f82, c) == Approx(expected.f82).margin(1e-8));
    CHECK(f64::f82_under(in_air.f0, in_air.f82, 1) == Approx(in_air.f82).margin(1e-9));
  }
}

TEST_CASE("along all n and k of one F0 the edge rises from the dielectric's to total reflection") {
  for (double r = 0.001; r < 1; r += 0.037) {
    const double root = std::sqrt(r);
    double last = -1;
    for (int i = 0; i <= 2000; ++i) {
      const double turn = std::pow(i / 2000.0, 3), gap = (1 - root) * (1 - root) + 4 * root * turn;
      const double f82 =
          f64::fresnel_exact((1 - r) / gap, 4 * root * std::sqrt(turn * (1 - turn)) / gap, f82_cosine);
      CHECK(f82 >= last - 1e-13);
      last = f82;
    }
    CHECK(last == Approx(1).margin(1e-12));
  }
}

TEST_CASE("F0 of 0 and 1, colours out of gamut and edges out of reach have the nearest n and k") {
  for (const double c : {1.0, 1.33, 1.5, 3.0}) {
    const double surface = std::pow((c - 1) / (c + 1), 2);
    for (const double f82 : {-0.5, 0.0, 0.3, 1.0, 1.5}) {
      INFO(c << " " << f82);
      for (const double above : {1.0, 1.04, 10.0}) {
        CHECK(f64::f0_under(above, f82, c) == Approx(1).epsilon(1e-14));
        CHECK(f64::f82_under(above, f82, c) == Approx(1).epsilon(1e-14));
        CHECK(f32::f0_under(float(above), float(f82), float(c)) == Approx(1).epsilon(1e-6));
      }
      for (const double below : {0.0, -0.1, -10.0})
        CHECK(f64::f0_under(below, f82, c) == Approx(surface).margin(1e-14));
    }
    for (const double r : {0.04, 0.3, 0.9}) {
      CHECK(f64::f0_under(r, 0, c) == Approx(rescaled(r, c)).margin(1e-14));      // the dielectric
      CHECK(f64::f0_under(r, 2, c) == Approx(rescaled(r, 1 / c)).margin(1e-14));  // its inverse
      CHECK(f64::f0_under(r, 0.7, 1) == Approx(r).epsilon(1e-13));
    }
  }
}

TEST_CASE("single precision stays near double under a coat") {
  std::mt19937 random(83);
  std::uniform_real_distribution<double> log_n(-3, 1.5), log_k(-2, 2), coat(1, 2);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const EdgeOfIndex in_air = edge_of_index(std::exp(log_n(random)), std::exp(log_k(random)));
    if (in_air.f0 < 0.04) continue;
    const float r = float(in_air.f0), f82 = float(in_air.f82), c = float(coat(random));
    worst = std::max({worst, std::abs(double(f32::f0_under(r, f82, c)) - f64::f0_under(r, f82, c)),
                      std::abs(double(f32::f82_under(r, f82, c)) - f64::f82_under(r, f82, c))});
  }
  INFO(worst);
  CHECK(worst < 1e-4);
}

// The figures of resources/doc/films.md.
TEST_CASE(
    "35 metals under coats of 1.33, 1.5 and 1.7 are within 0.5 of the exact colours, and the usual ways are not") {
  const std::array<double, 3> indices{1.33, 1.5, 1.7};
  for (std::size_t which = 0; which < indices.size(); ++which) {
    const double n = indices[which];
    MeanAndMost by_formula, edge, unchanged, dielectric, edge_unchanged;
    for (const std::string& id : library().ids()) {
      const Material material = *library().find(id);
      const Optics& optics = material.preferred_dataset().optics;
      if (material.material_class != "metal" || std::holds_alternative<Stack>(optics)) continue;
      INFO(material.id << " under " << n);
      const F0Result air = F0Solver({}).solve(optics);
      CoatedF0 exact;
      REQUIRE(coated({"", {Spectrum{{550}, {n}}, {}}, n, 0}, {}, optics, id, exact) == "");
      const Lab under = shown(exact.under.linear), under82 = shown(*exact.under.f82);
      const LinearRgb& r = air.linear;
      const auto off = [](const Lab& to, const LinearRgb& found) { return delta_e2000(to, shown(found)); };
      by_formula.add(
          off(under, by_channel(r, *air.f82, [&](double a, double b) { return f64::f0_under(a, b, n); })));
      edge.add(
          off(under82, by_channel(r, *air.f82, [&](double a, double b) { return f64::f82_under(a, b, n); })));
      unchanged.add(off(under, r));
      edge_unchanged.add(off(under82, *air.f82));
      dielectric.add(off(under, by_channel(r, r, [&](double a, double) { return rescaled(a, n); })));
    }
    CHECK(by_formula.count == 35);
    const auto figures = [](const MeanAndMost& of) {
      return " " + fixed(of.mean(), 2) + " / " + fixed(of.most, 2);
    };
    WARN(n << figures(by_formula) << figures(edge) << figures(unchanged) << figures(edge_unchanged)
           << figures(dielectric));
    CHECK(by_formula.most <= 0.5);
    CHECK(edge.most <= 0.5);
  }
}
