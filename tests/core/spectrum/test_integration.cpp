// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <random>

#include "core/math/mat3.h"
#include "core/spectrum/integration.h"
#include "core/spectrum/interpolate.h"
#include "tests/core/spectrum/viewings.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

Quadrature quadrature(Method method, Viewing viewing) {
  return method == Method::exact ? make_exact_quadrature(viewing, std::vector<double>{400, 400.3, 512.7, 700})
                                 : make_quadrature(method, viewing);
}

// A colour-matching function times power as straight lines between grid points: the truth of the exact
// method.
double weight_between(Viewing viewing, std::size_t c, double nm) {
  const auto i = std::min(static_cast<std::size_t>(nm - grid_first_nm), grid_size - 2);
  const double t = nm - grid_first_nm - static_cast<double>(i);
  const auto cmf = matching_functions(viewing.observer);
  const auto power = relative_power(viewing.illuminant);
  return (cmf[i][c] + t * (cmf[i + 1][c] - cmf[i][c])) * (power[i] + t * (power[i + 1] - power[i]));
}

// Midpoint sums in long double over every piece between knots, `parts` parts a piece: independent of Gauss
// points.
Vec3 by_midpoints(Viewing viewing, const std::vector<double>& knots, int parts, double (*r)(double)) {
  std::array<long double, 3> all{}, white{};
  for (std::size_t i = 0; i + 1 < knots.size(); ++i)
    for (int p = 0; p < parts; ++p) {
      const double h = (knots[i + 1] - knots[i]) / parts, nm = knots[i] + (p + 0.5) * h;
      for (std::size_t c = 0; c < 3; ++c) {
        const long double w = static_cast<long double>(weight_between(viewing, c, nm)) * h;
        all[c] += w * r(nm);
        white[c] += w;
      }
    }
  Vec3 out{};
  for (std::size_t c = 0; c < 3; ++c) out[c] = static_cast<double>(all[c] / white[1]);
  return out;
}

// n and k of a made-up smooth metal on a grid of its own.
const Spectrum metal_n{{300, 413.3, 459.25, 516.6, 590.4, 688.8, 826.6, 900},
                       {1.5, 1.47, 1.43, 0.62, 0.25, 0.16, 0.18, 0.2}};
const Spectrum metal_k{metal_n.wavelength_nm, {1.9, 1.95, 1.85, 2.08, 2.91, 3.95, 5.1, 5.6}};

// n and k of a made-up metal with a spike of 0.5 nm half width at 555.3 nm: straight lines between odd knots.
const Spectrum nasty_n{{300, 455.25, 554.8, 555.3, 555.8, 640.6, 900}, {1.2, 0.4, 0.5, 9, 0.5, 0.2, 0.9}};
const Spectrum nasty_k{{300, 455.25, 554.8, 555.3, 555.8, 640.6, 900}, {1.9, 1.8, 2.5, 0, 2.6, 3.5, 5}};

double on_lines(const Spectrum& s, double nm) {
  double out = 0;
  resample(s, Interpolation::linear, {&nm, 1}, {&out, 1});
  return out;
}

double f0(double n, double k) {
  return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
}

double nasty_reflectance(double nm) {
  return f0(on_lines(nasty_n, nm), on_lines(nasty_k, nm));
}
double metal_reflectance(double nm) {
  return f0(on_lines(metal_n, nm), on_lines(metal_k, nm));
}

Vec3 integrate(const Quadrature& q, double (*r)(double)) {
  std::vector<double> samples;
  for (const double nm : q.wavelength_nm) samples.push_back(r(nm));
  return q.integrate(samples);
}

}  // namespace

TEST_CASE(
    "a flat reflectance is its share of the white to 1e-12, for every method, observer and illuminant") {
  for (const Method method : all_methods)
    for (const Viewing viewing : test::all_viewings()) {
      INFO(name(method) << " " << name(viewing.observer) << " " << name(viewing.illuminant));
      const Quadrature q = quadrature(method, viewing);
      const Vec3 white = q.white();
      CHECK(white[1] == Approx(1).epsilon(1e-12));
      for (const double r : {1.0, 0.7, 0.18, 1e-6, 0.0}) {
        const Vec3 got = q.integrate(std::vector<double>(q.wavelength_nm.size(), r));
        for (std::size_t c = 0; c < 3; ++c) CHECK(std::abs(got[c] - r * white[c]) <= 1e-12 * white[c] * r);
      }
    }
}

