// SPDX-License-Identifier: Apache-2.0
// From optics to reflectance at the nodes of a quadrature.
#include <algorithm>

#include "core/base/number.h"
#include "core/fresnel/fresnel.h"
#include "core/material/dispersion.h"
#include "core/material/f0_steps.h"

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

void divide_by_outside(const F0Setup& setup, const Quadrature& q, std::span<double> n, std::span<double> k) {
  if (const auto* medium = std::get_if<OpticalConstants>(&setup.options.outside.index)) {
    std::vector<double> computed;
    const std::vector<double>* n0 = &setup.outside;
    if (&q != &setup.quadrature) {
      computed.resize(n.size());
      index_at(setup, *medium, q, computed);
      n0 = &computed;
    }
    for (std::size_t i = 0; i < n.size(); ++i) {
      n[i] /= (*n0)[i];
      k[i] /= (*n0)[i];
    }
  } else if (setup.outside_n != 1) {
    for (std::size_t i = 0; i < n.size(); ++i) {
      n[i] /= setup.outside_n;
      k[i] /= setup.outside_n;
    }
  }
}

}  // namespace

void index_at(const F0Setup& setup, const OpticalConstants& optics, const Quadrature& q,
              std::span<double> out) {
  if (const auto* formula = std::get_if<DispersionFormula>(&optics.n))
    evaluate(*formula, q.wavelength_nm, out);
  else
    values_at(setup, std::get<Spectrum>(optics.n), q, out);
}

std::string reflectance_at(const F0Setup& setup, const Optics& optics, const Quadrature& q, F0Spectra& room,
                           Stopwatch& watch, F0Timing& timing) {
  if (const auto* table = std::get_if<Reflectance>(&optics)) {
    values_at(setup, table->spectrum, q, room.r0);
    watch.lap(timing.interpolate);
    return {};
  }
  const auto& constants = std::get<OpticalConstants>(optics);
  index_at(setup, constants, q, room.n);
  if (constants.k)
    values_at(setup, *constants.k, q, room.k);
  else
    std::fill(room.k.begin(), room.k.end(), 0.0);
  for (std::size_t i = 0; i < room.n.size(); ++i)
    if (!(room.n[i] > 0 || (room.n[i] == 0 && room.k[i] > 0)))
      return "n = " + number(room.n[i], 6) + " at " + number(q.wavelength_nm[i], 6) +
             " nm; n must be above 0, or 0 with k above 0";
  divide_by_outside(setup, q, room.n, room.k);
  watch.lap(timing.interpolate);
  f64::f0(room.n, room.k, room.r0);
  if (!room.r82.empty()) f64::fresnel_exact(room.n, room.k, f82_cosine, room.r82);
  watch.lap(timing.fresnel);
  return {};
}

}  // namespace etak
