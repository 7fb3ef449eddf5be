// SPDX-License-Identifier: Apache-2.0
// Based on:
//   CIE 015:2018, "Colorimetry"
//   Hoffman, "Physically Based Shading": the forbidden zone
//   Hoffman 2019, "Fresnel Equations Considered Harmful": F82
//   Kutz et al. 2021, "Novel aspects of the Adobe Standard Material": F82 as a tint of Schlick
#include "core/material/f0.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/once.h"
#include "core/base/setting.h"
#include "core/base/spares.h"
#include "core/material/coverage.h"
#include "core/material/f0/f0_steps.h"
#include "core/spectrum/refinement.h"

namespace etak {
namespace {

// Data that hold a smaller share of a weight are flagged.
constexpr double flagged_below = 0.99;
constexpr double wide_gap_nm = 20;
constexpr double visible_absorption = 0.01;
// With a larger error of the reference sum by data finer than 1 nm these are integrated exactly, and flagged: three
// quarters of a code at 0.04.
constexpr double flagged_grid_error = 1e-3;

// Flags of the data of one medium or reflectance alone, whatever the result is.
//   constants   null: reflectance
//   samples     of n or the reflectance; null: a formula
Flags flags_of_data(const OpticalConstants* constants, const Spectrum* samples, const Coverage& coverage) {
  Flags out;
  const auto set = [&](Flag flag, bool holds) {
    if (holds) out.set(flag);
  };
  set(Flag::single_sample, samples && samples->size() == 1);
  set(Flag::extrapolated, coverage.first_nm > core_first_nm || coverage.last_nm < core_last_nm ||
                              coverage.least() < flagged_below);
  set(Flag::gap, coverage.largest_gap_nm > wide_gap_nm);
  set(Flag::sparse, is_sparse(coverage));
  if (!constants) return out;
  const Range n = range_of(*constants);
  set(Flag::formula_clamped, std::holds_alternative<DispersionFormula>(constants->n) &&
                                 (n.first_nm > grid_first_nm || n.last_nm < grid_last_nm));
  set(Flag::k_assumed_0, !constants->k);
  set(Flag::k_range_short,
      constants->k && (constants->k->first_nm() > std::max<double>(grid_first_nm, n.first_nm) ||
                       constants->k->last_nm() < std::min<double>(grid_last_nm, n.last_nm)));
  return out;
}

// Adds coverage and flags of such data, and why they have no colour.
void add_data(const F0Setup& setup, const OpticalConstants* constants, const Spectrum* samples,
              F0Result& result) {
  const Range range = constants ? range_of(*constants) : Range{samples->first_nm(), samples->last_nm()};
  result.coverage = coverage_of(range, samples, setup.sums);
  result.flags |= flags_of_data(constants, samples, result.coverage);
  result.refusal = coverage_refusal(setup, range, result.coverage);
}

void add_medium(const F0Setup& setup, const OpticalConstants& medium, F0Result& result) {
  add_data(setup, &medium, std::get_if<Spectrum>(&medium.n), result);
}

// Whether light of 400 nm has fringes in the coherent layers that are narrower than eight steps of the sum.
bool has_unresolved_fringes(const F0Setup& setup, const Stack& stack) {
  constexpr double least_steps = 8;
  Quadrature at;
  at.wavelength_nm = {core_first_nm};
  double path = 0;  // there and back
  for (const StackLayer& layer : stack.layers) {
    double n = 0;
    index_at(setup, stack.media[layer.medium].constants, at, {&n, 1});
    if (layer.coherent) path += 2 * n * layer.thickness_nm;
  }
  return core_first_nm * core_first_nm < least_steps * std::max(step_nm(setup.options.method), 1) * path;
}

// The range that all media of a stack cover, and the flags of all.
void add_stack(const F0Setup& setup, const Stack& stack, F0Result& result) {
  if (!stack.is_open()) {
    result.refusal = "the materials of the stack " + printable(stack.text) + " were not looked up";
    return;
  }
  for (std::size_t i = 0; i < stack.media.size(); ++i) {
    F0Result part;
    add_medium(setup, stack.media[i].constants, part);
    result.flags |= part.flags;
    if (i == 0)
      result.coverage = part.coverage;
    else
      intersect(result.coverage, part.coverage);
    if (!part.refused() || result.refused()) continue;
    result.refusal = stack.media[i].id + "/" + stack.media[i].dataset + ": " + part.refusal;
  }
  if (!result.refused())
    result.refusal =
        coverage_refusal(setup, {result.coverage.first_nm, result.coverage.last_nm}, result.coverage);
  if (has_unresolved_fringes(setup, stack)) result.flags.set(Flag::unresolved_fringes);
}

void add_data(const F0Setup& setup, const Optics& optics, F0Result& result) {
  if (const auto* stack = std::get_if<Stack>(&optics)) return add_stack(setup, *stack, result);
  if (const auto* constants = std::get_if<OpticalConstants>(&optics))
    return add_medium(setup, *constants, result);
  add_data(setup, nullptr, &std::get<Reflectance>(optics).spectrum, result);
}

// The knots together with those of the outside medium.
std::vector<double> all_knots(const F0Options& options, std::vector<double> knots) {
  if (const auto* medium = std::get_if<OpticalConstants>(&options.outside.index))
    append_knots(*medium, knots);
  return knots;
}

// Estimated errors of the steps of `refinement`; empty where the data have no reflectance.
//   reflect   gives it at the wavelengths of a quadrature, and F82 and the mean only where it is told to
template <class Reflect>
std::vector<double> estimate(const Refinement& refinement, std::span<const double> knots,
                             const Reflect& reflect) {
  Quadrature places;
  places.wavelength_nm = Refinement::places(knots);
  const std::span<const double> reflectance = reflect(places, false);
  if (reflectance.empty()) return {};
  return refinement.estimate(places.wavelength_nm, reflectance);
}

void check_instrument(const F0Setup& setup) {
  const auto [aperture, scatter] = setup.options.instrument;
  double least = setup.outside_n;
  if (!setup.outside.empty()) least = *std::min_element(setup.outside.begin(), setup.outside.end());
  if (!(aperture >= 0 && aperture < least))
    throw Error::at(setting("aperture"), number(aperture, 6),
                    "0 to below the index of the outside medium, " + number(least, 6));
  if (!(scatter >= 0 && scatter <= 1)) throw Error::at(setting("scatter"), number(scatter, 6), "0 to 1");
}

// For a medium whose n is a table or formula.
void set_outside(const OpticalConstants& medium, F0Setup& setup) {
  const std::string place = "outside medium " + setup.options.outside.label;
  setup.outside.resize(setup.quadrature.wavelength_nm.size());
  index_at(setup, medium, setup.quadrature, setup.outside);
  for (const double n : setup.outside)
    if (!(n > 0)) throw Error::at(place, "n = " + number(n, 6), "n above 0 at 360-830 nm");
  const Coverage coverage = coverage_of(range_of(medium), nullptr, setup.sums);
  if (!covers_enough(coverage.weight[1]) && !setup.options.allow_extrapolation)
    throw Error::at(place, "data cover " + number(coverage.weight[1], 4) + " of the Y weight",
                    number(least_coverage, 4) + ", or " + setting("allow-extrapolation"));
  if (!medium.k) return;
  std::array<double, grid_size> k;
  resample_to_grid(*medium.k, k);
  const double most = *std::max_element(k.begin(), k.end());
  if (most > visible_absorption)
    throw Error::at(place, "absorbs: k = " + number(most, 4) + " at 360-830 nm",
                    "a clear medium, k at most 0.01");
  if (most > 0) setup.outside_flags.set(Flag::outside_absorption_ignored);
}

}  // namespace

F0Setup f0_setup(F0Options options) {
  F0Setup out;
  out.options = std::move(options);
  const F0Options& o = out.options;
  if (!(o.integration_bound > 0))
    throw Error::at("integration bound", number(o.integration_bound, 6), "a number above 0");
  out.sums = weight_sums(o.viewing);
  out.quadrature = make_quadrature(o.method, o.viewing);
  if (!out.exact()) out.spaces = colour_spaces(o, out.quadrature);
  if (const auto* medium = std::get_if<OpticalConstants>(&o.outside.index))
    set_outside(*medium, out);
  else
    out.outside_n = std::get<double>(o.outside.index);
  if (!(out.outside_n > 0) || !std::isfinite(out.outside_n))
    throw Error::at("outside medium", "n = " + number(out.outside_n, 6), "a finite n above 0");
  check_instrument(out);
  return out;
}

std::string coverage_refusal(const F0Setup& setup, Range range, const Coverage& coverage) {
  if (covers_enough(coverage.weight[1]) || setup.options.allow_extrapolation) return {};
  return "data cover " + number(coverage.weight[1], 4) + " of the Y weight (" + number(range.first_nm, 6) +
         "-" + number(range.last_nm, 6) + " nm), " + number(least_coverage, 4) + " needed";
}

struct F0Solver::State {
  const F0Setup setup;
  mutable Spares<F0Spectra> rooms;

