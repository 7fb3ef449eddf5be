// SPDX-License-Identifier: Apache-2.0
// Method::automatic and the warning of data finer than the grid.
#include <catch2/catch.hpp>
#include <cmath>

#include "core/material/library.h"
#include "tests/core/material/f0_support.h"

using namespace etak;
using namespace etak::test;

namespace {

F0Options automatic(double bound) {
  F0Options options = with_method(Method::automatic);
  options.integration_bound = bound;
  return options;
}

// The largest difference of X, Y and Z.
double missed(const F0Result& a, const F0Result& b) {
  return std::max({std::abs(a.xyz.x - b.xyz.x), std::abs(a.xyz.y - b.xyz.y), std::abs(a.xyz.z - b.xyz.z)});
}

// A resonance in n and k, sampled so finely that straight lines hold it.
Optics lorentz(double middle_nm, double half_width_nm) {
  std::vector<double> at{300};
  for (double x = -60; x <= 60; x += 0.1) at.push_back(middle_nm + x * half_width_nm);
  at.erase(std::remove_if(at.begin() + 1, at.end(), [](double nm) { return nm <= 301 || nm >= 899; }),
           at.end());
  at.push_back(900);
  const auto shape = [=](double nm) { return (nm - middle_nm) / half_width_nm; };
  return constants(
      at, [=](double nm) { return 1.6 - 0.9 * shape(nm) / (1 + shape(nm) * shape(nm)); },
      [=](double nm) { return 1.8 / (1 + shape(nm) * shape(nm)); });
}

std::vector<Optics> stiff() {
  std::vector<Optics> out;
  for (const double width : {10.0, 3.0, 1.0, 0.3, 0.1})
    for (const double middle : {450.3, 550.0, 612.7}) out.push_back(lorentz(middle, width));
  out.push_back(Reflectance{{{300, 550.3, 550.31, 900}, {0.1, 0.1, 0.9, 0.9}}});
  out.push_back(Reflectance{{{300, 580, 580.0001, 900}, {0.9, 0.9, 0.1, 0.1}}});
  Spectrum comb{{350}, {0.1}};
  for (double tooth = 360; tooth <= 830; tooth += 2)
    for (const auto& [offset, value] : {std::pair{-0.26, 0.1}, {-0.25, 0.9}, {0.25, 0.9}, {0.26, 0.1}}) {
      comb.wavelength_nm.push_back(tooth + offset);
      comb.value.push_back(value);
    }
  out.push_back(Reflectance{comb});
  return out;
}

void check_within(const F0Solver& solver, const F0Result& got, const F0Result& exact) {
  REQUIRE(got.refused() == exact.refused());
  if (got.refused()) {
    CHECK(!got.integration);
    return;
  }
  REQUIRE(got.integration);
  CHECK(missed(got, exact) <= got.integration->error + 1e-13);
  CHECK(got.integration->within_bound == (got.integration->error <= solver.options().integration_bound));
  if (got.integration->method != Method::exact) CHECK(got.integration->within_bound);
}

}  // namespace

TEST_CASE("auto keeps what it promises for the whole library, whatever the bound, light and interpolation") {
  const auto library = MaterialLibrary::builtin();
  for (const auto interpolation : {Interpolation::linear, Interpolation::pchip})
    for (const auto illuminant : {Illuminant::d65, Illuminant::a}) {
      F0Options exact = with_method(Method::exact);
      exact.interpolation = interpolation;
      exact.viewing.illuminant = illuminant;
      const F0Solver reference(exact);
      std::vector<F0Solver> solvers;
      for (const double bound : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8}) {
        F0Options options = automatic(bound);
        options.interpolation = interpolation;
        options.viewing.illuminant = illuminant;
        solvers.emplace_back(options);
      }
      for (std::size_t i = 0; i < library.ids().size(); ++i)
        for (const Material material = library.at(i); const Dataset& dataset : material.datasets) {
          const F0Result truth = reference.solve(dataset.optics);
          for (const F0Solver& solver : solvers) {
            INFO(material.id << "/" << dataset.id << " " << policy(solver.options()));
            check_within(solver, solver.solve(dataset.optics), truth);
          }
        }
    }
}

TEST_CASE("auto keeps what it promises for spectra far narrower than any grid") {
  const F0Solver reference(with_method(Method::exact));
  for (const double bound : {1e-3, 1e-5, 1e-7}) {
    const F0Solver solver(automatic(bound));
    for (const Optics& optics : stiff()) {
      const F0Result got = solver.solve(optics);
      check_within(solver, got, reference.solve(optics));
      CHECK(got.integration->within_bound);
    }
  }
}

TEST_CASE("auto takes wide steps where they will do, and the exact method where nothing else does") {
  const auto step = [](const Optics& optics, double bound) {
    const F0Result result = F0Solver(automatic(bound)).solve(optics);
    REQUIRE(result.integration);
    return *result.integration;
  };
  CHECK(step(glass(1.5), 1e-5).method == Method::nm20);
  CHECK(step(glass(1.5), 1e-5).error < 1e-12);
  const Optics metal = constants(everywhere, gold_n, gold_k);
  CHECK(step(metal, 1e-9).method == Method::exact);
  CHECK(step(metal, 1e-9).within_bound);
  double before = 0;
  for (const double bound : {1e-9, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1}) {
    const int nm = step_nm(step(metal, bound).method);  // 0 for exact
    CHECK(nm >= before);
    before = nm;
  }
  CHECK(before == 20);
  // Not to be had: said, not hidden.
  CHECK(!step(lorentz(550, 1), 1e-15).within_bound);
}

