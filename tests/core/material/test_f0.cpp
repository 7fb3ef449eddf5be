// SPDX-License-Identifier: Apache-2.0
#include "core/material/f0.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "core/exchange/table.h"
#include "core/fresnel/fresnel.h"
#include "tests/core/material/f0_support.h"

using namespace etak;
using namespace etak::test;

TEST_CASE("a flat reflectance is grey to 1e-12 for every combination of options") {
  const std::vector<double> grid = wavelengths(360.25, 829.5, 7.3);
  for (const Method method : all_methods)
    for (const auto observer : {Observer::cie1931_2deg, Observer::cie1964_10deg})
      for (const auto illuminant : {Illuminant::d65, Illuminant::d50, Illuminant::a, Illuminant::e})
        for (const RgbSpace space : all_rgb_spaces)
          for (const auto interpolation : {Interpolation::linear, Interpolation::pchip}) {
            F0Options options;
            options.viewing = {observer, illuminant};
            options.method = method;
            options.space = space;
            options.interpolation = interpolation;
            const F0Solver solver(options);
            INFO(policy(options));
            const F0Result white = solver.solve(reflectance(grid, [](double) { return 1.0; }));
            for (const double r : {0.5, 0.04}) {
              const F0Result got = solver.solve(reflectance(grid, [r](double) { return r; }));
              REQUIRE(!got.refused());
              if (space == RgbSpace::xyz)
                for (std::size_t c = 0; c < 3; ++c)
                  REQUIRE(std::abs(vec(got.linear)[c] - r * vec(white.linear)[c]) <= 1e-12);
              else
                REQUIRE(worst_channel(got.linear, {r, r, r}) <= 1e-12);
              REQUIRE(worst_channel(got.srgb_linear, {r, r, r}) <= 1e-12);
              REQUIRE(std::abs(got.luminance - r) <= 1e-12);
              REQUIRE(got.srgb8.r == got.srgb8.g);
              REQUIRE(got.srgb8.g == got.srgb8.b);
            }
          }
}

TEST_CASE("n constant and without absorption is grey to 1e-12 at normal incidence and at 1/7") {
  for (const Method method : all_methods) {
    const F0Result got = solve(glass(1.5), with_method(method));
    INFO(name(method));
    CHECK(worst_channel(got.linear, {0.04, 0.04, 0.04}) <= 1e-12);
    const double edge = f64::fresnel_exact(1.5, 0, f82_cosine);
    REQUIRE(got.f82);
    CHECK(worst_channel(*got.f82, {edge, edge, edge}) <= 1e-12);
    REQUIRE(got.f82_tint);
    const double tint = edge / f64::f_schlick(0.04, f82_cosine);
    CHECK(worst_channel(*got.f82_tint, {tint, tint, tint}) <= 1e-11);
  }
}

TEST_CASE("R = 0 is black and R = 1 is white") {
  const F0Result black = solve(flat(0)), white = solve(flat(1));
  CHECK(black.linear == LinearRgb{0, 0, 0});
  CHECK(black.srgb8 == Srgb8{0, 0, 0});
  CHECK(black.luminance == 0);
  CHECK(worst_channel(white.linear, {1, 1, 1}) <= 1e-12);
  CHECK(white.srgb8 == Srgb8{255, 255, 255});
  CHECK(white.luminance == Approx(1).epsilon(1e-12));
  CHECK(!white.out_of_gamut());
  CHECK(!black.out_of_gamut());
  CHECK(solve(glass(1)).linear == LinearRgb{0, 0, 0});
}

TEST_CASE("the linear result scales with the reflectance") {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (const Method method : all_methods) {
    const F0Solver solver(with_method(method));
    std::vector<double> values;
    for (std::size_t i = 0; i < everywhere.size(); ++i) values.push_back(uniform(random));
    const auto scaled = [&](double by) {
      return solver.solve(Reflectance{{everywhere, [&] {
                                         auto v = values;
                                         for (double& x : v) x *= by;
                                         return v;
                                       }()}});
    };
    const F0Result one = scaled(1), half = scaled(0.5), tenth = scaled(0.1);
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(vec(half.linear)[c] == Approx(0.5 * vec(one.linear)[c]).margin(1e-13));
      CHECK(vec(tenth.linear)[c] == Approx(0.1 * vec(one.linear)[c]).margin(1e-13));
    }
  }
}