  // Made when it is first needed: few data are finer than the reference grid.
  mutable Once refinement_made;
  mutable std::optional<Refinement> lazy_refinement;

  explicit State(F0Options options) : setup(f0_setup(std::move(options))) {}

  const Refinement& refinement() const {
    refinement_made.call([&] { lazy_refinement.emplace(setup.options.viewing); });
    return *lazy_refinement;
  }

  // The quadrature for some data; `step` tells which one Method::automatic took.
  struct Rule {
    const Quadrature* shared = nullptr;
    std::optional<Quadrature> own;  // in place of `shared`: of these data only
    std::optional<IntegrationStep> step;

    const Quadrature& quadrature() const { return own ? *own : *shared; }
  };

  //   spiky   the reference sum would miss what the data hold
  template <class Reflect>
  Rule rule_for(std::vector<double> knots, bool spiky, const Reflect& reflect) const {
    Rule out;
    out.shared = &setup.quadrature;
    if (!setup.needs_knots() && !spiky) return out;
    knots = all_knots(setup.options, std::move(knots));
    if (spiky) {
      out.step.emplace();
    } else if (!setup.exact()) {
      const auto errors = estimate(refinement(), knots, reflect);
      for (std::size_t i = 0; i < errors.size(); ++i)
        if (errors[i] <= setup.options.integration_bound) {
          out.shared = &refinement().steps()[i].rule;
          out.step = {refinement().steps()[i].method, errors[i], true};
          return out;
        }
      out.step.emplace();
    }
    out.own = make_exact_quadrature(setup.options.viewing, knots);
    return out;
  }

