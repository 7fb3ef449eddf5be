// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "core/spectrum/interpolate.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

std::vector<double> at(const Spectrum& s, Interpolation rule, const std::vector<double>& nm) {
  std::vector<double> out(nm.size());
  resample(s, rule, nm, out);
  return out;
}

double at(const Spectrum& s, Interpolation rule, double nm) {
  return at(s, rule, std::vector<double>{nm})[0];
}

// Irregular wavelengths around the visible range, some on whole nanometres, and values by `value`.
template <class Value>
Spectrum irregular(std::mt19937_64& random, Value value) {
  std::uniform_real_distribution<double> step(0.05, 40);
  Spectrum s;
  for (double nm = 250 + 200 * std::generate_canonical<double, 53>(random); nm < 950; nm += step(random)) {
    const double w = random() % 3 == 0 ? std::round(nm) : nm;
    if (!s.empty() && w <= s.last_nm()) continue;
    s.wavelength_nm.push_back(w);
    s.value.push_back(value(w));
  }
  return s;
}

constexpr std::array interpolations{Interpolation::linear, Interpolation::pchip};

}  // namespace

TEST_CASE("interpolation goes through every sample and holds the ends") {
  const Spectrum s{{400, 450, 520, 700}, {1.5, 0.3, 2.25, -1}};
  for (const auto rule : interpolations) {
    for (std::size_t i = 0; i < s.size(); ++i) CHECK(at(s, rule, s.wavelength_nm[i]) == s.value[i]);
    CHECK(at(s, rule, 399.999) == 1.5);
    CHECK(at(s, rule, 1) == 1.5);
    CHECK(at(s, rule, 701) == -1);
    CHECK(at(s, rule, 1e6) == -1);
  }
}

TEST_CASE("a single sample is a constant") {
  for (const auto rule : interpolations)
    for (const double nm : {100.0, 589.3, 2000.0}) CHECK(at({{589.3}, {1.5}}, rule, nm) == 1.5);
}

TEST_CASE("both rules reproduce a straight line") {
  std::mt19937_64 random(1);
  for (int repeat = 0; repeat < 20; ++repeat) {
    const Spectrum s = irregular(random, [](double nm) { return 3 - 0.004 * nm; });
    const auto nm = wavelengths(std::ceil(s.first_nm()), std::floor(s.last_nm()), 0.5);
    for (const auto rule : interpolations) {
      const auto got = at(s, rule, nm);
      for (std::size_t i = 0; i < nm.size(); ++i) REQUIRE(std::abs(got[i] - (3 - 0.004 * nm[i])) < 1e-14);
    }
  }
}

TEST_CASE("linear interpolation is the straight line between its two samples") {
  const Spectrum s{{400, 500, 520}, {1, 3, -1}};
  CHECK(at(s, Interpolation::linear, 425) == 1.5);
  CHECK(at(s, Interpolation::linear, 510) == 1);
  CHECK(at(s, Interpolation::linear, 505) == 2);
}

TEST_CASE("pchip agrees with its slopes worked out by hand") {
  // Secants 1/10 and 3/10 over equal steps: harmonic mean 2 * 0.1 * 0.3 / 0.4 = 0.15 in the middle; the
  // three-point end slopes are (3 * 0.1 - 0.3) / 2 = 0 and (3 * 0.3 - 0.1) / 2 = 0.4.
  const Spectrum s{{400, 410, 420}, {0, 1, 4}};
  CHECK(at(s, Interpolation::pchip, 405) == Approx(0.5 + 10.0 / 8 * (0 - 0.15)).epsilon(1e-14));
  CHECK(at(s, Interpolation::pchip, 415) == Approx(2.5 + 10.0 / 8 * (0.15 - 0.4)).epsilon(1e-14));
}

