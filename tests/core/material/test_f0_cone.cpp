// SPDX-License-Identifier: Apache-2.0
// Stacks beside what others measured of them, with nothing free.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "core/color/delta_e.h"
#include "core/film/stack.h"
#include "core/material/f0_cone.h"
#include "core/material/f0_steps.h"
#include "core/material/find.h"
#include "tests/core/material/library_support.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

using Measured = std::map<std::string, Spectrum>;

// The columns of a table of films; none where the reference data are not beside the checkout.
std::optional<Measured> measured_films(const std::string& file) {
  const auto shared = shared_folder();
  if (!shared) return std::nullopt;
  const auto rows = read_csv(*shared + "/data/measured-films/" + file);
  Measured out;
  for (std::size_t i = 1; i < rows.size(); ++i)
    for (std::size_t c = 1; c < rows[0].size(); ++c) {
      Spectrum& spectrum = out[rows[0][c]];
      spectrum.wavelength_nm.push_back(to_number(rows[i][0]));
      spectrum.value.push_back(to_number(rows[i][c]));
    }
  return out;
}

Optics optics_named(const std::string& text) {
  return find_material(library(), text)->answer.material.preferred_dataset().optics;
}

double difference(const Spectrum& measured, const std::string& text, const Instrument& instrument) {
  const F0Result there = F0Solver({}).solve(Reflectance{measured});
  const Optics optics = optics_named(text);
  const F0Result here = seen_through(instrument, {}, optics, F0Solver({}).solve(optics));
  REQUIRE(here.refusal == "");
  return delta_e2000(to_lab(there.srgb_linear), to_lab(here.srgb_linear));
}

// Mean over the seven channels of diamond over air or water on glass.
double mean_of_channels(const Measured& measured, double aperture) {
  const Instrument options{aperture, 0};
  double sum = 0;
  int count = 0;
  for (const auto& [column, spectrum] : measured) {
    if (!column.starts_with("diamond286_")) continue;
    const bool water = column.find("water") != column.npos;
    const std::size_t digits = column.find_first_of("0123456789", 11);
    const std::string height = column.substr(digits, column.find('_', digits) - digits);
    const double off = difference(
        spectrum,
        "diamond/peter-1923:286nm/" + std::string(water ? "water" : "air") + ":" + height + "nm/fused_silica",
        options);
    INFO(column << " " << off);
    CHECK(off < (aperture > 0 ? 12 : 40));
    sum += off;
    ++count;
  }
  CHECK(count == 7);
  return sum / count;
}

}  // namespace

TEST_CASE(
    "channels under diamond have their measured colours over the cone of an objective, and not at normal incidence") {
  const auto measured = measured_films("channels.csv");
  if (!measured) {
    WARN("no reference data beside the checkout; not checked");
    return;
  }
  const double cone = mean_of_channels(*measured, 0.9), normal = mean_of_channels(*measured, 0);
  INFO(cone << " " << normal);
  CHECK(cone <= 6);
  CHECK(cone == Approx(5.7).margin(0.1));
  CHECK(normal == Approx(13.0).margin(0.15));
}

TEST_CASE("measured mirrors of aluminium and silver lie near the preferred datasets") {
  const auto measured = measured_films("mirrors.csv");
  if (!measured) {
    WARN("no reference data beside the checkout; not checked");
    return;
  }
  CHECK(difference(measured->at("aluminium_bare"), "aluminum", {}) <= 0.5);
  CHECK(difference(measured->at("silver_protected"), "silver", {}) <= 2.0);
}

TEST_CASE(
    "the mean over a cone is that of many angles, uniform in the squared sine, and tends to normal incidence") {
  const Optics film = optics_named("anatase:200nm/titanium"), bare = optics_named("titanium");
  for (const Optics* optics : {&film, &bare}) {
    const F0Result ahead = F0Solver({}).solve(*optics), cone = seen_through({1e-4, 0}, {}, *optics, ahead);
    CHECK(cone.linear.r == Approx(ahead.linear.r).epsilon(1e-7));
    CHECK(cone.linear.b == Approx(ahead.linear.b).epsilon(1e-7));
    CHECK_FALSE(cone.f82);
  }
  const F0Setup setup = f0_setup({});
  StackSpectra spectra;
  const Stack& stack = std::get<Stack>(film);
  REQUIRE(stack_spectra(setup, stack, setup.quadrature, spectra).empty());
  constexpr int angles = 4000;
  std::vector<double> sum(grid_size), one(grid_size);
  for (int i = 0; i < angles; ++i) {
    film_reflectance(spectra.film(stack, setup.quadrature), std::sqrt(1 - 0.81 * (i + 0.5) / angles), one);
    for (std::size_t w = 0; w < grid_size; ++w) sum[w] += one[w] / angles;
  }
  const F0Result many = F0Solver({}).solve(Reflectance{{setup.quadrature.wavelength_nm, sum}});
  const F0Result cone = seen_through({0.9, 0}, {}, film, F0Solver({}).solve(film));
  CHECK(cone.linear.r == Approx(many.linear.r).margin(2e-7));
  CHECK(cone.linear.g == Approx(many.linear.g).margin(2e-7));
  CHECK(cone.linear.b == Approx(many.linear.b).margin(2e-7));
}

TEST_CASE("scatter takes its share, and what no instrument has is refused") {
  const Optics titanium = optics_named("titanium");
  const F0Result all = F0Solver({}).solve(titanium), less = seen_through({0, 0.25}, {}, titanium, all);
  CHECK(less.linear.g == Approx(0.75 * all.linear.g).epsilon(1e-12));
  CHECK(less.f82->g == Approx(0.75 * all.f82->g).epsilon(1e-12));
  const Optics white = optics_named("spectralon");
  CHECK(contains(seen_through({0.3, 0}, {}, white, F0Solver({}).solve(white)).refusal,
                 "tells nothing of the cone"));
  const auto refused = [](const Instrument& instrument, const F0Options& options) {
    return error_of([&] { validate(instrument, options); });
  };
  CHECK(contains(refused({1, 0}, {}), "1; expected 0 to below the index of the outside medium, 1"));
  CHECK(contains(refused({-0.1, 0}, {}), "-0.1; expected 0 to below"));
  CHECK(contains(refused({0, 1.5}, {}), "1.5; expected 0 to 1"));
  F0Options wet;
  wet.outside = outside_medium(library(), "water", "place", {});
  validate({1.2, 0}, wet);
  CHECK(contains(refused({1.4, 0}, wet), "of the outside medium, 1.3"));
  F0Options exact;
  exact.method = Method::exact;
  CHECK(contains(refused({0.5, 0}, exact), "expected 1nm or another sum"));
}