  // Whether the step of the sum is wider than that of the data. The 1 nm steps of the reference sum are fine
  // enough for nearly all finer data, so that there only an error that may be seen counts.
  template <class Reflect>
  bool finer_than_grid(const Optics& optics, const Reflect& reflect) const {
    const int step = step_nm(setup.options.method);
    if (step == 0 || !(finest_spacing_nm(optics) < step * (1 - 1e-9))) return false;
    if (setup.options.method != Method::nm1) return true;
    std::vector<double> knots;
    append_knots(optics, knots);
    const auto errors = estimate(refinement(), all_knots(setup.options, std::move(knots)), reflect);
    return !errors.empty() && errors.back() > flagged_grid_error;
  }

  // Completes `result` by the colour of the reflectance that `reflect` gives at the nodes of the rule for
  // these knots; where the data do not allow it, `reflect` returns nothing and says why in result.refusal.
  //   r82, mean   where `reflect` leaves the reflectance at cos 1/7, and its mean; null: none
  template <class Reflect>
  void add_colour(std::vector<double> knots, const Reflect& reflect, const std::vector<double>* r82,
                  const std::vector<double>* mean, F0Result& result) const {
    const bool spiky = setup.options.method == Method::nm1 && result.flags.has(Flag::finer_than_grid);
    const Rule rule = rule_for(std::move(knots), spiky, reflect);
    if (result.refused()) return;
    const Quadrature& q = rule.quadrature();
    const std::span<const double> r0 = reflect(q, true);
    if (r0.empty()) return;
    result.integration = rule.step;
    // The estimate of the exact method needs the reflectance at its own points.
    if (auto& step = result.integration; step && step->method == Method::exact) {
      step->error = exact_method_error(q, r0);
      step->within_bound = step->error <= setup.options.integration_bound;
    }
    std::optional<F0Options> exactly;
    if (spiky) exactly.emplace(setup.options).method = Method::exact;
    const F0Options& options = exactly ? *exactly : setup.options;
    const bool own_spaces = options.method == Method::exact;
    const ColourSpaces spaces = own_spaces ? colour_spaces(options, q) : setup.spaces;
    result = with_colour(std::move(result), options, q, spaces, r0,
                         r82 ? std::span<const double>(*r82) : std::span<const double>{});
    if (mean) result.mean = with_colour({}, options, q, spaces, *mean, {}).linear;
  }
};

F0Solver::F0Solver(F0Options options) : state_(std::make_unique<State>(std::move(options))) {}
F0Solver::~F0Solver() = default;
F0Solver::F0Solver(F0Solver&&) noexcept = default;

const F0Options& F0Solver::options() const {
  return state_->setup.options;
}

F0Result F0Solver::solve(const Optics& optics, Flags data_flags, F0Timing* timing) const {
  F0Timing ignored;
  F0Timing& times = timing ? *timing : ignored;
  Stopwatch watch(timing != nullptr);
  const F0Setup& setup = state_->setup;
  const Spares<F0Spectra>::Taken taken(state_->rooms);
  F0Spectra& room = *taken;

  F0Result result;
  result.flags = data_flags;
  result.flags |= setup.outside_flags;
  add_data(setup, optics, result);
  if (result.refused()) return result;

  const bool has_angles = !std::holds_alternative<Reflectance>(optics);
  const bool has_f82 = has_angles && setup.options.f82 && setup.options.instrument.aperture == 0;
  const bool has_mean = has_angles && setup.options.mean;
  const auto reflect = [&](const Quadrature& at, bool angles) -> std::span<const double> {
    room.resize(at.wavelength_nm.size(), angles && has_f82, angles && has_mean);
    std::string refusal = reflectance_at(setup, optics, at, room, watch, times);
    if (refusal.empty()) return room.r0;
    result.refusal = std::move(refusal);
    return {};
  };
  if (state_->finer_than_grid(optics, reflect)) result.flags.set(Flag::finer_than_grid);
  std::vector<double> knots;
  if (setup.needs_knots() || result.flags.has(Flag::finer_than_grid)) append_knots(optics, knots);
  state_->add_colour(std::move(knots), reflect, has_f82 ? &room.r82 : nullptr,
                     has_mean ? &room.mean : nullptr, result);
  watch.lap(times.sum);
  return result;
}

F0Result F0Solver::solve(const std::vector<Part>& parts, Flags data_flags) const {
  F0Result result;
  result.flags = data_flags;
  std::vector<double> knots;
  bool has_f82 = true, has_mean = true;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const F0Result part = solve(*parts[i].optics);
    if (part.refused()) {
      result.refusal = part.refusal;
      result.coverage = part.coverage;
      return result;
    }
    if (i == 0)
      result.coverage = part.coverage;
    else
      intersect(result.coverage, part.coverage);
    result.flags |= part.flags;
    has_f82 = has_f82 && part.f82.has_value();
    has_mean = has_mean && part.mean.has_value();
    append_knots(*parts[i].optics, knots);
  }
  // These flags are set again where they hold for the average.
  result.flags.clear(Flag::out_of_gamut);
  result.flags.clear(Flag::channel_in_zone);

  F0Spectra room, mixed;
  F0Timing ignored;
  Stopwatch watch(false);
  const auto reflect = [&](const Quadrature& at, bool angles) -> std::span<const double> {
    mixed = {};
    for (F0Spectra* each : {&room, &mixed})
      each->resize(at.wavelength_nm.size(), angles && has_f82, angles && has_mean);
    const auto mix = [](std::vector<double>& to, const std::vector<double>& from, double weight) {
      for (std::size_t i = 0; i < from.size(); ++i) to[i] += weight * from[i];
    };
    for (const Part& part : parts) {
      result.refusal = reflectance_at(state_->setup, *part.optics, at, room, watch, ignored);
      if (result.refused()) return {};
      mix(mixed.r0, room.r0, part.weight);
      mix(mixed.r82, room.r82, part.weight);
      mix(mixed.mean, room.mean, part.weight);
    }
    return mixed.r0;
  };
  state_->add_colour(std::move(knots), reflect, has_f82 ? &mixed.r82 : nullptr,
                     has_mean ? &mixed.mean : nullptr, result);
  return result;
}

}  // namespace etak
