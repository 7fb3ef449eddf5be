// SPDX-License-Identifier: Apache-2.0
#include "core/plot/f0_curves.h"

#include <catch2/catch.hpp>

#include "tests/support.h"

using namespace etak;
using namespace etak::test;

TEST_CASE("curves end where the data end") {
  const Optics narrow = constants(
      {450, 500.5, 600.25}, [](double) { return 1.5; }, [](double) { return 0.1; });
  const OpticsCurves curves = curves_of(narrow, {});
  CHECK(curves.n_nm.front() == 450);
  CHECK(curves.n_nm.back() == 600.25);
  CHECK(curves.sample_nm == std::vector<double>{450, 500.5, 600.25});
  const Optics wide = constants(
      {200, 2000}, [](double) { return 1.5; }, [](double) { return 0; });
  CHECK(curves_of(wide, {}).r_nm.size() == grid_size);
  CHECK(curves_of(wide, {}).sample_nm.empty());
  const Optics infrared = constants(
      {1000, 2000}, [](double) { return 1.5; }, [](double) { return 0; });
  CHECK(curves_of(infrared, {}).r_nm.empty());
}

TEST_CASE(
    "reflectance of a dielectric curve is ((n - 1) / (n + 1))^2, against a medium ((n - m) / (n + m))^2") {
  for (const double r : curves_of(glass(1.5), {}).r0) CHECK(r == Approx(0.04));
  F0Options in_water;
  in_water.outside = {"water", 1.333};
  const double expected = (1.5 - 1.333) * (1.5 - 1.333) / ((1.5 + 1.333) * (1.5 + 1.333));
  for (const double r : curves_of(glass(1.5), in_water).r0) CHECK(r == Approx(expected));
  in_water.outside.index = std::get<OpticalConstants>(glass(1.5));
  for (const double r : curves_of(glass(1.5), in_water).r0) CHECK(r == Approx(0).margin(1e-15));
}

TEST_CASE("reflectance data have one curve and no index") {
  const OpticsCurves curves = curves_of(reflectance({400, 700}, [](double nm) { return nm / 1000; }), {});
  CHECK(curves.n.empty());
  CHECK(curves.k.empty());
  CHECK(curves.r82.empty());
  CHECK(curves.r0[100] == Approx(0.5));
}