TEST_CASE("the result of a sum of reflectances is the sum of the results") {
  const auto rising = [](double nm) { return (nm - 300) / 1200; };
  const auto bump = [](double nm) { return 0.4 * std::exp(-std::pow((nm - 520) / 40, 2)); };
  const F0Result a = solve(reflectance(everywhere, rising)), b = solve(reflectance(everywhere, bump));
  const F0Result both = solve(reflectance(everywhere, [&](double nm) { return rising(nm) + bump(nm); }));
  for (std::size_t c = 0; c < 3; ++c)
    CHECK(vec(both.linear)[c] == Approx(vec(a.linear)[c] + vec(b.linear)[c]).epsilon(1e-12));
}

TEST_CASE("more reflectance at any wavelength is never less luminance") {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (const Method method : {Method::nm1, Method::exact, Method::nm5, Method::nm10, Method::nm20}) {
    const F0Solver solver(with_method(method));
    for (int repeat = 0; repeat < 20; ++repeat) {
      Reflectance low{{everywhere, {}}}, high = low;
      for (std::size_t i = 0; i < everywhere.size(); ++i) {
        const double a = uniform(random), b = uniform(random);
        low.spectrum.value.push_back(std::min(a, b));
        high.spectrum.value.push_back(std::max(a, b));
      }
      const F0Result l = solver.solve(low), h = solver.solve(high);
      REQUIRE(l.xyz.x <= h.xyz.x);
      REQUIRE(l.xyz.y <= h.xyz.y);
      REQUIRE(l.xyz.z <= h.xyz.z);
    }
  }
}

TEST_CASE("more absorption at fixed n is more luminance for a metal") {
  double before = 0;
  for (double k = 0; k < 8; k += 0.5) {
    const double now = solve(constants(
                                 everywhere, [](double) { return 1.2; }, [k](double) { return k; }))
                           .luminance;
    CHECK(now > before);
    before = now;
  }
}

TEST_CASE("the unit and the order of the rows of a table change nothing") {
  const auto rows = wavelengths(350, 840, 10);
  std::string nm = "wavelength_nm,n,k\n", um = "wavelength_um,n,k\n", angstrom = "wavelength_A,n,k\n",
              shuffled = nm;
  std::vector<std::string> lines;
  for (const double w : rows) {
    const std::string nk = "," + std::to_string(gold_n(w)) + "," + std::to_string(gold_k(w)) + "\n";
    const int whole = static_cast<int>(w);
    nm += std::to_string(whole) + nk;
    um += "0." + std::to_string(whole) + nk;
    angstrom += std::to_string(whole) + "0" + nk;
    lines.push_back(std::to_string(whole) + nk);
  }
  std::mt19937_64 random(13);
  std::shuffle(lines.begin(), lines.end(), random);
  for (const auto& line : lines) shuffled += line;

  TableOptions options;
  const auto read = [&](const std::string& text) { return parse_table(text, "test.csv", options); };
  const Table plain = read(nm);
  const F0Result want = solve(plain.optics);
  CHECK(solve(read(um).optics).linear.r == Approx(want.linear.r).epsilon(1e-12));
  CHECK(solve(read(um).optics).linear.b == Approx(want.linear.b).epsilon(1e-12));
  const Table mixed = read(shuffled);
  CHECK((mixed.optics == plain.optics));
  CHECK(mixed.flags.has(Flag::unsorted));
  CHECK(solve(mixed.optics).linear == want.linear);
  options.unit = WavelengthUnit::angstrom;
  CHECK(worst_channel(solve(read(angstrom).optics).linear, want.linear) <= 1e-12);
  options.unit = WavelengthUnit::electronvolt;
  std::string ev = "energy_eV,n,k\n";
  for (const double w : rows) {
    std::array<char, 40> energy{};
    std::snprintf(energy.data(), energy.size(), "%.17g", ev_nm / w);
    ev +=
        std::string(energy.data()) + "," + std::to_string(gold_n(w)) + "," + std::to_string(gold_k(w)) + "\n";
  }
  CHECK(worst_channel(solve(read(ev).optics).linear, want.linear) <= 1e-10);
}