TEST_CASE("interpolation never overshoots the two samples around") {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(0, 5);
  for (int repeat = 0; repeat < 50; ++repeat) {
    const Spectrum s = irregular(random, [&](double) { return random() % 4 == 0 ? 0.0 : uniform(random); });
    const auto nm = wavelengths(s.first_nm(), s.last_nm(), 0.37);
    for (const auto rule : interpolations) {
      const auto got = at(s, rule, nm);
      for (std::size_t i = 0; i < nm.size(); ++i) {
        const auto above =
            static_cast<std::size_t>(std::upper_bound(s.wavelength_nm.begin(), s.wavelength_nm.end(), nm[i]) -
                                     s.wavelength_nm.begin());
        const std::size_t hi = std::min(above, s.size() - 1), lo = hi - 1;
        const auto [least, most] = std::minmax(s.value[lo], s.value[hi]);
        REQUIRE(got[i] >= least - 1e-14);
        REQUIRE(got[i] <= most + 1e-14);
      }
    }
  }
}

TEST_CASE("monotone data stay monotone") {
  std::mt19937_64 random(3);
  for (int repeat = 0; repeat < 50; ++repeat) {
    double level = 0;
    const Spectrum s = irregular(random, [&](double) {
      const double jump = std::generate_canonical<double, 53>(random);
      return level += random() % 3 == 0 ? 0.0 : jump * jump * jump;
    });
    const auto nm = wavelengths(s.first_nm(), s.last_nm(), 0.23);
    for (const auto rule : interpolations) {
      const auto got = at(s, rule, nm);
      for (std::size_t i = 1; i < got.size(); ++i) REQUIRE(got[i] >= got[i - 1] - 1e-13);
    }
  }
}

TEST_CASE("a step from 1 to 0 never goes below 0, where an unconstrained cubic would") {
  const Spectrum s{{400, 450, 500, 550, 600, 650}, {1, 1, 1, 0, 0, 0}};
  for (const auto rule : interpolations)
    for (const double v : at(s, rule, wavelengths(400, 650, 1))) {
      REQUIRE(v >= 0);
      REQUIRE(v <= 1 + 1e-15);
    }
}

TEST_CASE("the fast linear rule gives the same numbers as the plain one, bit for bit") {
  std::mt19937_64 random(4);
  const auto grid = wavelengths(grid_first_nm, grid_last_nm, 1);
  std::uniform_real_distribution<double> uniform(0, 5);
  const auto same = [&](const Spectrum& s) {
    std::array<double, grid_size> fast{};
    resample_to_grid(s, fast);
    const auto plain = at(s, Interpolation::linear, grid);
    for (std::size_t i = 0; i < grid_size; ++i)
      if (fast[i] != plain[i]) {
        UNSCOPED_INFO("first difference at " << grid[i] << " nm: " << fast[i] << " against " << plain[i]);
        return false;
      }
    return true;
  };
  for (int repeat = 0; repeat < 200; ++repeat)
    REQUIRE(same(irregular(random, [&](double) { return uniform(random); })));
  CHECK(same({{589.3}, {1.5}}));
  CHECK(same({{360}, {2}}));
  CHECK(same({{100, 200}, {1, 2}}));      // all below
  CHECK(same({{900, 1000}, {1, 2}}));     // all above
  CHECK(same({{360, 830}, {0.1, 0.7}}));  // exactly the grid
  CHECK(same({{359.5, 830.5}, {0.1, 0.7}}));
  CHECK(same({{100, 1e7}, {0.1, 0.7}}));
  CHECK(same({{500.2, 500.4, 500.6}, {1, 2, 3}}));  // within one grid step
  CHECK(same({{360, 360.5, 361, 829.25, 830}, {0.1, 0.7, 0.3, 0.9, 0.2}}));
}

TEST_CASE("interpolation names read back") {
  for (const auto rule : interpolations) CHECK(interpolation_named(name(rule)) == rule);
  CHECK(name(Interpolation::linear) == "linear");
  CHECK(name(Interpolation::pchip) == "pchip");
  CHECK(!interpolation_named("cubic"));
  CHECK(!interpolation_named(""));
}
