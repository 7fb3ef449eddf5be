// SPDX-License-Identifier: Apache-2.0
#include "core/material/dispersion.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

double n_at(const DispersionFormula& formula, double nm) {
  double n = 0;
  evaluate(formula, {&nm, 1}, {&n, 1});
  return n;
}

// Schott data sheet of N-BK7; Malitson 1965; Ciddor 1996.
const DispersionFormula n_bk7{
    2, {0, 1.03961212, 0.00600069867, 0.231792344, 0.0200179144, 1.01046945, 103.560653}, 300, 2500};
const DispersionFormula fused_silica{
    1, {0, 0.6961663, 0.0684043, 0.4079426, 0.1162414, 0.8974794, 9.896161}, 210, 6700};
const DispersionFormula air{6, {0, 0.05792105, 238.0185, 0.00167917, 57.362}, 230, 1690};

// The same formulas written out term by term in long double.
long double reference(const DispersionFormula& f, double nm) {
  using real = long double;
  const real l = static_cast<real>(nm) / 1000, l2 = l * l;
  const auto c = [&](std::size_t i) -> real {
    return i <= f.coefficients.size() ? static_cast<real>(f.coefficients[i - 1]) : 0.0L;
  };
  const std::size_t size = f.coefficients.size();
  real sum = c(1);
  switch (f.number) {
    case 1:
    case 2:
      sum += 1;
      for (std::size_t i = 2; i < size; i += 2)
        sum += c(i) * l2 / (l2 - (f.number == 1 ? c(i + 1) * c(i + 1) : c(i + 1)));
      return std::sqrt(sum);
    case 3:
    case 5:
      for (std::size_t i = 2; i < size; i += 2) sum += c(i) * std::pow(l, c(i + 1));
      return f.number == 3 ? std::sqrt(sum) : sum;
    case 4:
      if (size > 1) sum += c(2) * std::pow(l, c(3)) / (l2 - std::pow(c(4), c(5)));
      if (size > 5) sum += c(6) * std::pow(l, c(7)) / (l2 - std::pow(c(8), c(9)));
      for (std::size_t i = 10; i < size; i += 2) sum += c(i) * std::pow(l, c(i + 1));
      return std::sqrt(sum);
    case 6:
      for (std::size_t i = 2; i < size; i += 2) sum += c(i) / (c(i + 1) - 1 / l2);
      return 1 + sum;
    case 7: {
      const real r = 1 / (l2 - 0.028L);
      return sum + c(2) * r + c(3) * r * r + c(4) * l2 + c(5) * l2 * l2 + c(6) * l2 * l2 * l2;
    }
    case 8: {
      const real q = sum + c(2) * l2 / (l2 - c(3)) + c(4) * l2;
      return std::sqrt((1 + 2 * q) / (1 - q));
    }
    default:
      return std::sqrt(sum + c(2) / (l2 - c(3)) + c(4) * (l - c(5)) / ((l - c(5)) * (l - c(5)) + c(6)));
  }
}

const std::vector<DispersionFormula> one_of_each{
    fused_silica,
    n_bk7,
    {3,
     {2.27, -0.0105, 2, 0.0163, -2, 0.00026, -4, 2.8e-6, -6, 5.9e-7, -8, 0.001, 0.5, 1e-4, -3, 1e-4, 5},
     300,
     2000},
    {4, {2.1, 0.7, 2, 0.1, 2, 0.4, 0, 9, 1, -0.01, 2, 0.001, -4, 1e-4, 1.5}, 300, 2000},
    {5, {1.45, 0.003, -2, -0.002, 2}, 300, 2000},
    air,
    {7, {3.41983, 0.159906, -0.123109, 1.26878e-6, -1.95104e-9}, 400, 10000},
    {8, {0.452505, 0.09939, 0.070537, -0.00015}, 450, 2000},
    {9, {2.3, 0.0125, 0.03, 0.02, 1.5, 0.8}, 300, 1060},
};

}  // namespace