TEST_CASE("extra rows on the straight lines between rows change nothing") {
  const Optics coarse = constants(
      {300, 500, 900}, [](double nm) { return 1 + nm / 1000; }, [](double) { return 2.0; });
  const Optics fine = constants(
      wavelengths(300, 900, 2.5), [](double nm) { return 1 + nm / 1000; }, [](double) { return 2.0; });
  for (const Method method : all_methods)
    CHECK(worst_channel(solve(coarse, with_method(method)).linear, solve(fine, with_method(method)).linear) <=
          1e-12);
}

TEST_CASE("the reference policy agrees with its definition written out in long double") {
  const Optics optics = constants(everywhere, gold_n, gold_k);
  const auto& table = std::get<OpticalConstants>(optics);
  const auto at = [&](const Spectrum& s, double nm) {
    const auto i = static_cast<std::size_t>((nm - 350) / 10);
    const long double t = (static_cast<long double>(nm) - s.wavelength_nm[i]) / 10;
    return s.value[i] + t * (s.value[i + 1] - s.value[i]);
  };
  std::array<long double, 3> xyz{}, white{};
  for (std::size_t i = 0; i < grid_size; ++i) {
    const double nm = 360 + static_cast<double>(i);
    const long double n = at(std::get<Spectrum>(table.n), nm), k = at(*table.k, nm);
    const long double r = ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
    for (std::size_t c = 0; c < 3; ++c) {
      const long double w = static_cast<long double>(matching_functions({})[i][c]) * relative_power({})[i];
      xyz[c] += w * r;
      white[c] += w;
    }
  }
  const F0Result got = solve(optics);
  Vec3 want{}, w{};
  for (std::size_t c = 0; c < 3; ++c) {
    want[c] = static_cast<double>(xyz[c] / white[1]);
    w[c] = static_cast<double>(white[c] / white[1]);
    CHECK(vec(got.xyz)[c] == Approx(want[c]).epsilon(1e-12));
  }
  const LinearRgb rgb = to_rgb(inverse(rgb_to_xyz(primaries(RgbSpace::srgb), to_xyz(w))) * want);
  CHECK(worst_channel(got.linear, rgb) <= 1e-12);
  CHECK(got.srgb_linear == got.linear);
}

TEST_CASE("narrow features are seen alike by every method only when they are wide enough") {
  const Optics smooth = constants(everywhere, gold_n, gold_k);
  const F0Result reference = solve(smooth, with_method(Method::exact));
  for (const auto& [method, most] : {std::pair{Method::nm1, 1e-4},
                                     {Method::nm5, 1e-3},
                                     {Method::nm10, 4e-3},
                                     {Method::e308_10, 1e-3},
                                     {Method::nm20, 2e-2},
                                     {Method::e308_20, 1e-2}}) {
    INFO(name(method));
    CHECK(worst_channel(solve(smooth, with_method(method)).linear, reference.linear) < most);
  }
  CHECK(worst_channel(solve(smooth, with_method(Method::legacy_point)).linear, reference.linear) > 1e-2);
}

TEST_CASE("point methods take the reflectance at three wavelengths as linear red, green and blue") {
  const Optics ramp = reflectance(wavelengths(350, 840, 1), [](double nm) { return nm / 1000; });
  const F0Result a = solve(ramp, with_method(Method::legacy_point));
  CHECK(worst_channel(a.srgb_linear, {0.650, 0.550, 0.450}) <= 1e-12);
  const F0Result b = solve(ramp, with_method(Method::legacy_schueler));
  CHECK(worst_channel(b.srgb_linear, {0.643, 0.562, 0.396}) <= 1e-12);
  CHECK(b.srgb8 == Srgb8{209, 196, 167});  // 255 x^(1/2.2), not the sRGB curve
}

