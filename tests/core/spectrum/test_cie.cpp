// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>

#include "core/base/error.h"
#include "core/math/mat3.h"
#include "core/spectrum/cie.h"
#include "core/spectrum/integration.h"
#include "core/spectrum/own_viewing.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

constexpr std::array observers{Observer::cie1931_2deg, Observer::cie1964_10deg};
constexpr std::array illuminants{Illuminant::d65, Illuminant::d50, Illuminant::a, Illuminant::e};

Vec3 sum(Observer observer) {
  Vec3 out{};
  for (const auto& row : matching_functions(observer))
    for (std::size_t c = 0; c < 3; ++c) out[c] += row[c];
  return out;
}

// Chromaticity of an illuminant by sums at 1 nm.
std::array<double, 2> chromaticity(Illuminant illuminant, Observer observer) {
  Vec3 xyz{};
  for (std::size_t i = 0; i < grid_size; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      xyz[c] += relative_power(illuminant)[i] * matching_functions(observer)[i][c];
  const double all = xyz[0] + xyz[1] + xyz[2];
  return {xyz[0] / all, xyz[1] / all};
}

}  // namespace

TEST_CASE("the 1 nm sums of the observers are those of the CIE tables") {
  // Sums of the 471 printed figures of each column, taken outside of etak.
  const Vec3 two = sum(Observer::cie1931_2deg), ten = sum(Observer::cie1964_10deg);
  CHECK(two[0] == Approx(106.86546949).margin(1e-8));
  CHECK(two[1] == Approx(106.85691710).margin(1e-8));
  CHECK(two[2] == Approx(106.89225128).margin(1e-8));
  CHECK(ten[0] == Approx(116.64851951).margin(1e-8));
  CHECK(ten[1] == Approx(116.66187710).margin(1e-8));
  CHECK(ten[2] == Approx(116.67398051).margin(1e-8));
}

TEST_CASE("printed values of the observers and illuminants stand at their wavelengths") {
  const auto two = matching_functions(Observer::cie1931_2deg);
  CHECK(two[555 - 360][1] == 1);  // the peak of the luminous efficiency
  CHECK(two[450 - 360][0] == Approx(0.3362).epsilon(1e-9));
  CHECK(two[450 - 360][2] == Approx(1.77211).epsilon(1e-9));
  CHECK(two[700 - 360][0] == Approx(0.01135916).epsilon(1e-9));
  for (const auto illuminant : {Illuminant::d65, Illuminant::d50, Illuminant::a}) {
    const double at560 = relative_power(illuminant)[560 - 360];
    CHECK(relative_power(illuminant)[450 - 360] / at560 == Approx(illuminant == Illuminant::d65   ? 1.17008
                                                                  : illuminant == Illuminant::d50 ? 0.87247
                                                                                                  : 0.330859)
                                                               .epsilon(1e-4));
  }
}

TEST_CASE("illuminants are straight lines between their 5 nm entries") {
  for (const auto illuminant : illuminants) {
    const auto power = relative_power(illuminant);
    for (std::size_t i = 0; i + 5 < grid_size; i += 5)
      for (std::size_t j = 1; j < 5; ++j) {
        const double line = power[i] + static_cast<double>(j) / 5 * (power[i + 5] - power[i]);
        REQUIRE(power[i + j] == Approx(line).epsilon(1e-12));
      }
  }
  for (const double p : relative_power(Illuminant::e)) REQUIRE(p == 1);
}

TEST_CASE("the illuminants have the chromaticities that CIE prints") {
  const auto near = [](std::array<double, 2> got, double x, double y, double margin) {
    CHECK(got[0] == Approx(x).margin(margin));
    CHECK(got[1] == Approx(y).margin(margin));
  };
  // CIE 015:2018, table of chromaticities, 2 and 10 degrees.
  near(chromaticity(Illuminant::d65, Observer::cie1931_2deg), 0.31272, 0.32903, 1.5e-5);
  near(chromaticity(Illuminant::d50, Observer::cie1931_2deg), 0.34567, 0.35851, 3e-5);
  near(chromaticity(Illuminant::a, Observer::cie1931_2deg), 0.44758, 0.40745, 3e-5);
  near(chromaticity(Illuminant::e, Observer::cie1931_2deg), 1.0 / 3, 1.0 / 3, 5e-5);
  near(chromaticity(Illuminant::d65, Observer::cie1964_10deg), 0.31381, 0.33098, 3e-5);
  near(chromaticity(Illuminant::a, Observer::cie1964_10deg), 0.45117, 0.40594, 3e-5);
}

