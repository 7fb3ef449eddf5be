// SPDX-License-Identifier: Apache-2.0
#include "core/brdf/integrals/normalise.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/brdf/integrals/albedo.h"
#include "core/math/quadrature.h"

using namespace etak;

namespace {

// The integral by its definition: 2 pi times that of (1 + a t)^-b (1 - t) over [0, 1], taken over
// s = log(1 + a t).
double abc_by_quadrature(double a, double b) {
  const double u = std::log1p(a);
  double sum = 0;
  for (int i = 0; i < 400; ++i)
    sum += gauss_legendre<16>([&](double s) { return std::exp((1 - b) * s) * (a - std::expm1(s)) / (a * a); },
                              u * i / 400, u * (i + 1) / 400);
  return 1 / (2 * std::numbers::pi * sum);
}

}  // namespace

TEST_CASE("Gauss-Legendre is exact for polynomials of its degree") {
  for (int power = 0; power < 20; ++power)
    CHECK(gauss_legendre<10>([&](double x) { return std::pow(x, power); }, 0, 1) ==
          Approx(1.0 / (power + 1)).epsilon(1e-14));
  CHECK(adaptive_integral([](double x) { return std::abs(x - 0.3); }, 0, 1, 1e-12) ==
        Approx(0.29).epsilon(1e-10));
  CHECK(adaptive_integral([](double x) { return std::sqrt(x); }, 0, 1, 1e-12, 60) ==
        Approx(2.0 / 3).epsilon(1e-10));
}

TEST_CASE("ABC's constant is right everywhere, its removable poles included") {
  for (const double a : {1e-9, 1e-5, 1e-3, 0.05, 0.0999, 0.1, 0.2, 1.0, 30.0, 1e4, 1e8})
    for (const double b : {0.0, 0.3, 0.999999, 1.0, 1 + 1e-9, 1.5, 2 - 1e-7, 2.0, 2.000001, 5.0, 40.0}) {
      INFO("a1 " << a << ", a2 " << b);
      CHECK(abc_norm(a, b) == Approx(abc_by_quadrature(a, b)).epsilon(2e-11));
    }
  CHECK(abc_norm(0, 3) == Approx(1 / std::numbers::pi).epsilon(1e-15));
  const double a = 7;  // the closed forms at the poles
  CHECK(1 / abc_norm(a, 1) ==
        Approx(2 * std::numbers::pi * ((1 + a) * std::log(1 + a) - a) / (a * a)).epsilon(1e-13));
  CHECK(1 / abc_norm(a, 2) == Approx(2 * std::numbers::pi * (a - std::log(1 + a)) / (a * a)).epsilon(1e-13));
}

TEST_CASE("the shifted gamma constant is one over an incomplete gamma function") {
  // Gamma(0, x) = E1(x), Gamma(1, x) = e^-x, Gamma(1/2, x) = sqrt(pi) erfc(sqrt x), and
  // Gamma(-1, x) = e^-x / x - E1(x).
  CHECK(std::exp(-log_sgd_norm(1, 1)) == Approx(0.21938393439552027368).epsilon(1e-12));
  CHECK(std::exp(-log_sgd_norm(0.1, 1)) == Approx(1.8229239584193906661).epsilon(1e-12));
  for (const double x : {1e-6, 0.01, 0.5, 3.0, 50.0}) {
    CHECK(std::exp(-log_sgd_norm(x, 1e-15)) == Approx(std::exp(-x)).epsilon(1e-12));
    CHECK(std::exp(-log_sgd_norm(x, 0.5)) ==
          Approx(std::sqrt(std::numbers::pi) * std::erfc(std::sqrt(x))).epsilon(1e-12));
  }
  CHECK(std::exp(-log_sgd_norm(1, 2)) == Approx(std::exp(-1.0) - 0.21938393439552027368).epsilon(1e-12));
}

TEST_CASE("every distribution integrates to what it claims") {
  for (const Term& term : terms()) {
    if (term.kind != TermKind::distribution) continue;
    for (const double width : {0.01, 0.1, 0.5, 1.0}) {
      std::vector<double> values;
      const double e = 2 / (width * width) - 2;
      for (const Parameter& p : term.parameters)
        values.push_back(p.role == Role::alpha      ? width
                         : p.role == Role::exponent ? e
                         : p.name == "a1"           ? 10 / width
                                                    : 1.7);
      const double integral = integral_of_distribution(
          [&](double nm, double s2) {
            // l and v are the same direction at cosine nm, so the half vector is that direction too.
            double rgb[3];
            const double s = std::sqrt(s2);
            term.f64({s, 0, nm, s, 0, nm}, values.data(), rgb);
            return rgb[0];
          },
          width);
      INFO(term.id << " of width " << width);
      const double expected = term.id == "beckmann-printed" ? std::numbers::pi / 4
                              : term.id == "schueler"       ? (1 + e) / (2 + e)
                              : term.id == "abc-printed"    ? 1 / abc_norm(values[0], values[1])
                                                            : 1;
      CHECK(integral == Approx(expected).epsilon(1e-8));
    }
  }
}
