// SPDX-License-Identifier: Apache-2.0
#include "core/material/f0_cone.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/film/stack.h"
#include "core/material/f0_steps.h"
#include "core/material/quality.h"
#include "core/math/quadrature.h"

namespace etak {
namespace {

// Into `out`, at the nodes of q. Returns why the data do not allow it.
std::string cone_reflectance(double aperture, const F0Setup& setup, const Stack& stack,
                             std::span<double> out) {
  const Quadrature& q = setup.quadrature;
  StackSpectra spectra;
  if (std::string why = stack_spectra(setup, stack, q, spectra); !why.empty()) return why;
  Film film;
  for (const StackLayer& layer : stack.layers)
    film.layers.push_back({{}, layer.thickness_nm, layer.coherent});
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto medium = [&](std::size_t which) {
      return FilmMedium{spectra.n[which][i], spectra.k[which][i]};
    };
    for (std::size_t j = 0; j < film.layers.size(); ++j)
      film.layers[j].medium = medium(stack.layers[j].medium);
    film.base = medium(stack.base);
    film.outside = spectra.outside[i];
    const double sine = aperture / film.outside, most = sine * sine;
    const auto reflected = [&](double squared_sine) {
      return film_light(film, q.wavelength_nm[i], std::sqrt(1 - squared_sine)).reflected.mean();
    };
    out[i] = gauss_legendre<16>(reflected, 0, most) / most;
  }
  return {};
}

std::string reflectance_through(const Instrument& instrument, const F0Setup& setup, const Optics& optics,
                                F0Spectra& room) {
  if (instrument.aperture > 0) {
    if (std::holds_alternative<Reflectance>(optics))
      return "reflectance at normal incidence tells nothing of the cone of an aperture";
    return cone_reflectance(instrument.aperture, setup, stack_of(optics), room.r0);
  }
  Stopwatch watch(false);
  F0Timing ignored;
  return reflectance_at(setup, optics, setup.quadrature, room, watch, ignored);
}

}  // namespace

void validate(const Instrument& instrument, const F0Options& options) {
  const auto check = [](double value, const char* name, const std::string& expected, bool good) {
    if (!good) throw Error::at(setting(name), number(value, 6), expected);
  };
  const F0Setup setup = f0_setup(options);
  double least = setup.outside_n;
  if (!setup.outside.empty()) least = *std::min_element(setup.outside.begin(), setup.outside.end());
  check(instrument.aperture, "aperture", "0 to below the index of the outside medium, " + number(least, 6),
        instrument.aperture >= 0 && instrument.aperture < least);
  check(instrument.scatter, "scatter", "0 to 1", instrument.scatter >= 0 && instrument.scatter <= 1);
  if (instrument.any() && setup.needs_knots())
    throw Error::at(setting("method"), std::string(name(options.method)) + " beside an aperture or scatter",
                    "1nm or another sum");
}

F0Result seen_through(const Instrument& instrument, const F0Options& options, const Optics& optics,
                      F0Result ahead) {
  if (!instrument.any() || ahead.refused()) return ahead;
  const F0Setup setup = f0_setup(options);
  F0Spectra room;
  room.resize(setup.quadrature.wavelength_nm.size());
  F0Result out;
  out.coverage = ahead.coverage;
  out.flags = ahead.flags;
  out.flags.clear(Flag::out_of_gamut);
  out.flags.clear(Flag::channel_in_zone);
  out.refusal = reflectance_through(instrument, setup, optics, room);
  if (out.refused()) return out;
  const bool edge = ahead.f82 && instrument.aperture == 0;
  for (auto* values : {&room.r0, &room.r82})
    for (double& value : *values) value *= 1 - instrument.scatter;
  const bool surface = !ahead.zone;
  out = with_colour(std::move(out), setup.options, setup.quadrature, setup.spaces, room.r0,
                    edge ? std::span<const double>(room.r82) : std::span<const double>{});
  if (surface) drop_zone(out);
  return out;
}

}  // namespace etak
