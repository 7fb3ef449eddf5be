// SPDX-License-Identifier: Apache-2.0
// Based on:
//   CIE 015:2018, "Colorimetry"
//   Hoffman, "Physically Based Shading": the forbidden zone
//   Hoffman 2019, "Fresnel Equations Considered Harmful": F82
//   Kutz et al. 2021, "Novel aspects of the Adobe Standard Material": F82 as a tint of Schlick
#include "core/material/f0.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/base/stopwatch.h"
#include "core/color/srgb.h"
#include "core/fresnel/fresnel.h"
#include "core/material/coverage.h"
#include "core/material/dispersion.h"
#include "core/material/f0_data.h"
#include "core/spectrum/refinement.h"

namespace etak {
namespace {

// Below this share of a weight a note is due.
constexpr double flagged_below = 0.99;
constexpr double wide_gap_nm = 20;
constexpr double visible_absorption = 0.01;
// What data finer than 1 nm may move the reference sum before that is said: three quarters of a code at 0.04.
constexpr double flagged_grid_error = 1e-3;
// Rounding of a perfect reflector is no gamut matter.
constexpr double gamut_tolerance = 1e-9;

// What solve() needs per thread: kept between calls, so that a database run allocates once.
struct Scratch {
  std::vector<double> n, k, r0, r82, mixed0, mixed82;
  void resize(std::size_t count) {
    for (auto* v : {&n, &k, &r0, &r82, &mixed0, &mixed82}) v->resize(count);
  }
};

}  // namespace

struct F0Solver::State {
  F0Options options;
  WeightSums sums;
  Quadrature quadrature;        // of every method but exact and automatic
  std::vector<double> outside;  // n of the outside medium at the quadrature's wavelengths; empty: constant
  double outside_n = 1;
  Flags outside_flags;
  Range outside_range{0, 0};

  // Made when first needed: few data are finer than the reference grid.
  mutable std::once_flag refinement_made;
  mutable std::optional<Refinement> lazy_refinement;

  bool exact() const { return options.method == Method::exact; }
  bool needs_knots() const { return exact() || options.method == Method::automatic; }

  const Refinement& refinement() const {
    std::call_once(refinement_made, [&] { lazy_refinement.emplace(options.viewing); });
    return *lazy_refinement;
  }

  // With those of the outside medium.
  std::vector<double> all_knots(std::vector<double> knots) const {
    if (const auto* medium = std::get_if<OpticalConstants>(&options.outside.index))
      append_knots(*medium, knots);
    return knots;
  }

  // The rule for some data, and which that is where the method is automatic.
  struct Rule {
    const Quadrature* quadrature;
    Quadrature own;  // what `quadrature` points to where it is of these data only
    std::optional<IntegrationStep> step;
  };

  // Estimated errors of the steps of refinement(); empty where the data have no reflectance. `reflect` gives
  // it at the wavelengths of a quadrature.
  template <class Reflect>
  std::vector<double> estimate(std::span<const double> knots, const Reflect& reflect) const {
    Quadrature places;
    places.wavelength_nm = Refinement::places(knots);
    const std::span<const double> reflectance = reflect(places);
    if (reflectance.empty()) return {};
    return refinement().estimate(places.wavelength_nm, reflectance);
  }

  template <class Reflect>
  void choose_rule(std::vector<double> knots, const Reflect& reflect, Rule& rule) const {
    rule.quadrature = &quadrature;
    if (!needs_knots()) return;
    knots = all_knots(std::move(knots));
    if (!exact()) {
      const auto errors = estimate(knots, reflect);
      for (std::size_t i = 0; i < errors.size(); ++i)
        if (errors[i] <= options.integration_bound) {
          rule.quadrature = &refinement().steps()[i].rule;
          rule.step = {refinement().steps()[i].method, errors[i], true};
          return;
        }
      rule.step.emplace();
    }
    rule.own = make_exact_quadrature(options.viewing, knots);
    rule.quadrature = &rule.own;
  }