TEST_CASE(
    "every quadrature asks for ascending wavelengths within 360..830 nm and has three weights for each") {
  for (const Method method : all_methods)
    for (const Viewing viewing : test::all_viewings()) {
      const Quadrature q = quadrature(method, viewing);
      REQUIRE(!q.wavelength_nm.empty());
      CHECK(std::is_sorted(q.wavelength_nm.begin(), q.wavelength_nm.end()));
      CHECK(q.wavelength_nm.front() >= grid_first_nm);
      CHECK(q.wavelength_nm.back() <= grid_last_nm);
      for (const auto& weight : q.weight) CHECK(weight.size() == q.wavelength_nm.size());
    }
}

TEST_CASE("the reference method is the plain sum at 1 nm") {
  const Viewing viewing;
  const Quadrature q = make_quadrature(Method::nm1, viewing);
  REQUIRE(q.wavelength_nm == wavelengths(grid_first_nm, grid_last_nm, 1));
  std::array<long double, 3> xyz{};
  long double white = 0;
  for (std::size_t i = 0; i < grid_size; ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const long double w = static_cast<long double>(matching_functions(viewing.observer)[i][c]) *
                            relative_power(viewing.illuminant)[i];
      xyz[c] += w * nasty_reflectance(q.wavelength_nm[i]);
      if (c == 1) white += w;
    }
  const Vec3 got = integrate(q, nasty_reflectance);
  for (std::size_t c = 0; c < 3; ++c)
    CHECK(got[c] == Approx(static_cast<double>(xyz[c] / white)).epsilon(1e-13));
}

TEST_CASE("wider steps sample the same weights at 5, 10 and 20 nm") {
  for (const auto& [method, step] :
       {std::pair{Method::nm5, 5.0}, {Method::nm10, 10.0}, {Method::nm20, 20.0}}) {
    const Quadrature q = make_quadrature(method, {});
    CHECK(q.wavelength_nm == wavelengths(360, step == 20.0 ? 820 : 830, step));
    for (std::size_t i = 0; i < q.wavelength_nm.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c) {
        const auto at = static_cast<std::size_t>(q.wavelength_nm[i]) - grid_first_nm;
        const double raw = matching_functions({})[at][c] * relative_power({})[at];
        const double raw_y = matching_functions({})[200][1] * relative_power({})[200];
        const auto i560 = static_cast<std::size_t>(200 / step);
        REQUIRE(q.weight[c][i] / q.weight[1][i560] == Approx(raw / raw_y).epsilon(1e-12));
      }
  }
}

TEST_CASE("folded weights give the 1 nm sum of whatever a cubic can describe") {
  // Third-order Lagrange interpolation reproduces cubics inside and parabolas at both ends.
  const auto parabola = [](double nm) {
    return 0.2 + 0.5 * std::pow((nm - 500) / 400, 2) - (nm - 500) / 1000;
  };
  const Quadrature fine = make_quadrature(Method::nm1, {});
  for (const Method method : {Method::e308_10}) {
    const Quadrature q = make_quadrature(method, {});
    const Vec3 want = integrate(fine, parabola), got = integrate(q, parabola);
    for (std::size_t c = 0; c < 3; ++c) CHECK(got[c] == Approx(want[c]).epsilon(1e-11));
  }
  // 20 nm samples end at 820: the last 10 nm hold the value there, with weights of 1e-6 of Y.
  const Quadrature q = make_quadrature(Method::e308_20, {});
  const Vec3 want = integrate(fine, parabola), got = integrate(q, parabola);
  for (std::size_t c = 0; c < 3; ++c) CHECK(got[c] == Approx(want[c]).epsilon(1e-7));
}

TEST_CASE("folded weights come nearer to the 1 nm sum than sampled ones at the same step") {
  const auto gold_like = [](double nm) { return 0.35 + 0.6 / (1 + std::exp((520 - nm) / 12)); };
  const Vec3 truth = integrate(make_quadrature(Method::nm1, {}), gold_like);
  const auto error = [&](Method method) {
    const Vec3 got = integrate(make_quadrature(method, {}), gold_like);
    double worst = 0;
    for (std::size_t c = 0; c < 3; ++c) worst = std::max(worst, std::abs(got[c] - truth[c]));
    return worst;
  };
  CHECK(error(Method::e308_20) < error(Method::nm20));
  CHECK(error(Method::e308_10) < 1e-3);
  CHECK(error(Method::nm5) < 1e-3);
}

// Largest relative difference between the exact method and extrapolated midpoint sums, over all viewings.
double exact_against_midpoints(const std::vector<double>& data_knots, double (*r)(double)) {
  auto knots = wavelengths(grid_first_nm, grid_last_nm, 1);
  for (const double nm : data_knots)
    if (nm > grid_first_nm && nm < grid_last_nm) knots.push_back(nm);
  std::sort(knots.begin(), knots.end());
  double worst = 0;
  for (const Viewing viewing : test::all_viewings()) {
    const Vec3 got = integrate(make_exact_quadrature(viewing, data_knots), r);
    const Vec3 coarse = by_midpoints(viewing, knots, 200, r), fine = by_midpoints(viewing, knots, 400, r);
    for (std::size_t c = 0; c < 3; ++c) {
      const double extrapolated = fine[c] + (fine[c] - coarse[c]) / 3;  // midpoint errors go with the square
      worst = std::max(worst, std::abs(got[c] / extrapolated - 1));
    }
  }
  return worst;
}