TEST_CASE("the tables are those of the reference data, figure by figure") {
  const auto shared = shared_folder();
  if (!shared) {
    WARN("no reference data beside the checkout; not checked");
    return;
  }
  const auto observer_is = [&](Observer observer, const std::string& file) {
    const auto rows = read_csv(*shared + "/data/" + file);
    REQUIRE(rows.size() == grid_size + 1);
    for (std::size_t i = 0; i < grid_size; ++i) {
      REQUIRE(to_number(rows[i + 1][0]) == grid_first_nm + static_cast<double>(i));
      for (std::size_t c = 0; c < 3; ++c)
        REQUIRE(matching_functions(observer)[i][c] == to_number(rows[i + 1][c + 1]));
    }
  };
  observer_is(Observer::cie1931_2deg, "cie1931_2deg_1nm.csv");
  observer_is(Observer::cie1964_10deg, "cie1964_10deg_1nm.csv");
  const auto illuminant_is = [&](Illuminant illuminant, const std::string& file) {
    const auto rows = read_csv(*shared + "/data/" + file);
    std::size_t seen = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      const double nm = to_number(rows[i][0]);
      if (nm < grid_first_nm || nm > grid_last_nm) continue;
      ++seen;
      REQUIRE(relative_power(illuminant)[static_cast<std::size_t>(nm) - grid_first_nm] ==
              to_number(rows[i][1]));
    }
    CHECK(seen == 95);
  };
  illuminant_is(Illuminant::d65, "illuminant_D65.csv");
  illuminant_is(Illuminant::d50, "illuminant_D50.csv");
  illuminant_is(Illuminant::a, "illuminant_A.csv");
}

TEST_CASE("observer and illuminant names read back") {
  for (const auto observer : observers) CHECK(observer_named(name(observer)) == observer);
  for (const auto illuminant : illuminants) CHECK(illuminant_named(name(illuminant)) == illuminant);
  CHECK(name(Observer::cie1964_10deg) == "1964-10deg");
  CHECK(name(Illuminant::d50) == "D50");
  CHECK(!observer_named("2"));
  CHECK(!illuminant_named("D75"));
}

TEST_CASE("tables of one's own are observers and illuminants as long as somebody holds them") {
  std::array<double, grid_size> power{};
  std::copy(relative_power(Illuminant::a).begin(), relative_power(Illuminant::a).end(), power.begin());
  const auto light = own_illuminant(power);
  const auto eye = own_observer(matching_functions(Observer::cie1964_10deg));
  CHECK(name(*light) == "own");
  CHECK(name(*eye) == "own");
  CHECK(*light != *own_illuminant(power));
  CHECK(std::ranges::equal(relative_power(*light), relative_power(Illuminant::a)));
  CHECK(std::ranges::equal(matching_functions(*eye), matching_functions(Observer::cie1964_10deg)));
  const Viewing own{*eye, *light}, known{Observer::cie1964_10deg, Illuminant::a};
  CHECK(make_quadrature(Method::nm1, own).weight == make_quadrature(Method::nm1, known).weight);
  power[7] = -1;
  CHECK_THROWS_AS(own_illuminant(power), Error);
  CHECK_THROWS_AS(own_illuminant(std::array<double, grid_size>{}), Error);
  CHECK_THROWS_AS(own_observer(std::array<std::array<double, 3>, grid_size>{}), Error);
}

TEST_CASE("a light of lines and a metamer say so") {
  for (const Illuminant each : illuminants) CHECK(light_remark(each).empty());
  std::array<double, grid_size> power{};
  for (const std::size_t nm : {450u, 532u, 640u}) power[nm - grid_first_nm] = 1;
  CHECK(
      light_remark(*own_illuminant(power)).starts_with("light of lines: 90 % of its power lies within 3 nm"));
  // D65 plus what the eye does not see: a wave without X, Y and Z, by Gram and Schmidt against the observer.
  const auto eye = matching_functions(Observer::cie1931_2deg);
  const auto d65 = relative_power(Illuminant::d65);
  std::array<double, grid_size> wave{};
  for (std::size_t i = 0; i < grid_size; ++i) wave[i] = std::sin(static_cast<double>(i) / 8);
  std::array<std::array<double, grid_size>, 3> basis{};
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < grid_size; ++i) basis[c][i] = eye[i][c];
    const auto take_out = [](std::array<double, grid_size>& from, const std::array<double, grid_size>& what) {
      double dot = 0, size = 0;
      for (std::size_t i = 0; i < grid_size; ++i) dot += from[i] * what[i], size += what[i] * what[i];
      for (std::size_t i = 0; i < grid_size; ++i) from[i] -= dot / size * what[i];
    };
    for (std::size_t earlier = 0; earlier < c; ++earlier) take_out(basis[c], basis[earlier]);
    take_out(wave, basis[c]);
  }
  for (std::size_t i = 0; i < grid_size; ++i) power[i] = d65[i] + 40 * wave[i];
  CHECK(light_remark(*own_illuminant(power)).starts_with("a metamer of D65"));
}

TEST_CASE("a table of power is 0 beyond its ends, and has to hold visible light") {
  Spectrum table{{380, 780}, {1, 1}};
  const auto light = illuminant_of_table(table, "lamp", "lamp.csv");
  CHECK(name(*light) == "lamp.csv");
  CHECK(relative_power(*light)[0] == 0);
  CHECK(relative_power(*light)[380 - grid_first_nm] == 1);
  table.wavelength_nm[0] = 400;
  CHECK_THROWS_WITH(illuminant_of_table(table, "lamp"),
                    "lamp: a table of 400-780 nm; expected one that holds 380-780 nm");
}