  // The estimate of the exact method needs the reflectance at its own points.
  void finish_step(Rule& rule, std::span<const double> reflectance, F0Result& result) const {
    if (rule.step && rule.step->method == Method::exact) {
      rule.step->error = exact_method_error(*rule.quadrature, reflectance);
      rule.step->within_bound = rule.step->error <= options.integration_bound;
    }
    result.integration = rule.step;
  }

  // Says so where a sum's step is wider than the data's. The reference sum is fine enough for nearly all data
  // that are finer than it, so that of it only what may show is flagged.
  template <class Reflect>
  void flag_grid(const Optics& optics, const Reflect& reflect, F0Result& result) const {
    const int step = step_nm(options.method);
    if (step == 0 || !(finest_spacing_nm(optics) < step * (1 - 1e-9))) return;
    if (options.method == Method::nm1) {
      std::vector<double> knots;
      append_knots(optics, knots);
      const auto errors = estimate(all_knots(std::move(knots)), reflect);
      if (errors.empty() || errors.back() <= flagged_grid_error) return;
    }
    result.flags.set(Flag::finer_than_grid);
  }

  // n or k at the nodes of q.
  void values(const Spectrum& table, const Quadrature& q, std::span<double> out) const {
    if (&q == &quadrature && options.method == Method::nm1 && options.interpolation == Interpolation::linear)
      resample_to_grid(table, out.subspan<0, grid_size>());
    else
      resample(table, options.interpolation, q.wavelength_nm, out);
  }

  void index(const OpticalConstants& optics, const Quadrature& q, std::span<double> out) const {
    if (const auto* formula = std::get_if<DispersionFormula>(&optics.n))
      evaluate(*formula, q.wavelength_nm, out);
    else
      values(std::get<Spectrum>(optics.n), q, out);
  }

  void divide_by_outside(const Quadrature& q, std::span<double> n, std::span<double> k) const {
    if (const auto* medium = std::get_if<OpticalConstants>(&options.outside.index)) {
      std::vector<double> computed;
      const std::vector<double>* n0 = &outside;
      if (&q != &quadrature) {
        computed.resize(n.size());
        index(*medium, q, computed);
        n0 = &computed;
      }
      for (std::size_t i = 0; i < n.size(); ++i) {
        n[i] /= (*n0)[i];
        k[i] /= (*n0)[i];
      }
    } else if (outside_n != 1) {
      for (std::size_t i = 0; i < n.size(); ++i) {
        n[i] /= outside_n;
        k[i] /= outside_n;
      }
    }
  }

  // Reflectance at the nodes, at normal incidence and at cos 1/7; false with a reason where the data do not
  // allow it.
  bool reflectance(const Optics& optics, const Quadrature& q, Scratch& scratch, std::string& refusal,
                   Stopwatch& watch, F0Timing& timing) const {
    if (const auto* table = std::get_if<Reflectance>(&optics)) {
      values(table->spectrum, q, scratch.r0);
      watch.lap(timing.interpolate);
      return true;
    }
    const auto& constants = std::get<OpticalConstants>(optics);
    index(constants, q, scratch.n);
    if (constants.k)
      values(*constants.k, q, scratch.k);
    else
      std::fill(scratch.k.begin(), scratch.k.end(), 0.0);
    for (std::size_t i = 0; i < scratch.n.size(); ++i)
      if (!(scratch.n[i] > 0 || (scratch.n[i] == 0 && scratch.k[i] > 0))) {
        refusal = "n = " + number(scratch.n[i], 6) + " at " + number(q.wavelength_nm[i], 6) +
                  " nm; n must be above 0, or 0 with k above 0";
        return false;
      }
    divide_by_outside(q, scratch.n, scratch.k);
    watch.lap(timing.interpolate);
    f64::f0(scratch.n, scratch.k, scratch.r0);
    f64::fresnel_exact(scratch.n, scratch.k, f82_cosine, scratch.r82);
    watch.lap(timing.fresnel);
    return true;
  }

