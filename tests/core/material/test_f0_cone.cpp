// SPDX-License-Identifier: Apache-2.0
// Stacks beside what others measured of them, with nothing free.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "core/color/delta_e.h"
#include "core/film/stack.h"
#include "core/fresnel/fresnel.h"
#include "core/material/f0/f0_steps.h"
#include "core/material/find.h"
#include "core/material/optics/axes.h"
#include "core/material/quality.h"
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

F0Options through(const Instrument& instrument, Method method = Method::nm1) {
  F0Options out;
  out.instrument = instrument;
  out.method = method;
  return out;
}

double difference(const Spectrum& measured, const std::string& text, const Instrument& instrument) {
  const F0Result there = F0Solver({}).solve(Reflectance{measured});
  const F0Result here = F0Solver(through(instrument)).solve(optics_named(text));
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
    const F0Result ahead = F0Solver({}).solve(*optics), cone = F0Solver(through({1e-4, 0})).solve(*optics);
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
    film_reflectance(spectra.film, std::sqrt(1 - 0.81 * (i + 0.5) / angles), one);
    for (std::size_t w = 0; w < grid_size; ++w) sum[w] += one[w] / angles;
  }
  const F0Result many = F0Solver({}).solve(Reflectance{{setup.quadrature.wavelength_nm, sum}});
  for (const Method method : {Method::nm1, Method::exact, Method::automatic}) {
    const F0Result cone = F0Solver(through({0.9, 0}, method)).solve(film);
    const double margin = method == Method::nm1 ? 2e-7 : 5e-5;  // of the sums over wavelengths
    CHECK(cone.linear.r == Approx(many.linear.r).margin(margin));
    CHECK(cone.linear.g == Approx(many.linear.g).margin(margin));
    CHECK(cone.linear.b == Approx(many.linear.b).margin(margin));
    CHECK_FALSE(cone.f82);
  }
}

TEST_CASE(
    "the cone of a thick film is resolved, and where the index outside varies each wavelength has its own") {
  const Optics film = optics_named("anatase:9um/titanium");
  F0Options options = through({1.1, 0});
  options.outside = outside_medium(library(), "water", "place", {});
  const F0Setup setup = f0_setup(options);
  const Stack& stack = std::get<Stack>(film);
  StackSpectra spectra;
  REQUIRE(stack_spectra(setup, stack, setup.quadrature, spectra).empty());
  std::vector<double> cone(grid_size);
  REQUIRE(cone_mean(setup, film, setup.quadrature, 1.1, cone).empty());
  for (const std::size_t w : {40, 90, 240, 300}) {
    Film one{spectra.outside[w],
             {{{spectra.n[0][w], spectra.k[0][w]}, 9000, true}},
             {spectra.n[1][w], spectra.k[1][w]}};
    if (stack.base == 0) std::swap(one.base, one.layers[0].medium);
    constexpr int angles = 20000;
    const double most = 1.21 / (one.outside * one.outside);
    double sum = 0;
    for (int i = 0; i < angles; ++i)
      sum += film_light(one, setup.quadrature.wavelength_nm[w], std::sqrt(1 - most * (i + 0.5) / angles))
                 .reflected.mean();
    CHECK(cone[w] == Approx(sum / angles).margin(1e-6));
  }
}

TEST_CASE("an axis average through an aperture is that of the axes through it, weighted") {
  const Material rutile = find_material(library(), "rutile")->answer.material;
  const F0Solver solver(through({0.6, 0.1}));
  const auto average = average_over_axes(solver, rutile, rutile.preferred_dataset());
  REQUIRE(average);
  REQUIRE(average->result.refusal == "");
  LinearRgb sum{};
  double weights = 0;
  for (const AxisDataset& axis : axis_datasets(rutile, rutile.preferred_dataset())) {
    const LinearRgb one = solver.solve(axis.dataset->optics).linear;
    sum.r += axis.weight * one.r;
    sum.b += axis.weight * one.b;
    weights += axis.weight;
  }
  CHECK(weights == Approx(1));
  CHECK(average->result.linear.r == Approx(sum.r).epsilon(1e-12));
  CHECK(average->result.linear.b == Approx(sum.b).epsilon(1e-12));
  CHECK_FALSE(average->result.f82);
}

