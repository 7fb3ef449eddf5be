// SPDX-License-Identifier: Apache-2.0
#include "core/spectrum/refinement.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/math/mat3.h"
#include "core/spectrum/interpolate.h"
#include "tests/core/spectrum/viewings.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

// Straight between samples.
Vec3 integral(const Quadrature& q, const Spectrum& spectrum) {
  std::vector<double> values(q.wavelength_nm.size());
  resample(spectrum, Interpolation::linear, q.wavelength_nm, values);
  return q.integrate(values);
}

double worst(const Vec3& a, const Vec3& b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

std::vector<double> estimates(const Refinement& refinement, const Spectrum& spectrum) {
  const auto places = Refinement::places(spectrum.wavelength_nm);
  std::vector<double> values(places.size());
  resample(spectrum, Interpolation::linear, places, values);
  return refinement.estimate(places, values);
}

}  // namespace

TEST_CASE("the steps are 20, 10, 5 and 1 nm, and a perfect reflector is the exact white under each") {
  for (const Viewing viewing : test::all_viewings()) {
    const Refinement refinement(viewing);
    const Vec3 exact = make_exact_quadrature(viewing, {}).white();
    std::vector<Method> methods;
    for (const auto& step : refinement.steps()) {
      methods.push_back(step.method);
      CHECK(worst(step.rule.white(), exact) < 1e-12);
      CHECK(step.rule.wavelength_nm == make_quadrature(step.method, viewing).wavelength_nm);
    }
    CHECK(methods == std::vector{Method::nm20, Method::nm10, Method::nm5, Method::nm1});
  }
}

TEST_CASE("a flat reflectance has no error to estimate") {
  const Refinement refinement({});
  for (const double e : estimates(refinement, {{300, 900}, {0.5, 0.5}})) CHECK(e == 0);
}

TEST_CASE("the error of one hinge is known exactly: the estimate is twice what the sum misses") {
  for (const Viewing viewing : test::all_viewings()) {
    const Refinement refinement(viewing);
    for (const double knot : {380.25, 444.0, 503.7, 555.5, 612.31, 700.999}) {
      const Spectrum hinge{{300, knot, 900}, {0, 0, (900 - knot) / 500}};
      const Vec3 exact = integral(make_exact_quadrature(viewing, hinge.wavelength_nm), hinge);
      const auto got = estimates(refinement, hinge);
      for (std::size_t s = 0; s < got.size(); ++s) {
        const double missed = worst(integral(refinement.steps()[s].rule, hinge), exact);
        INFO(knot << " nm, step " << name(refinement.steps()[s].method));
        CHECK(got[s] == Approx(2 * missed).epsilon(1e-6).margin(1e-12));
      }
    }
  }
}

TEST_CASE("of straight pieces the estimate is a bound, however narrow they are") {
  const Refinement refinement({});
  std::vector<Spectrum> all{{{360, 550.3, 550.31, 830}, {0.1, 0.1, 0.9, 0.9}}};
  for (const double width : {20.0, 5.0, 1.0, 0.3, 0.05})
    all.push_back({{350, 555.3 - width, 555.3, 555.3 + width, 840}, {0.1, 0.1, 0.9, 0.1, 0.1}});
  Spectrum comb{{350}, {0.1}};
  for (double tooth = 360; tooth <= 830; tooth += 2)
    for (const auto& [offset, value] : {std::pair{-0.26, 0.1}, {-0.25, 0.9}, {0.25, 0.9}, {0.26, 0.1}}) {
      comb.wavelength_nm.push_back(tooth + offset);
      comb.value.push_back(value);
    }
  all.push_back(comb);
  for (const Spectrum& spectrum : all) {
    const Vec3 exact = integral(make_exact_quadrature({}, spectrum.wavelength_nm), spectrum);
    const auto got = estimates(refinement, spectrum);
    for (std::size_t s = 0; s < got.size(); ++s)
      CHECK(got[s] >= worst(integral(refinement.steps()[s].rule, spectrum), exact));
  }
}

TEST_CASE("places are the knots within 360..830 nm among etak's own, ascending, none twice") {
  const auto plain = Refinement::places({});
  CHECK(plain.front() == 360);
  CHECK(plain.back() == 830);
  const auto with = Refinement::places(std::vector<double>{100, 360, 362.5, 500.1, 500.1, 830, 900});
  CHECK(with.size() == plain.size() + 1);
  CHECK(std::is_sorted(with.begin(), with.end()));
  CHECK(std::adjacent_find(with.begin(), with.end()) == with.end());
}

TEST_CASE("the finest spacing counts what lies in 360..830 nm") {
  CHECK(std::isinf(finest_spacing_nm({})));
  CHECK(std::isinf(finest_spacing_nm(std::vector<double>{500})));
  CHECK(finest_spacing_nm(std::vector<double>{100, 100.1, 400, 410, 415, 900, 900.1}) == 5);
}

TEST_CASE("the exact method's own estimate is above what it misses of a spike, and nothing for a ramp") {
  const Spectrum ramp{{300, 900}, {0, 1}};
  const Quadrature q = make_exact_quadrature({}, {});
  std::vector<double> values(q.wavelength_nm.size());
  resample(ramp, Interpolation::linear, q.wavelength_nm, values);
  CHECK(exact_method_error(q, values) < 1e-13);
  // A rational bump a tenth of a nanometre wide that no knot announces: the rule cannot resolve it.
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double x = (q.wavelength_nm[i] - 555.3) / 0.1;
    values[i] = 1 / (1 + x * x);
  }
  const double pi = 3.14159265358979323846;
  const double y = make_quadrature(Method::nm1, {}).weight[1][195];
  const double missed = std::abs(q.integrate(values)[1] - pi * 0.1 * y);
  CHECK(exact_method_error(q, values) > missed);
}