  void flag_data(const Optics& optics, F0Result& result) const {
    const Coverage& coverage = result.coverage;
    if (coverage.first_nm > core_first_nm || coverage.last_nm < core_last_nm ||
        coverage.least() < flagged_below)
      result.flags.set(Flag::extrapolated);
    if (coverage.largest_gap_nm > wide_gap_nm) result.flags.set(Flag::gap);
    if (is_sparse(coverage)) result.flags.set(Flag::sparse);
    const auto* constants = std::get_if<OpticalConstants>(&optics);
    if (!constants) return;
    const Range n = range_of(*constants);
    if (std::holds_alternative<DispersionFormula>(constants->n) &&
        (n.first_nm > grid_first_nm || n.last_nm < grid_last_nm))
      result.flags.set(Flag::formula_clamped);
    if (!constants->k)
      result.flags.set(Flag::k_assumed_0);
    else if (constants->k->first_nm() > std::max<double>(grid_first_nm, n.first_nm) ||
             constants->k->last_nm() < std::min<double>(grid_last_nm, n.last_nm))
      result.flags.set(Flag::k_range_short);
  }

  static bool is_single_sample(const Optics& optics) {
    if (const auto* table = std::get_if<Reflectance>(&optics)) return table->spectrum.size() == 1;
    const auto* table = std::get_if<Spectrum>(&std::get<OpticalConstants>(optics).n);
    return table && table->size() == 1;
  }

  // Linear values in the chosen space and in sRGB of a weighted sum.
  struct Spaces {
    Xyz white;  // under the illuminant
    Mat3 to_space, to_srgb, from_srgb;
    LinearRgb space_white{1, 1, 1};
  };

  Spaces spaces_for(const Quadrature& q) const {
    const Viewing d65{options.viewing.observer, Illuminant::d65};
    Spaces s;
    Xyz d65_white;
    if (samples_rgb(options.method)) {
      s.white = to_xyz(make_quadrature(Method::nm1, options.viewing).white());
      d65_white = to_xyz(make_quadrature(Method::nm1, d65).white());
    } else {
      s.white = to_xyz(q.white());
      d65_white = options.viewing == d65 ? s.white
                  : exact()              ? to_xyz(make_exact_quadrature(d65, {}).white())
                                         : to_xyz(make_quadrature(options.method, d65).white());
    }
    s.to_srgb = xyz_to_rgb(RgbSpace::srgb, s.white, d65_white);
    s.from_srgb = inverse(s.to_srgb);
    s.to_space = xyz_to_rgb(options.space, s.white, d65_white);
    if (options.custom_space)
      s.space_white = options.custom_space->convert(s.white, s.white);
    else if (options.space == RgbSpace::xyz)
      s.space_white = to_rgb(vec(s.white));
    return s;
  }

  LinearRgb in_space(const Spaces& s, const Xyz& xyz) const {
    return options.custom_space ? options.custom_space->convert(xyz, s.white) : to_rgb(s.to_space * vec(xyz));
  }

