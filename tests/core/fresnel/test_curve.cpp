// SPDX-License-Identifier: Apache-2.0
#include "core/fresnel/curve.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/fresnel/fresnel.h"

using namespace etak;

TEST_CASE("a curve of one colour has it at every angle") {
  FresnelCurve curve;
  curve.colors.fill({0.25, 1, 0});
  for (int i = 0; i <= 1000; ++i) {
    const Vec3 f = curve.at(i / 1000.0);
    CHECK(f[0] == Approx(0.25).epsilon(1e-14));
    CHECK(f[1] == Approx(1).epsilon(1e-14));
    CHECK(f[2] == 0);
  }
}

TEST_CASE("a cubic in the square root of the cosine is its own curve") {
  const auto cubic = [](double c) {
    const double u = std::sqrt(c);
    return Vec3{1 - u + 0.3 * u * u * u, 0.2 + 0.1 * u * u, 0.5};
  };
  const FresnelCurve curve = fitted_curve(cubic);
  CHECK(curve.off.de2000 < 1e-9);
  for (int i = 0; i <= 100; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      CHECK(curve.at(i / 100.0)[c] == Approx(cubic(i / 100.0)[c]).margin(1e-12));
}

TEST_CASE("what a curve says of its error is the largest difference that is found") {
  // A step is no curve: its error is that of two greys, and lies beside the step.
  const FresnelCurve step = fitted_curve([](double c) {
    const double grey = c < 0.25 ? 0.9 : 0.1;
    return Vec3{grey, grey, grey};
  });
  CHECK(step.off.de2000 > 5);
  CHECK(step.off.at_deg == Approx(std::acos(0.25) * 180 / 3.14159265358979).margin(8));
  const FresnelCurve metal = fitted_curve([](double c) {
    return Vec3{f64::fresnel_exact(0.2, 3.4, c), f64::fresnel_exact(0.4, 2.4, c),
                f64::fresnel_exact(1.4, 1.8, c)};
  });
  CHECK(metal.off.de2000 < 0.01);
}