TEST_CASE("printed indices of glass, fused silica and air come out with their printed digits") {
  CHECK(n_at(n_bk7, 587.5618) == Approx(1.51680).margin(5e-6));
  CHECK(n_at(n_bk7, 486.1327) == Approx(1.52238).margin(5e-6));
  CHECK(n_at(n_bk7, 656.2725) == Approx(1.51432).margin(5e-6));
  CHECK(n_at(fused_silica, 589.3) == Approx(1.4584).margin(5e-5));
  CHECK(n_at(fused_silica, 587.561) == Approx(1.458464).margin(1e-6));
  CHECK(n_at(fused_silica, 404.656) == Approx(1.469618).margin(1e-6));
  CHECK(n_at(air, 587.6) == Approx(1.00027717).margin(5e-9));
}

TEST_CASE("each of the nine formulas agrees with its written-out form in long double") {
  for (const auto& formula : one_of_each) {
    INFO("formula " << formula.number);
    CHECK_NOTHROW(validate(formula, "formula"));
    const std::vector<double> at = wavelengths(360, 830, 1);
    std::vector<double> n(at.size());
    evaluate(formula, at, n);
    for (std::size_t i = 0; i < at.size(); ++i) {
      const double inside = std::min(std::max(at[i], formula.first_nm), formula.last_nm);
      REQUIRE(n[i] == Approx(static_cast<double>(reference(formula, inside))).epsilon(1e-13));
    }
  }
}

TEST_CASE("one wavelength at a time gives the same bits as all at once") {
  for (const auto& formula : one_of_each) {
    const std::vector<double> at = wavelengths(360, 830, 1);
    std::vector<double> n(at.size());
    evaluate(formula, at, n);
    for (std::size_t i = 0; i < at.size(); ++i) REQUIRE(n_at(formula, at[i]) == n[i]);
  }
}

TEST_CASE("outside its stated range a formula holds the value at the nearer end") {
  CHECK(n_at(n_bk7, 100) == n_at(n_bk7, 300));
  CHECK(n_at(n_bk7, 9000) == n_at(n_bk7, 2500));
}

TEST_CASE("a pole and a negative n squared give NaN") {
  CHECK(std::isnan(n_at({2, {0, 1, 0.25}, 400, 700}, 500)));
  CHECK(std::isnan(n_at({3, {-1}, 400, 700}, 500)));
}

TEST_CASE("coefficients that are left out at the end of formulas 4, 7, 8 and 9 count as nothing") {
  CHECK(n_at({4, {2.25}, 400, 700}, 500) == 1.5);
  CHECK(n_at({4, {2, 0.5, 2}, 400, 700}, 500) == Approx(std::sqrt(2.5)));
  CHECK(n_at({4, {2, 0.5, 2, 0.1, 2}, 400, 700}, 500) == Approx(std::sqrt(2 + 0.5 * 0.25 / (0.25 - 0.01))));
  CHECK(n_at({7, {1.5}, 400, 700}, 500) == 1.5);
  CHECK(n_at({8, {0.25}, 400, 700}, 500) == Approx(std::sqrt(2.0)));
  CHECK(n_at({9, {2.25}, 400, 700}, 500) == 1.5);
}

TEST_CASE("a formula that cannot be meant is refused with what is wrong") {
  const auto refused = [](const DispersionFormula& formula, std::string_view with) {
    return contains(error_of([&] { validate(formula, "X"); }), with);
  };
  CHECK(refused({0, {1}, 400, 700}, "outside 1..9"));
  CHECK(refused({10, {1}, 400, 700}, "outside 1..9"));
  CHECK(refused({1, {}, 400, 700}, "no coefficients"));
  CHECK(refused({1, {0, 1}, 400, 700}, "no partner"));
  CHECK(refused({4, std::vector<double>(10, 1.0), 400, 700}, "no partner"));
  CHECK(refused({8, {1, 2, 3, 4, 5}, 400, 700}, "more coefficients"));
  CHECK(refused({3, std::vector<double>(19, 1.0), 400, 700}, "more coefficients"));
  CHECK(refused({3, {std::numeric_limits<double>::infinity()}, 400, 700}, "not finite"));
  CHECK(refused({3, {2}, 0, 700}, "not positive"));
  CHECK(refused({3, {2}, std::numeric_limits<double>::quiet_NaN(), 700}, "not positive"));
  CHECK(refused({3, {2}, 700, 400}, "empty"));
}