TEST_CASE(
    "the mean over the hemisphere is that of Fresnel's equations, and F82's closed form is near it for metals") {
  F0Options options;
  options.mean = true;
  options.allow_extrapolation = true;  // one n and k for all wavelengths
  const F0Solver solver(options);
  // One n and k: the integral of 2 c F(c) by many small steps.
  const OpticalConstants one{Spectrum{{550}, {0.2}}, Spectrum{{550}, {3.4}}};
  double sum = 0;
  constexpr int steps = 200000;
  for (int i = 0; i < steps; ++i) {
    const double c = (i + 0.5) / steps;
    sum += 2 * c * f64::fresnel_exact(0.2, 3.4, c) / steps;
  }
  const F0Result flat = solver.solve(one);
  REQUIRE(flat.mean);
  CHECK(flat.mean->r == Approx(sum).margin(1e-9));
  CHECK(flat.mean->b == Approx(sum).margin(1e-9));
  for (const char* metal : {"gold", "titanium", "aluminum"}) {
    const F0Result result = solver.solve(optics_named(metal));
    const LinearRgb closed = mean_of_f82(result).value();
    // (1 + F0 20 - (Schlick - F82) / (6 (6/7)^6 / 7)) / 21, as OpenPBR 1.1.1 prints it.
    const double schlick = result.linear.g + (1 - result.linear.g) * std::pow(6.0 / 7, 5);
    CHECK(closed.g ==
          Approx((1 + 20 * result.linear.g) / 21 - (schlick - result.f82->g) * 7 / std::pow(6.0 / 7, 6) / 126)
              .epsilon(1e-12));
    CHECK(closed.g == Approx(result.mean->g).margin(0.004));
  }
  const F0Result exact = [&] {
    F0Options by = options;
    by.method = Method::exact;
    return F0Solver(by).solve(optics_named("gold"));
  }();
  CHECK(exact.mean->g == Approx(solver.solve(optics_named("gold")).mean->g).margin(3e-5));
  CHECK_FALSE(solver.solve(optics_named("spectralon")).mean);
  CHECK_FALSE(F0Solver({}).solve(optics_named("gold")).mean);
}

TEST_CASE("scatter takes its share, and what no instrument has is refused") {
  const Optics titanium = optics_named("titanium");
  const F0Result all = F0Solver({}).solve(titanium), less = F0Solver(through({0, 0.25})).solve(titanium);
  CHECK(less.linear.g == Approx(0.75 * all.linear.g).epsilon(1e-12));
  CHECK(less.f82->g == Approx(0.75 * all.f82->g).epsilon(1e-12));
  const Optics white = optics_named("spectralon");
  CHECK(contains(F0Solver(through({0.3, 0})).solve(white).refusal, "tells nothing of the cone"));
  CHECK(
      contains(policy(through({0.3, 0.1})), "mean over the cone of aperture 0.3; 0.1 of it lost by scatter"));
  const auto refused = [](const Instrument& instrument, F0Options options) {
    options.instrument = instrument;
    return error_of([&] { (void)F0Solver(options); });
  };
  CHECK(contains(refused({1, 0}, {}), "1; expected 0 to below the index of the outside medium, 1"));
  CHECK(contains(refused({-0.1, 0}, {}), "-0.1; expected 0 to below"));
  CHECK(contains(refused({0, 1.5}, {}), "1.5; expected 0 to 1"));
  F0Options wet;
  wet.outside = outside_medium(library(), "water", "place", {});
  CHECK(refused({1.2, 0}, wet) == "");
  CHECK(contains(refused({1.4, 0}, wet), "of the outside medium, 1.3"));
}
