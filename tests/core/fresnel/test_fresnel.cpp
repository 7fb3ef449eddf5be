// SPDX-License-Identifier: Apache-2.0
#include "core/fresnel/fresnel.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace etak;

namespace {

// Fresnel's equations in complex quadruple precision (extended where the compiler has none): independent of
// the rearrangement under test.
#ifdef __SIZEOF_FLOAT128__
__extension__ typedef __float128 Quad;
#else
typedef long double Quad;
#endif

// Newton's method from double's root: the library's square roots stop at long double.
Quad root_of(Quad x) {
  if (x <= 0) return 0;
  Quad r = std::sqrt(static_cast<long double>(x));
  for (int i = 0; i < 3; ++i) r = (r + x / r) / 2;
  return r;
}

Quad quad_abs(Quad x) {
  return x < 0 ? -x : x;
}

Quad by_complex(double n_, double k_, double c_) {
  const Quad n = n_, k = k_, c = c_;
  const Quad e2_re = n * n - k * k, e2_im = 2 * n * k;  // eta^2
  const Quad t_re = e2_re - (1 - c) * (1 + c), t_im = e2_im;
  // Square root of t in the first quadrant.
  const Quad size = root_of(t_re * t_re + t_im * t_im);
  const Quad larger = root_of((size + quad_abs(t_re)) / 2);
  const Quad smaller = larger == 0 ? Quad(0) : t_im / (2 * larger);
  const Quad a = t_re >= 0 ? larger : smaller, b = t_re >= 0 ? smaller : larger;
  const auto norm = [](Quad re, Quad im) { return re * re + im * im; };
  const Quad rs = norm(c - a, -b) / norm(c + a, b);
  const Quad rp = norm(e2_re * c - a, e2_im * c - b) / norm(e2_re * c + a, e2_im * c + b);
  return (rs + rp) / 2;
}

double by_complex_double(double n, double k, double c) {
  return static_cast<double>(by_complex(n, k, c));
}

// The usual a^2 + b^2 form, as in most texts.
template <class Real>
Real textbook(Real n, Real k, Real c) {
  const Real s2 = 1 - c * c, t = n * n - k * k - s2;
  const Real ab = std::sqrt(t * t + 4 * n * n * k * k);
  const Real a = std::sqrt(std::max(Real(0), (ab + t) / 2));
  const Real rs = (ab + c * c - 2 * a * c) / (ab + c * c + 2 * a * c);
  return rs * (1 + (ab * c * c + s2 * s2 - 2 * a * c * s2) / (ab * c * c + s2 * s2 + 2 * a * c * s2)) / 2;
}

const std::array<double, 7> cosines{1, 0.9, 0.5, 1.0 / 7, 0.05, 1e-3, 1e-8};

}  // namespace

TEST_CASE("F0 has its known limits") {
  CHECK(f64::f0(1, 0) == 0);
  CHECK(f64::f0(1.5, 0) == Approx(0.04).epsilon(1e-15));
  CHECK(f64::f0(4.0 / 3, 0) == Approx(1.0 / 49).epsilon(1e-14));
  CHECK(f64::f0(1 / 1.5, 0) == Approx(0.04).epsilon(1e-14));  // the same from both sides
  CHECK(f64::f0(1e-8, 5) == Approx(1).epsilon(1e-7));
  CHECK(f64::f0(1, 1e6) == Approx(1).epsilon(1e-11));
  CHECK(f64::f0(2, 3) == Approx(10.0 / 18).epsilon(1e-15));
}

TEST_CASE("F0 and absorptance sum to one, and absorptance keeps its digits for large k") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-3, 4);
  for (int i = 0; i < 5000; ++i) {
    const double n = std::pow(10, exponent(random)), k = i % 5 == 0 ? 0 : std::pow(10, exponent(random));
    REQUIRE(f64::f0(n, k) + f64::absorptance0(n, k) == Approx(1).epsilon(1e-14));
    REQUIRE(f64::f0(n, k) >= 0);
    REQUIRE(f64::f0(n, k) <= 1);
  }
  CHECK(f64::absorptance0(0.2, 1e6) == Approx(8.0e-13).epsilon(1e-11));
  CHECK(f64::absorptance0(1, 1e3) == Approx(1 - 0.999999000003L * 1 + 9.96e-7 - 9.99997e-7).margin(4e-6));
}