  void fill_colour(const Quadrature& q, const Spaces& s, std::span<const double> r0,
                   std::span<const double> r82, F0Result& result) const {
    // A point method's sum is linear sRGB already; through XYZ and back it would only gain rounding.
    const auto colour = [&](std::span<const double> r, Xyz& xyz, LinearRgb& srgb) {
      const std::array<double, 3> sum = q.integrate(r);
      if (samples_rgb(options.method)) {
        srgb = to_rgb(sum);
        xyz = to_xyz(s.from_srgb * sum);
        return options.space == RgbSpace::srgb && !options.custom_space ? srgb : in_space(s, xyz);
      }
      xyz = to_xyz(sum);
      srgb = to_rgb(s.to_srgb * sum);
      return in_space(s, xyz);
    };
    result.linear = colour(r0, result.xyz, result.srgb_linear);
    result.srgb8 = options.method == Method::legacy_schueler ? power22_u8(result.srgb_linear)
                                                             : srgb_u8(result.srgb_linear);
    result.luminance = result.xyz.y;
    result.zone = zone_of(result.luminance);
    const Vec3 srgb = vec(result.srgb_linear);
    for (std::size_t c = 0; c < 3; ++c) {
      result.channel_in_zone[c] = zone_of(srgb[c]) == Zone::inside;
      if (result.channel_in_zone[c] && *result.zone != Zone::inside) result.flags.set(Flag::channel_in_zone);
    }
    const Vec3 linear = vec(result.linear), white = vec(s.space_white);
    const bool has_gamut = options.custom_space || options.space != RgbSpace::xyz;
    for (std::size_t c = 0; c < 3 && has_gamut; ++c) {
      const double excess = linear[c] > 1 ? linear[c] - 1 : std::min(linear[c], 0.0);
      if (std::abs(excess) <= gamut_tolerance) continue;
      result.gamut_excess[c] = excess;
      result.flags.set(Flag::out_of_gamut);
    }
    if (r82.empty()) return;
    Xyz xyz82;
    LinearRgb srgb82;
    const Vec3 f82 = vec(colour(r82, xyz82, srgb82));
    result.f82 = to_rgb(f82);
    Vec3 tint;
    for (std::size_t c = 0; c < 3; ++c)
      tint[c] = f82[c] / (white[c] * f64::f_schlick(linear[c] / white[c], f82_cosine));
    result.f82_tint = to_rgb(tint);
  }

