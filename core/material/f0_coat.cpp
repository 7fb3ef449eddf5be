// SPDX-License-Identifier: Apache-2.0
// Based on: Born and Wolf, "Principles of Optics"; the sum of intensities in core/film/stack.h; OpenPBR 1.1.1, "Coat", for
// what is told of the energy.
#include "core/material/f0_coat.h"

#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/film/stack.h"
#include "core/fresnel/fresnel.h"
#include "core/material/f0/f0_steps.h"
#include "core/material/quality.h"
#include "core/math/functions.h"

namespace etak {
namespace {

F0Result colour_of(const F0Setup& setup, const FilmSpectra& film, std::vector<double>& r0) {
  std::vector<double> r82(r0.size());
  film_reflectance(film, 1, r0);
  film_reflectance(film, f82_cosine, r82);
  return with_colour({}, setup.options, setup.quadrature, setup.spaces, r0, r82);
}

}  // namespace

Stack coated_stack(const Coat& coat, const Optics& optics) {
  Stack out = stack_of(optics);
  out.media.push_back({coat.label, {}, {}, coat.medium});
  out.layers.insert(out.layers.begin(), {out.media.size() - 1, coat.thickness_nm, false});
  return out;
}

std::string coated(const Coat& coat, const F0Options& options, const Optics& optics, const std::string& place,
                   CoatedF0& out) {
  if (std::holds_alternative<Reflectance>(optics))
    throw Error::at(place, "reflectance at normal incidence tells nothing of what is reflected under a coat",
                    "data of n and k");
  const F0Setup setup = f0_setup(options);
  const Quadrature& q = setup.quadrature;
  const Stack stack = coated_stack(coat, optics);
  StackSpectra spectra;
  if (std::string why = stack_spectra(setup, stack, q, spectra); !why.empty()) return why;
  const FilmSpectra& whole = spectra.film;
  const FilmSpectra::Medium medium = whole.layers.front().medium;
  FilmSpectra under = whole;
  under.outside = medium.n;
  under.layers.erase(under.layers.begin());
  std::vector<double> f0_under(q.wavelength_nm.size()), left(f0_under.size());
  out.label = coat.label;
  out.n = coat.n;
  out.whole = colour_of(setup, whole, left);
  out.under = colour_of(setup, under, f0_under);
  std::vector<double> kept(left.size());
  film_reflectance({{whole.outside, {}, {medium.n, {}}}, q.wavelength_nm}, 1, left);  // of the coat's surface
  for (std::size_t i = 0; i < left.size(); ++i) {
    kept[i] = math::exp(-8 * std::numbers::pi * medium.k[i] * coat.thickness_nm / q.wavelength_nm[i]);
    const double reflected = left[i], passes = 1 - reflected;
    left[i] = kept[i] * passes * passes / (1 - kept[i] * reflected * f0_under[i]);
  }
  out.passes = with_colour({}, setup.options, q, setup.spaces, kept, {}).linear;
  out.energy_left = with_colour({}, setup.options, q, setup.spaces, left, {});
  drop_zone(out.energy_left);
  return {};
}

}  // namespace etak