TEST_CASE("at n = 1.0003 the stable form keeps its digits in float where the textbook form has none") {
  for (const double n : {1.01, 1.001, 1.0003, 1.0001}) {
    const auto nf = static_cast<float>(n);
    const double truth = by_complex_double(nf, 0, 1);
    CHECK(std::abs(f32::f0(nf, 0) - truth) <= 2.3e-6 * truth);
    CHECK(std::abs(f32::fresnel_exact(nf, 0, 1) - truth) <= 2.3e-6 * truth);
    CHECK(std::abs(f64::fresnel_exact(nf, 0, 1) - truth) <= 1e-14 * truth);
  }
  const float n = 1.0003f;
  const double truth = by_complex_double(n, 0, 1);
  CHECK(std::abs(textbook(n, 0.f, 1.f) - truth) > 0.1 * truth);
}

TEST_CASE("the exact formula keeps 14 digits in double and 6 in float over its domain") {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> log_n(-2, std::log10(20)), log_k(-8, 2), uniform(0, 1);
  double worst64 = 0, worst32 = 0, worst_critical = 0;
  for (int i = 0; i < 200000; ++i) {
    // Rounded to float, so that both precisions get the same input.
    const float n =
        static_cast<float>(i % 5 == 0 ? 1 + (uniform(random) - 0.5) * std::pow(10, -6 * uniform(random))
                                      : std::pow(10, log_n(random)));
    const float k = i % 3 == 0 ? 0 : static_cast<float>(std::pow(10, log_k(random)));
    const float c = static_cast<float>(i % 2 ? uniform(random) : std::pow(10, -6 * uniform(random)));
    const Quad truth = by_complex(n, k, c);
    if (truth == 0) continue;
    const auto off = [&](double value) { return std::abs(static_cast<double>((value - truth) / truth)); };
    const double x = static_cast<double>(n) * n + static_cast<double>(c) * c - 1 - static_cast<double>(k) * k;
    const bool critical = std::hypot(x, 2.0 * n * k) < 0.03 * c * c;
    if (critical) {
      worst_critical = std::max(worst_critical, off(f64::fresnel_exact(n, k, c)));
    } else {
      worst64 = std::max(worst64, off(f64::fresnel_exact(n, k, c)));
      worst32 = std::max(worst32, off(f32::fresnel_exact(n, k, c)));
    }
  }
  CHECK(worst64 <= 1e-14);
  CHECK(worst32 <= 2e-6);
  CHECK(worst_critical <= 2e-12);  // the last digit of c itself weighs so much there
}

TEST_CASE("reflectance stays in [0, 1] and is finite for extreme input") {
  for (const double n : {1e-8, 1e-3, 0.2, 1.0, 1.0 + 1e-12, 1.5, 20.0, 1e4})
    for (const double k : {0.0, 1e-300, 1e-8, 1.0, 50.0, 1e3, 1e6})
      for (const double c : cosines) {
        INFO("n " << n << " k " << k << " cos " << c);
        const double f = f64::fresnel_exact(n, k, c);
        CHECK(std::isfinite(f));
        CHECK(f >= 0);
        CHECK(f <= 1 + 1e-15);
        const float g =
            f32::fresnel_exact(static_cast<float>(n), static_cast<float>(k), static_cast<float>(c));
        CHECK(std::isfinite(g));
        CHECK(g >= 0);
        CHECK(g <= 1.000001f);
      }
}

TEST_CASE("equal media reflect nothing at any angle, all others everything at grazing") {
  for (const double c : cosines) CHECK(f64::fresnel_exact(1, 0, c) == 0);
  CHECK(f64::fresnel_exact(1, 0, 0) == 0);
  CHECK(f64::fresnel_exact(1.5, 0, 0) == Approx(1).epsilon(1e-15));
  CHECK(f64::fresnel_exact(0.2, 3.5, 0) == Approx(1).epsilon(1e-15));
  CHECK(f64::fresnel_exact(1.5, 0, 1e-8) == Approx(0.99999994186).epsilon(1e-10));
}

TEST_CASE("at normal incidence the exact formula is F0, at Brewster's angle half of the perpendicular part") {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> n_range(0.05, 6), k_range(0, 8);
  for (int i = 0; i < 1000; ++i) {
    const double n = n_range(random), k = k_range(random);
    REQUIRE(f64::fresnel_exact(n, k, 1) == Approx(f64::f0(n, k)).epsilon(1e-13));
  }
  const double n = 1.5, c = 1 / std::sqrt(1 + n * n);  // tan = n
  CHECK(f64::fresnel_exact(n, 0, c) == Approx(std::pow((n * n - 1) / (n * n + 1), 2) / 2).epsilon(1e-13));
}