TEST_CASE("spaces agree: every one decodes to the same XYZ") {
  const Optics optics = constants(everywhere, gold_n, gold_k);
  F0Options xyz;
  xyz.space = RgbSpace::xyz;
  const F0Result reference = solve(optics, xyz);
  CHECK(worst_channel(reference.linear, to_rgb(vec(reference.xyz))) == 0);
  for (const RgbSpace space : {RgbSpace::rec2020, RgbSpace::display_p3, RgbSpace::srgb}) {
    F0Options options;
    options.space = space;
    const F0Result got = solve(optics, options);
    const Xyz white = solve(flat(1), options).xyz;
    const Vec3 back = rgb_to_xyz(primaries(space), white) * vec(got.linear);
    for (std::size_t c = 0; c < 3; ++c) CHECK(back[c] == Approx(vec(reference.xyz)[c]).epsilon(1e-12));
    CHECK(got.srgb8 == reference.srgb8);
    CHECK(got.luminance == reference.luminance);
  }
}

TEST_CASE("F82 is the reflectance at cosine 1/7 under the same integral, and the tint its ratio to Schlick") {
  const Optics optics = constants(everywhere, gold_n, gold_k);
  const F0Result got = solve(optics);
  REQUIRE(got.f82);
  REQUIRE(got.f82_tint);
  // The table of exact reflectances at 1/7 taken as measured reflectance, at 1 nm, gives the same colour.
  const auto grid = wavelengths(grid_first_nm, grid_last_nm, 1);
  const auto& table = std::get<OpticalConstants>(optics);
  std::vector<double> n(grid.size()), k(grid.size()), r(grid.size());
  resample(std::get<Spectrum>(table.n), Interpolation::linear, grid, n);
  resample(*table.k, Interpolation::linear, grid, k);
  f64::fresnel_exact(n, k, 1.0 / 7, r);
  CHECK(worst_channel(solve(Reflectance{{grid, r}}).linear, *got.f82) <= 1e-12);
  const auto tint = [](double f82, double f0) { return f82 / (f0 + (1 - f0) * std::pow(6.0 / 7, 5)); };
  CHECK(got.f82_tint->r == Approx(tint(got.f82->r, got.linear.r)).epsilon(1e-12));
  CHECK(got.f82_tint->g == Approx(tint(got.f82->g, got.linear.g)).epsilon(1e-12));
  CHECK(got.f82_tint->b == Approx(tint(got.f82->b, got.linear.b)).epsilon(1e-12));
  CHECK(!solve(flat(0.5)).f82);
  CHECK(!solve(flat(0.5)).f82_tint);
}

TEST_CASE("the outside medium divides n and k, as a number and as a material") {
  F0Options water;
  water.outside = {"1.333", 1.333};
  const double relative = 1.5 / 1.333, f0 = std::pow((relative - 1) / (relative + 1), 2);
  CHECK(worst_channel(solve(glass(1.5), water).linear, {f0, f0, f0}) <= 1e-12);
  CHECK(worst_channel(solve(glass(1.333), water).linear, {0, 0, 0}) <= 1e-12);

  const F0Result wet = solve(constants(everywhere, gold_n, gold_k), water);
  const F0Result same = solve(constants(
      everywhere, [](double nm) { return gold_n(nm) / 1.333; },
      [](double nm) { return gold_k(nm) / 1.333; }));
  CHECK(worst_channel(wet.linear, same.linear) <= 1e-12);

  const auto n_water = [](double nm) { return 1.32 + 3000 / (nm * nm); };
  const auto grid = wavelengths(350, 840, 1);
  F0Options table;
  table.outside = {"water", std::get<OpticalConstants>(constants(grid, n_water, [](double) { return 0.0; }))};
  const Optics metal = constants(grid, gold_n, gold_k);
  const Optics divided = constants(
      grid, [&](double nm) { return gold_n(nm) / n_water(nm); },
      [&](double nm) { return gold_k(nm) / n_water(nm); });
  for (const Method method : {Method::nm1, Method::nm10, Method::e308_20, Method::legacy_point}) {
    table.method = method;
    CHECK(worst_channel(solve(metal, table).linear, solve(divided, with_method(method)).linear) <= 1e-12);
  }
  table.method = Method::exact;
  CHECK(worst_channel(solve(metal, table).linear, solve(divided, with_method(Method::exact)).linear) <= 1e-5);
  // Measured reflectance was measured in its own medium.
  CHECK(solve(flat(0.5), water).linear == solve(flat(0.5)).linear);
  CHECK(contains(policy(water), "1.333"));
}

