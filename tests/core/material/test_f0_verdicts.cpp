// SPDX-License-Identifier: Apache-2.0
// What an F0 result says beside its colour: coverage, refusals, flags, zone and gamut.
#include "core/material/f0.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/core/material/f0_support.h"

using namespace etak;
using namespace etak::test;

TEST_CASE("data that hold under 0.95 of the luminous weight are refused unless extrapolation is allowed") {
  const Optics half = reflectance(wavelengths(400, 560, 10), [](double nm) { return nm / 1000; });
  const F0Result refused = solve(half);
  CHECK(refused.refused());
  CHECK(contains(refused.refusal, "0.95"));
  CHECK(refused.coverage.weight[1] < 0.95);
  CHECK(refused.coverage.weight[1] > 0.4);
  CHECK(refused.coverage.first_nm == 400);
  CHECK(refused.coverage.last_nm == 560);

  const F0Result allowed = solve(half, extrapolating());
  CHECK(!allowed.refused());
  CHECK(allowed.flags.has(Flag::extrapolated));
  CHECK(allowed.coverage.weight[1] == refused.coverage.weight[1]);
  const F0Result held =
      solve(reflectance(wavelengths(400, 840, 1), [](double nm) { return std::min(nm, 560.0) / 1000; }));
  CHECK(worst_channel(allowed.linear, held.linear) < 1e-4);  // the end value is held

  for (const auto& at : {wavelengths(900, 2000, 10), wavelengths(200, 350, 10)})
    CHECK(solve(reflectance(at, [](double) { return 0.5; })).coverage.weight[1] == 0);
}

TEST_CASE("the coverage rule cuts at 0.95 of Y exactly where the weights say") {
  for (double first = 380; first <= 540; first += 1) {
    const auto inside = weight_inside({}, first, 830);
    const F0Result got = solve(reflectance({first, 830}, [](double) { return 0.5; }));
    INFO("from " << first << " nm: " << inside[1]);
    for (std::size_t c = 0; c < 3; ++c) CHECK(got.coverage.weight[c] == Approx(inside[c]).margin(1e-12));
    CHECK(got.refused() == (inside[1] < 0.95));
    CHECK(got.coverage.least() == *std::min_element(got.coverage.weight.begin(), got.coverage.weight.end()));
    CHECK(got.flags.has(Flag::extrapolated) == (first > 400 || got.coverage.least() < 0.99));
  }
}

TEST_CASE("extrapolated is flagged when 400..700 nm is not covered or a weight lies under 0.99") {
  const auto flagged = [](double first, double last) {
    return solve(reflectance({first, last}, [](double) { return 0.5; })).flags.has(Flag::extrapolated);
  };
  CHECK(!flagged(360, 830));
  CHECK(!flagged(400, 700));
  CHECK(flagged(400.5, 700));
  CHECK(flagged(400, 699.5));
  CHECK(flagged(430, 830));
  for (const auto observer : {Observer::cie1931_2deg, Observer::cie1964_10deg})
    for (const auto illuminant : {Illuminant::d65, Illuminant::d50, Illuminant::a, Illuminant::e})
      for (const double last : {700.0, 690.0, 680.0}) {
        F0Options options;
        options.viewing = {observer, illuminant};
        const auto inside = weight_inside(options.viewing, 400, last);
        const bool little = *std::min_element(inside.begin(), inside.end()) < 0.99;
        CHECK(solve(reflectance({400, last}, [](double) { return 0.5; }), options)
                  .flags.has(Flag::extrapolated) == (last < 700 || little));
      }
}

TEST_CASE("samples and the largest gap are counted within 400..700 nm") {
  const F0Result got =
      solve(reflectance({300, 390, 420, 450, 500, 640, 720, 900}, [](double) { return 0.5; }));
  CHECK(got.coverage.samples_400_700 == 4);
  CHECK(got.coverage.largest_gap_nm == Approx(140));
  CHECK(got.flags.has(Flag::gap));
  CHECK(!got.refused());
  CHECK(!solve(reflectance(wavelengths(360, 840, 20), [](double) { return 0.5; })).flags.has(Flag::gap));
  CHECK(solve(reflectance(wavelengths(360, 840, 20.5), [](double) { return 0.5; })).flags.has(Flag::gap));
  CHECK(!solve(reflectance({300, 399, 401, 420, 440, 460, 480, 500, 520, 540, 560, 580, 600, 620, 640, 660,
                            680, 699, 900},
                           [](double) { return 0.5; }))
             .flags.has(Flag::gap));  // the wide one begins at 699
}

TEST_CASE("a single row is refused, and constant when extrapolation is allowed") {
  const Optics one = constants(
      {589.3}, [](double) { return 1.5; }, [](double) { return 0.0; });
  const F0Result refused = solve(one);
  CHECK(refused.refused());
  CHECK(refused.flags.has(Flag::single_sample));
  const F0Result allowed = solve(one, extrapolating());
  CHECK(worst_channel(allowed.linear, {0.04, 0.04, 0.04}) <= 1e-12);
  CHECK(allowed.flags.has(Flag::single_sample));
  CHECK(allowed.flags.has(Flag::extrapolated));
}