TEST_CASE("total reflection is total") {
  const double c = std::cos(45 * std::acos(-1.0) / 180);  // 45 degrees, critical angle 30 for n = 0.5
  CHECK(f64::fresnel_exact(0.5, 0, c) == Approx(1).epsilon(1e-14));
  CHECK(f64::fresnel_exact(0.5, 1e-8, c) == Approx(by_complex_double(0.5, 1e-8, c)).epsilon(1e-14));
}

TEST_CASE("a metal without loss reflects everything, and n near 0 nearly so") {
  const double angles[] = {1.0, 0.999999, 0.9, 0.5, 1.0 / 7, 1e-3, 1e-8, 0.0};
  for (const double k : {1e-300, 1e-20, 1e-8, 1e-3, 0.5, 1.0, 5.0, 1e3, 1e6}) {
    INFO("k " << k);
    CHECK(f64::f0(0, k) == 1);
    CHECK(f64::absorptance0(0, k) == 0);
    for (const double c : angles) {
      INFO("cos " << c);
      for (const double n : {0.0, 1e-300, 1e-150, 1e-40, 1e-20}) {
        CHECK(f64::fresnel_exact(n, k, c) == Approx(1).epsilon(1e-15).margin(0));
        CHECK(f32::fresnel_exact(static_cast<float>(n), static_cast<float>(k), static_cast<float>(c)) ==
              Approx(1).epsilon(2e-7).margin(0));
      }
    }
  }
  // Without k, n near 0 is all but total reflection: 1 - 4 n head on.
  for (const double n : {1e-300, 1e-40, 1e-17, 1e-12, 1e-9, 1e-6, 1e-4, 0.009}) {
    INFO("n " << n);
    CHECK(f64::fresnel_exact(n, 0, 1) == Approx(by_complex_double(std::max(n, 1e-30), 0, 1)).epsilon(1e-14));
    CHECK(f32::fresnel_exact(static_cast<float>(n), 0, 1) ==
          Approx(by_complex_double(std::max(n, 1e-30), 0, 1)).epsilon(2e-6));
  }
}

TEST_CASE("for n below 0.01 the exact form agrees with complex arithmetic") {
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> log_n(-9, -2), log_k(-6, 2), uniform(0, 1);
  for (int i = 0; i < 20000; ++i) {
    const double n = std::pow(10, log_n(random)), k = i % 4 == 0 ? 0 : std::pow(10, log_k(random));
    const double c = i % 2 ? uniform(random) : std::pow(10, -6 * uniform(random));
    // At the critical angle the last digit of c weighs as much as all of n.
    if (std::abs(n * n - k * k - (1 - c) * (1 + c)) < 1e-3 * ((1 - c) * (1 + c) + k * k)) continue;
    INFO("n " << n << " k " << k << " cos " << c);
    REQUIRE(f64::fresnel_exact(n, k, c) == Approx(by_complex_double(n, k, c)).epsilon(2e-14));
  }
}

TEST_CASE("Schlick's approximation has the right ends") {
  for (const double f0 : {0.0, 0.04, 0.5, 1.0, 1.022}) {
    CHECK(f64::f_schlick(f0, 1) == f0);
    CHECK(f64::f_schlick(f0, 0) == Approx(1).epsilon(1e-15));
    CHECK(f64::f_schlick(f0, 0.5) == Approx(f0 + (1 - f0) / 32).epsilon(1e-15));
  }
  CHECK(f82_cosine == Approx(1.0 / 7));
}

TEST_CASE("the array forms give the numbers of the scalar ones") {
  const std::vector<double> n{0.2, 1.0, 1.33, 3.9, 0.05}, k{3.5, 0, 0, 0.03, 7};
  std::vector<double> a(5), b(5);
  f64::f0(n, k, a);
  f64::fresnel_exact(n, k, f82_cosine, b);
  for (std::size_t i = 0; i < n.size(); ++i) {
    CHECK(a[i] == Approx(f64::f0(n[i], k[i])).epsilon(1e-15));
    CHECK(b[i] == Approx(f64::fresnel_exact(n[i], k[i], f82_cosine)).epsilon(1e-14));
  }
}
