// SPDX-License-Identifier: Apache-2.0
#include "core/material/optics/optics_at.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/material/dispersion.h"
#include "core/material/library.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

OpticalConstants two_tables() {
  return {Spectrum{{400, 500, 700}, {1, 2, 4}}, Spectrum{{450, 650}, {0.5, 1.5}}};
}

using Doubles = std::vector<double>;

}  // namespace

TEST_CASE("n and k are read at wavelengths in any order, each within its own table") {
  const OpticalConstants optics = two_tables();
  CHECK(n_at(optics, Doubles{700, 400, 600, 450, 600}, "it") == Doubles{4, 1, 3, 1.5, 3});
  CHECK(k_at(optics, Doubles{650, 550, 450}, "it") == Doubles{1.5, 1, 0.5});
  CHECK(n_at(optics, Doubles{}, "it").empty());
  const Spectrum& table = std::get<Spectrum>(optics.n);
  Doubles pchip(2);
  resample(table, Interpolation::pchip, Doubles{430, 640}, pchip);
  CHECK(values_at(table, Doubles{640, 430}, "it", {Interpolation::pchip}) == Doubles{pchip[1], pchip[0]});
}

TEST_CASE(
    "a wavelength outside of the data is refused, or takes the value at the nearer end where asked to") {
  const OpticalConstants optics = two_tables();
  CHECK(error_of([&] {
          (void)n_at(optics, Doubles{500, 399.5}, "it");
        }) == "it: 399.5 nm is outside of the data; expected 400-700 nm, or extrapolate");
  CHECK(error_of([&] { (void)k_at(optics, Doubles{400}, "it"); }) ==
        "it: 400 nm is outside of the data; expected 450-650 nm, or extrapolate");
  CHECK(n_at(optics, Doubles{900, 1}, "it", {.extrapolate = true}) == Doubles{4, 1});
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL})
    CHECK(contains(error_of([&] { (void)n_at(optics, Doubles{bad}, "it", {.extrapolate = true}); }),
                   "expected a positive number"));
}

TEST_CASE("a formula is evaluated where it holds, and a k that is not given is no 0") {
  const Material glass = *MaterialLibrary::builtin().find("glass_bk7");
  const auto& optics = std::get<OpticalConstants>(glass.preferred_dataset().optics);
  const auto* formula = std::get_if<DispersionFormula>(&optics.n);
  REQUIRE(formula != nullptr);
  const Doubles at{587.6, 486.1};
  Doubles expected(2);
  evaluate(*formula, at, expected);
  CHECK(n_at(optics, at, "it") == expected);
  CHECK(expected[0] == Approx(1.5168).margin(1e-4));
  CHECK(contains(error_of([&] { (void)n_at(optics, Doubles{formula->last_nm + 1}, "it"); }), "outside"));
  CHECK(error_of([&] {
          (void)k_at({optics.n, std::nullopt}, at, "it");
        }) == "it: no k is given; expected a dataset with k");
}