TEST_CASE("the exact method agrees with a fine independent quadrature") {
  // Smooth data to the rounding of the sums; a spike of n from 0.5 to 9 within half a nanometre, where five
  // Gauss points a piece reach their limit, to 5e-7.
  CHECK(exact_against_midpoints(metal_n.wavelength_nm, metal_reflectance) < 1e-11);
  CHECK(exact_against_midpoints(nasty_n.wavelength_nm, nasty_reflectance) < 5e-7);
}

TEST_CASE("sums in wide steps miss a narrow spike or count it many times, the exact method does neither") {
  const auto spike = [](double nm) { return std::max(0.0, 1 - 2 * std::abs(nm - 555.3)); };
  const auto next = [](double nm) { return std::max(0.0, 1 - 2 * std::abs(nm - 557.3)); };
  const double one = integrate(make_exact_quadrature({}, std::vector<double>{554.8, 555.3, 555.8}), spike)[1];
  const double other =
      integrate(make_exact_quadrature({}, std::vector<double>{556.8, 557.3, 557.8}), next)[1];
  // A triangle of area 0.5 nm under a weight of about 1/107 x S/S_mean per nm.
  const double y_555 = make_quadrature(Method::nm1, {}).weight[1][195];
  CHECK(one == Approx(0.5 * y_555).epsilon(2e-3));
  CHECK(other == Approx(one).epsilon(1e-2));
  CHECK(integrate(make_quadrature(Method::nm5, {}), spike)[1] > 3 * one);
  CHECK(integrate(make_quadrature(Method::nm5, {}), next)[1] == 0);
}

TEST_CASE("knots of the data outside 360..830 nm and repeated ones change nothing") {
  const std::vector<double> plain{455.25, 640.6}, more{1, 200, 360, 455.25, 455.25, 500, 640.6, 830, 1e6};
  const Vec3 a = integrate(make_exact_quadrature({}, plain), nasty_reflectance);
  const Vec3 b = integrate(make_exact_quadrature({}, more), nasty_reflectance);
  for (std::size_t c = 0; c < 3; ++c) CHECK(a[c] == b[c]);
}

TEST_CASE("the point methods read red, green and blue at their three wavelengths") {
  const auto identity = [](double nm) { return nm; };
  CHECK(integrate(make_quadrature(Method::legacy_point, {}), identity) == Vec3{650, 550, 450});
  CHECK(integrate(make_quadrature(Method::legacy_schueler, {}), identity) == Vec3{643, 562, 396});
  for (const Method method : all_methods)
    CHECK(samples_rgb(method) == (method == Method::legacy_point || method == Method::legacy_schueler));
}

TEST_CASE("the weight inside a range grows from nothing to all") {
  for (const Viewing viewing : test::all_viewings()) {
    for (const double share : weight_inside(viewing, 360, 830)) CHECK(share == Approx(1).epsilon(1e-14));
    for (const double share : weight_inside(viewing, 100, 5000)) CHECK(share == Approx(1).epsilon(1e-14));
    for (const double share : weight_inside(viewing, 900, 1000)) CHECK(share == 0);
    for (const double share : weight_inside(viewing, 100, 200)) CHECK(share == 0);
    Vec3 before{};
    for (double last = 400; last <= 830; last += 10) {
      const Vec3 now = weight_inside(viewing, 360, last);
      for (std::size_t c = 0; c < 3; ++c) CHECK(now[c] >= before[c]);
      before = now;
    }
  }
}

TEST_CASE("400..700 nm holds over 0.99 of each weight for every viewing, 450..830 nm under D65 does not") {
  for (const Viewing viewing : test::all_viewings())
    for (const double share : weight_inside(viewing, 400, 700)) CHECK(share > 0.995);
  const Vec3 cut = weight_inside({}, 450, 830);
  CHECK(cut[1] > 0.95);
  CHECK(cut[2] < 0.8);
}

TEST_CASE("method names read back") {
  for (const Method method : all_methods) CHECK(method_named(name(method)) == method);
  CHECK(method_named("auto") == Method::automatic);
  CHECK(name(Method::automatic) == "auto");
  CHECK(name(Method::nm1) == "1nm");
  CHECK(name(Method::e308_20) == "e308-20nm");
  CHECK(name(Method::legacy_schueler) == "point-643-562-396");
  CHECK(!method_named("2nm"));
  CHECK(!method_named(""));
}