  Spaces fixed_spaces;  // of every method but exact
};

F0Solver::F0Solver(F0Options options) {
  auto state = std::make_unique<State>();
  state->options = std::move(options);
  const F0Options& o = state->options;
  if (!(o.integration_bound > 0))
    throw Error::at("integration bound", number(o.integration_bound, 6), "a number above 0");
  state->sums = weight_sums(o.viewing);
  state->quadrature = make_quadrature(o.method, o.viewing);
  if (!state->exact()) state->fixed_spaces = state->spaces_for(state->quadrature);
  if (const auto* medium = std::get_if<OpticalConstants>(&o.outside.index)) {
    const std::string place = "outside medium " + o.outside.label;
    state->outside.resize(state->quadrature.wavelength_nm.size());
    state->index(*medium, state->quadrature, state->outside);
    for (const double n : state->outside)
      if (!(n > 0)) throw Error::at(place, "n = " + number(n, 6), "n above 0 at 360-830 nm");
    state->outside_range = range_of(*medium);
    const Coverage coverage = coverage_of(state->outside_range, nullptr, state->sums);
    if (!covers_enough(coverage.weight[1]) && !o.allow_extrapolation)
      throw Error::at(place, "data cover " + number(coverage.weight[1], 4) + " of the Y weight",
                      number(least_coverage, 4) + ", or " + setting("allow-extrapolation"));
    if (medium->k) {
      std::array<double, grid_size> k;
      resample_to_grid(*medium->k, k);
      const double most = *std::max_element(k.begin(), k.end());
      if (most > visible_absorption)
        throw Error::at(place, "absorbs: k = " + number(most, 4) + " at 360-830 nm",
                        "a clear medium, k at most 0.01");
      if (most > 0) state->outside_flags.set(Flag::outside_absorption_ignored);
    }
  } else {
    state->outside_n = std::get<double>(o.outside.index);
    if (!(state->outside_n > 0) || !std::isfinite(state->outside_n))
      throw Error::at("outside medium", "n = " + number(state->outside_n, 6), "a finite n above 0");
  }
  state_ = std::move(state);
}

F0Solver::~F0Solver() = default;
F0Solver::F0Solver(F0Solver&&) noexcept = default;

const F0Options& F0Solver::options() const {
  return state_->options;
}

F0Result F0Solver::solve(const Optics& optics, Flags data_flags, F0Timing* timing) const {
  F0Timing ignored;
  F0Timing& times = timing ? *timing : ignored;
  Stopwatch watch(timing != nullptr);
  const State& state = *state_;
  thread_local Scratch scratch;

  F0Result result;
  result.flags = data_flags;
  result.flags |= state.outside_flags;
  const auto* table = std::get_if<Reflectance>(&optics);
  const auto* constants = std::get_if<OpticalConstants>(&optics);
  const Spectrum* samples = table ? &table->spectrum : std::get_if<Spectrum>(&constants->n);
  const Range range = table ? Range{samples->first_nm(), samples->last_nm()} : range_of(*constants);
  result.coverage = coverage_of(range, samples, state.sums);
  if (State::is_single_sample(optics)) result.flags.set(Flag::single_sample);
  state.flag_data(optics, result);
  if (!covers_enough(result.coverage.weight[1]) && !state.options.allow_extrapolation) {
    result.refusal = "data cover " + number(result.coverage.weight[1], 4) + " of the Y weight (" +
                     number(range.first_nm, 6) + "-" + number(range.last_nm, 6) + " nm), " +
                     number(least_coverage, 4) + " needed";
    return result;
  }

  const auto reflect = [&](const Quadrature& at) -> std::span<const double> {
    scratch.resize(at.wavelength_nm.size());
    if (!state.reflectance(optics, at, scratch, result.refusal, watch, times)) return {};
    return scratch.r0;
  };
  state.flag_grid(optics, reflect, result);
  std::vector<double> knots;
  if (state.needs_knots()) append_knots(optics, knots);
  State::Rule rule;
  state.choose_rule(std::move(knots), reflect, rule);
  if (result.refused() || reflect(*rule.quadrature).empty()) return result;
  state.finish_step(rule, scratch.r0, result);
  const Quadrature& q = *rule.quadrature;
  state.fill_colour(q, state.exact() ? state.spaces_for(q) : state.fixed_spaces, scratch.r0,
                    table ? std::span<const double>{} : scratch.r82, result);
  watch.lap(times.sum);
  return result;
}

F0Result F0Solver::solve(const std::vector<Part>& parts, Flags data_flags) const {
  const State& state = *state_;
  F0Result result;
  result.flags = data_flags;
  std::vector<double> knots;
  bool has_f82 = true;
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
    append_knots(*parts[i].optics, knots);
  }
  // Said again of the average, where they hold.
  result.flags.clear(Flag::out_of_gamut);
  result.flags.clear(Flag::channel_in_zone);

  Scratch scratch;
  F0Timing ignored;
  Stopwatch watch(false);
  const auto reflect = [&](const Quadrature& at) -> std::span<const double> {
    scratch.resize(at.wavelength_nm.size());
    std::fill(scratch.mixed0.begin(), scratch.mixed0.end(), 0.0);
    std::fill(scratch.mixed82.begin(), scratch.mixed82.end(), 0.0);
    for (const Part& part : parts) {
      if (!state.reflectance(*part.optics, at, scratch, result.refusal, watch, ignored)) return {};
      for (std::size_t i = 0; i < scratch.r0.size(); ++i) {
        scratch.mixed0[i] += part.weight * scratch.r0[i];
        scratch.mixed82[i] += part.weight * scratch.r82[i];
      }
    }
    return scratch.mixed0;
  };
  State::Rule rule;
  state.choose_rule(std::move(knots), reflect, rule);
  if (result.refused() || reflect(*rule.quadrature).empty()) return result;
  state.finish_step(rule, scratch.mixed0, result);
  const Quadrature& q = *rule.quadrature;
  state.fill_colour(q, state.exact() ? state.spaces_for(q) : state.fixed_spaces, scratch.mixed0,
                    has_f82 ? std::span<const double>(scratch.mixed82) : std::span<const double>{}, result);
  return result;
}

}  // namespace etak