TEST_CASE("missing k is 0 and flagged, k over a shorter range is held and flagged") {
  const Spectrum n{{350, 840}, {1.5, 1.5}};
  const F0Result none = solve(OpticalConstants{n, {}});
  CHECK(none.flags.has(Flag::k_assumed_0));
  CHECK(worst_channel(none.linear, {0.04, 0.04, 0.04}) <= 1e-12);
  const F0Result short_k = solve(OpticalConstants{n, Spectrum{{450, 600}, {0.5, 0.5}}});
  CHECK(short_k.flags.has(Flag::k_range_short));
  CHECK(!short_k.flags.has(Flag::k_assumed_0));
  const F0Result full_k = solve(OpticalConstants{n, Spectrum{{350, 840}, {0.5, 0.5}}});
  CHECK(!full_k.flags.has(Flag::k_range_short));
  CHECK(worst_channel(short_k.linear, full_k.linear) <= 1e-14);
}

TEST_CASE("what the importer found is carried into the result") {
  Flags found;
  found.set(Flag::negative_k);
  found.set(Flag::unsorted);
  const F0Result got = F0Solver({}).solve(flat(0.5), found);
  CHECK(got.flags.has(Flag::negative_k));
  CHECK(got.flags.has(Flag::unsorted));
}

TEST_CASE("a formula is as good as its fine table, and is clamped outside its stated range") {
  const DispersionFormula cauchy{5, {1.5, 0.004, -2}, 350, 840};
  const auto n = [](double nm) { return 1.5 + 0.004 / (nm * nm * 1e-6); };
  const F0Result by_formula = solve(OpticalConstants{cauchy, {}});
  const F0Result by_table = solve(constants(wavelengths(350, 840, 1), n, [](double) { return 0.0; }));
  CHECK(worst_channel(by_formula.linear, by_table.linear) <= 1e-12);
  CHECK(by_formula.coverage.is_formula);
  CHECK(by_formula.coverage.samples_400_700 == 0);
  CHECK(!by_formula.flags.has(Flag::formula_clamped));
  CHECK(!by_formula.flags.has(Flag::gap));
  DispersionFormula narrow = cauchy;
  narrow.first_nm = 400;
  narrow.last_nm = 700;
  const F0Result clamped = solve(OpticalConstants{narrow, {}});
  CHECK(clamped.flags.has(Flag::formula_clamped));
  const F0Result held = solve(constants(
      wavelengths(350, 840, 1), [&](double nm) { return n(std::clamp(nm, 400.0, 700.0)); },
      [](double) { return 0.0; }));
  CHECK(worst_channel(clamped.linear, held.linear) <= 1e-12);
}

TEST_CASE("n that is not positive where it is needed is refused, elsewhere it is not looked at") {
  const auto n_at = [](double bad_nm) {
    return OpticalConstants{Spectrum{{100, 200, 340, 500, 900},
                                     {1.5, bad_nm == 200 ? -1.0 : 1.5, 1.5, bad_nm == 500 ? -1.0 : 1.5, 1.5}},
                            {}};
  };
  CHECK(solve(n_at(500)).refused());
  CHECK(!solve(n_at(200)).refused());
  // A formula whose n^2 is negative in the visible.
  CHECK(solve(OpticalConstants{DispersionFormula{2, {-3, 0.1, 0.01}, 300, 900}, {}}).refused());
}

TEST_CASE("the zone is decided on luminance over an open interval: exactly 0.20 and 0.45 are outside") {
  CHECK(zone_of(0.20) == Zone::below);
  CHECK(zone_of(std::nextafter(0.20, 1)) == Zone::inside);
  CHECK(zone_of(std::nextafter(0.45, 0)) == Zone::inside);
  CHECK(zone_of(0.45) == Zone::above);
  CHECK(zone_of(0) == Zone::below);
  CHECK(zone_of(1) == Zone::above);
  CHECK(zone_of(0.3) == Zone::inside);
  CHECK(name(Zone::below) == "below");
  CHECK(name(Zone::inside) == "inside");
  CHECK(name(Zone::above) == "above");
  CHECK(solve(flat(0.3)).zone == Zone::inside);
  CHECK(solve(flat(0.3)).channel_in_zone == std::array<bool, 3>{true, true, true});
  CHECK(!solve(flat(0.3)).flags.has(Flag::channel_in_zone));
  CHECK(solve(flat(0.1)).zone == Zone::below);
}

TEST_CASE("one channel in the zone is noted and does not decide") {
  const F0Result got = solve(constants(everywhere, gold_n, gold_k));
  CHECK(got.luminance > 0.45);
  CHECK(got.zone == Zone::above);
  CHECK(got.channel_in_zone[2]);
  CHECK(!got.channel_in_zone[0]);
  CHECK(got.flags.has(Flag::channel_in_zone));
}

TEST_CASE(
    "values outside [0, 1] stay in linear, are clipped in 8 bit only, and are flagged with their amount") {
  const Optics saturated =
      reflectance(wavelengths(350, 840, 1), [](double nm) { return nm > 580 ? 1.0 : 0.0; });
  const F0Result got = solve(saturated);
  CHECK(got.linear.r > 1);
  CHECK(got.linear.g < 1);
  CHECK(got.linear.b < 0);
  CHECK(got.out_of_gamut());
  CHECK(got.flags.has(Flag::out_of_gamut));
  CHECK(got.gamut_excess[0] == Approx(got.linear.r - 1).epsilon(1e-12));
  CHECK(got.gamut_excess[2] == Approx(got.linear.b).epsilon(1e-12));
  CHECK(got.srgb8.r == 255);
  CHECK(got.srgb8.b == 0);
  F0Options wide;
  wide.space = RgbSpace::acescg;
  CHECK(!solve(constants(everywhere, gold_n, gold_k), wide).out_of_gamut());
  wide.space = RgbSpace::xyz;
  CHECK(!solve(saturated, wide).out_of_gamut());
  CHECK(solve(saturated, wide).gamut_excess == std::array<double, 3>{0, 0, 0});
}
