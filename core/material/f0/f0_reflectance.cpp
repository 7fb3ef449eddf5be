// SPDX-License-Identifier: Apache-2.0
// From optics to reflectance at the nodes of a quadrature.
#include <algorithm>
#include <limits>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/fresnel/fresnel.h"
#include "core/material/dispersion.h"
#include "core/material/f0/f0_steps.h"

namespace etak {
namespace {

// n or k at the nodes of q.
void values_at(const F0Setup& setup, const Spectrum& table, const Quadrature& q, std::span<double> out) {
  if (&q == &setup.quadrature && setup.options.method == Method::nm1 &&
      setup.options.interpolation == Interpolation::linear) {
    if (table.wavelength_nm == q.wavelength_nm)
      std::copy(table.value.begin(), table.value.end(), out.begin());
    else
      resample_to_grid(table, out.subspan<0, grid_size>());
  } else
    resample(table, setup.options.interpolation, q.wavelength_nm, out);
}

// n of the outside medium at the nodes of q.
std::vector<double> outside_at(const F0Setup& setup, const Quadrature& q) {
  const auto* medium = std::get_if<OpticalConstants>(&setup.options.outside.index);
  if (medium != nullptr && &q == &setup.quadrature) return setup.outside;
  std::vector<double> out(q.wavelength_nm.size(), setup.outside_n);
  if (medium != nullptr) index_at(setup, *medium, q, out);
  return out;
}

void divide_by_outside(const F0Setup& setup, const Quadrature& q, std::span<double> n, std::span<double> k) {
  if (std::holds_alternative<double>(setup.options.outside.index) && setup.outside_n == 1) return;
  const std::vector<double> n0 = outside_at(setup, q);
  for (std::size_t i = 0; i < n.size(); ++i) {
    n[i] /= n0[i];
    k[i] /= n0[i];
  }
}

// n and k at the nodes of q; returns why they are those of no medium.
std::string constants_at(const F0Setup& setup, const OpticalConstants& constants, const Quadrature& q,
                         std::span<double> n, std::span<double> k) {
  index_at(setup, constants, q, n);
  if (constants.k)
    values_at(setup, *constants.k, q, k);
  else
    std::fill(k.begin(), k.end(), 0.0);
  for (std::size_t i = 0; i < n.size(); ++i)
    if (!(n[i] > 0 || (n[i] == 0 && k[i] > 0)))
      return "n = " + number(n[i], 6) + " at " + number(q.wavelength_nm[i], 6) +
             " nm; n must be above 0, or 0 with k above 0";
  return {};
}

}  // namespace

void index_at(const F0Setup& setup, const OpticalConstants& optics, const Quadrature& q,
              std::span<double> out) {
  if (const auto* formula = std::get_if<DispersionFormula>(&optics.n))
    evaluate(*formula, q.wavelength_nm, out);
  else
    values_at(setup, std::get<Spectrum>(optics.n), q, out);
}

Stack stack_of(const Optics& optics) {
  if (const auto* stack = std::get_if<Stack>(&optics)) return *stack;
  Stack out;
  out.media.push_back({{}, {}, {}, std::get<OpticalConstants>(optics)});
  return out;
}

std::string stack_spectra(const F0Setup& setup, const Stack& stack, const Quadrature& q, StackSpectra& out) {
  if (!stack.is_open()) return "the materials of the stack " + printable(stack.text) + " were not looked up";
  out.n.assign(stack.media.size(), std::vector<double>(q.wavelength_nm.size()));
  out.k = out.n;
  for (std::size_t i = 0; i < stack.media.size(); ++i)
    if (std::string why = constants_at(setup, stack.media[i].constants, q, out.n[i], out.k[i]); !why.empty())
      return stack.media[i].id.empty() ? why : stack.media[i].id + ": " + why;
  out.outside = outside_at(setup, q);
  out.film = {{out.outside, {}, {out.n[stack.base], out.k[stack.base]}}, q.wavelength_nm};
  for (const StackLayer& layer : stack.layers)
    out.film.layers.push_back(
        {{out.n[layer.medium], out.k[layer.medium]}, layer.thickness_nm, layer.coherent});
  return {};
}

namespace {

// At normal incidence and at cos 1/7.
std::string reflectance_ahead(const F0Setup& setup, const Optics& optics, const Quadrature& q,
                              F0Spectra& room, Stopwatch& watch, F0Timing& timing) {
  StackSpectra spectra;
  std::string why;
  const auto* const constants = std::get_if<OpticalConstants>(&optics);
  if (const auto* table = std::get_if<Reflectance>(&optics))
    values_at(setup, table->spectrum, q, room.r0);
  else
    why = constants ? constants_at(setup, *constants, q, room.n, room.k)
                    : stack_spectra(setup, std::get<Stack>(optics), q, spectra);
  if (why.empty() && constants) divide_by_outside(setup, q, room.n, room.k);
  watch.lap(timing.interpolate);
  if (!why.empty() || std::holds_alternative<Reflectance>(optics)) return why;
  constants ? f64::f0(room.n, room.k, room.r0) : film_reflectance(spectra.film, 1, room.r0);
  if (!room.r82.empty())
    constants ? f64::fresnel_exact(room.n, room.k, f82_cosine, room.r82)
              : film_reflectance(spectra.film, f82_cosine, room.r82);
  watch.lap(timing.fresnel);
  return why;
}

}  // namespace

std::string reflectance_at(const F0Setup& setup, const Optics& optics, const Quadrature& q, F0Spectra& room,
                           Stopwatch& watch, F0Timing& timing) {
  const Instrument& instrument = setup.options.instrument;
  std::string why = instrument.aperture > 0 ? cone_mean(setup, optics, q, instrument.aperture, room.r0)
                                            : reflectance_ahead(setup, optics, q, room, watch, timing);
  if (why.empty() && setup.options.mean && !room.mean.empty() && !std::holds_alternative<Reflectance>(optics))
    why = cone_mean(setup, optics, q, std::numeric_limits<double>::infinity(), room.mean);
  if (instrument.scatter > 0)
    for (auto* values : {&room.r0, &room.r82})
      for (double& value : *values) value *= 1 - instrument.scatter;
  return why;
}

}  // namespace etak