TEST_CASE("auto sees the outside medium's samples and the axes of a crystal") {
  F0Options exact = with_method(Method::exact), automated = automatic(1e-5);
  exact.outside = automated.outside = {
      "step", std::get<OpticalConstants>(constants(
                  {300, 555.3, 555.31, 900}, [](double nm) { return nm > 555.305 ? 1.3 : 1.0; },
                  [](double) { return 0.0; }))};
  const Optics metal = constants(everywhere, gold_n, gold_k), clear = glass(1.7);
  for (const Optics& optics : {metal, clear}) {
    const F0Result a = F0Solver(automated).solve(optics), b = F0Solver(exact).solve(optics);
    CHECK(missed(a, b) <= 1e-5);
    CHECK(a.integration->method == Method::exact);
  }
  const F0Solver solver(automatic(1e-5)), reference(with_method(Method::exact));
  const Optics line = lorentz(600, 0.2);
  const std::vector<F0Solver::Part> parts{{&metal, 2.0 / 3}, {&line, 1.0 / 3}};
  check_within(solver, solver.solve(parts), reference.solve(parts));
  const std::vector<F0Solver::Part> smooth{{&clear, 0.5}, {&clear, 0.5}};
  CHECK(solver.solve(smooth).integration->method == Method::nm20);
}

TEST_CASE("auto is grey for grey, names itself and its bound in the policy, and needs a bound above 0") {
  for (const auto illuminant : {Illuminant::d65, Illuminant::d50, Illuminant::a, Illuminant::e})
    for (const RgbSpace space : {RgbSpace::srgb, RgbSpace::acescg, RgbSpace::rec2020}) {
      F0Options options = automatic(1e-4);
      options.viewing.illuminant = illuminant;
      options.space = space;
      CHECK(worst_channel(F0Solver(options).solve(flat(0.3)).linear, {0.3, 0.3, 0.3}) <= 1e-12);
    }
  CHECK(contains(policy(automatic(1e-4)), "auto"));
  CHECK(contains(policy(automatic(1e-4)), "0.0001"));
  CHECK(!F0Solver({}).solve(flat(0.3)).integration);
  for (const double bound : {0.0, -1.0, std::nan("")})
    CHECK(contains(error_of([&] { F0Solver{automatic(bound)}; }), "integration bound"));
}

TEST_CASE("a sum says so when the data are finer than its step, the reference sum where it may show") {
  const auto flagged = [](const Optics& optics, Method method) {
    return F0Solver(with_method(method)).solve(optics).flags.has(Flag::finer_than_grid);
  };
  const Optics metal = constants(everywhere, gold_n, gold_k);  // rows 10 nm apart
  CHECK(flagged(metal, Method::nm20));
  CHECK(flagged(metal, Method::e308_20));
  CHECK(!flagged(metal, Method::nm10));
  CHECK(!flagged(metal, Method::nm1));
  CHECK(!flagged(metal, Method::exact));
  CHECK(!flagged(metal, Method::automatic));
  CHECK(!flagged(metal, Method::legacy_point));
  // Half a nanometre, but smooth: 1 nm is as good.
  const Optics fine = constants(wavelengths(350, 840, 0.5), gold_n, gold_k);
  CHECK(flagged(fine, Method::nm5));
  CHECK(!flagged(fine, Method::nm1));
  const Optics line = lorentz(550.3, 0.1);
  for (const Method method : {Method::nm1, Method::nm5, Method::nm10, Method::nm20})
    CHECK(flagged(line, method));
  CHECK(!flagged(line, Method::exact));
  CHECK(!flagged(line, Method::automatic));
}

TEST_CASE("a spectrum of narrow lines is integrated exactly by itself") {
  // Three lines of 0.09 nm between the points of the 1 nm sum, which sees nothing of them.
  Reflectance lines;
  for (const double middle : {500.5, 550.5, 600.5})
    for (const auto& [nm, value] : {std::pair(-0.045, 0.0), std::pair(0.0, 1.0), std::pair(0.045, 0.0)}) {
      lines.spectrum.wavelength_nm.push_back(middle + nm);
      lines.spectrum.value.push_back(value);
    }
  lines.spectrum.wavelength_nm.insert(lines.spectrum.wavelength_nm.begin(), 360),
      lines.spectrum.value.insert(lines.spectrum.value.begin(), 0);
  lines.spectrum.wavelength_nm.push_back(830), lines.spectrum.value.push_back(0);
  const F0Result usual = F0Solver({}).solve(lines), exact = F0Solver(with_method(Method::exact)).solve(lines);
  CHECK(usual.luminance > 1e-4);
  CHECK(usual.xyz == exact.xyz);
  CHECK(usual.linear == exact.linear);
  CHECK(usual.flags.has(Flag::finer_than_grid));
  REQUIRE(usual.integration);
  CHECK(usual.integration->method == Method::exact);
  // The same of n and k, of F82, and of a crystal's axes together.
  const Optics line = lorentz(550.3, 0.1);
  const F0Result resonance = F0Solver({}).solve(line),
                 truth = F0Solver(with_method(Method::exact)).solve(line);
  CHECK(resonance.xyz == truth.xyz);
  CHECK(resonance.f82 == truth.f82);
  const F0Result axes = F0Solver({}).solve({{&line, 0.5}, {&line, 0.5}});
  CHECK(missed(axes, truth) <= 1e-12);
  // What is smooth keeps the sum.
  CHECK(!F0Solver({}).solve(constants(wavelengths(350, 840, 0.5), gold_n, gold_k)).integration);
}