TEST_CASE("an outside medium that absorbs, is not positive or is not known over the visible is refused") {
  const auto refusal = [](const OutsideMedium& medium) {
    return error_of([&] {
      F0Options options;
      options.outside = medium;
      const F0Solver solver(options);
    });
  };
  const auto grid = wavelengths(350, 840, 10);
  const auto one = [](double) { return 1.3; };
  CHECK(refusal({"clear", std::get<OpticalConstants>(constants(grid, one, [](double) { return 0.01; }))})
            .empty());
  CHECK(contains(
      refusal({"ink", std::get<OpticalConstants>(constants(grid, one, [](double) { return 0.02; }))}),
      "ink"));
  CHECK(contains(
      refusal({"half", std::get<OpticalConstants>(constants({400, 500}, one, [](double) { return 0.0; }))}),
      "half"));
  for (const double n :
       {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    CHECK(!refusal({"number", n}).empty());
  F0Options faint;
  faint.outside = {"tea", std::get<OpticalConstants>(constants(grid, one, [](double) { return 0.005; }))};
  CHECK(F0Solver(faint).solve(glass(1.5)).flags.has(Flag::outside_absorption_ignored));
}

TEST_CASE("the axis average is the weighted average of the linear results") {
  const Optics o = glass(1.6), e = glass(1.9), metal = constants(everywhere, gold_n, gold_k);
  for (const Method method : all_methods) {
    const F0Solver solver(with_method(method));
    const F0Result ro = solver.solve(o), rm = solver.solve(metal);
    const F0Result mixed = solver.solve({{&o, 2.0 / 3}, {&metal, 1.0 / 3}});
    INFO(name(method));
    for (std::size_t c = 0; c < 3; ++c) {
      const double margin = method == Method::exact ? 1e-8 : 1e-12;
      CHECK(vec(mixed.linear)[c] == Approx((2 * vec(ro.linear)[c] + vec(rm.linear)[c]) / 3).margin(margin));
      CHECK(vec(*mixed.f82)[c] == Approx((2 * vec(*ro.f82)[c] + vec(*rm.f82)[c]) / 3).margin(margin));
    }
  }
  const F0Solver solver{F0Options{}};
  const double want = (2 * solver.solve(o).linear.r + solver.solve(e).linear.r) / 3;
  CHECK(solver.solve({{&o, 2.0 / 3}, {&e, 1.0 / 3}}).linear.g == Approx(want).epsilon(1e-12));
  CHECK(solver.solve({{&o, 1.0}}).linear == solver.solve(o).linear);
  CHECK(solver.solve({{&o, 0.5}, {&o, 0.5}}).linear.r == Approx(solver.solve(o).linear.r).epsilon(1e-14));
  const Optics narrow = reflectance({600, 900}, [](double) { return 0.5; });
  CHECK(solver.solve({{&o, 0.5}, {&narrow, 0.5}}).refused());
}

TEST_CASE("one solver gives the same numbers however often and in whatever order it is asked") {
  const F0Solver solver(with_method(Method::exact));
  const Optics a = constants(everywhere, gold_n, gold_k), b = glass(1.5);
  const F0Result first = solver.solve(a);
  solver.solve(b);
  solver.solve(flat(0.1));
  CHECK(solver.solve(a).linear == first.linear);
  F0Timing timing;
  CHECK(solver.solve(a, {}, &timing).linear == first.linear);
  CHECK(timing.interpolate > 0);
  CHECK(timing.fresnel > 0);
  CHECK(timing.sum > 0);
}

TEST_CASE("the policy names every choice that moves a result") {
  F0Options options;
  const std::string reference = policy(options);
  for (const auto* part : {"linear", "1 nm", "360", "830", "1931", "D65"}) CHECK(contains(reference, part));
  const auto differs = [&](const F0Options& other) { return policy(other) != reference; };
  CHECK(differs(with_method(Method::exact)));
  CHECK(differs(extrapolating()));
  F0Options other;
  other.interpolation = Interpolation::pchip;
  CHECK(differs(other));
  other = {};
  other.viewing.observer = Observer::cie1964_10deg;
  CHECK(differs(other));
  other = {};
  other.viewing.illuminant = Illuminant::a;
  CHECK(differs(other));
  other = {};
  other.outside = {"water", 1.333};
  CHECK(differs(other));
  CHECK(!contains(reference, "\n"));
}
