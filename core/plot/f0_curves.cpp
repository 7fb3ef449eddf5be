// SPDX-License-Identifier: Apache-2.0
#include "core/plot/f0_curves.h"

#include <algorithm>
#include <cmath>

#include "core/fresnel/fresnel.h"
#include "core/material/dispersion.h"
#include "core/material/f0/f0_steps.h"
#include "core/spectrum/interpolate.h"

namespace etak {
namespace {

std::vector<double> grid_between(double first_nm, double last_nm) {
  first_nm = std::max<double>(first_nm, grid_first_nm);
  last_nm = std::min<double>(last_nm, grid_last_nm);
  std::vector<double> nm;
  if (first_nm > last_nm) return nm;
  nm.push_back(first_nm);
  for (double w = std::floor(first_nm) + 1; w < last_nm; ++w) nm.push_back(w);
  if (last_nm > first_nm) nm.push_back(last_nm);
  return nm;
}

std::vector<double> grid_of(const Spectrum& table) {
  return grid_between(table.first_nm(), table.last_nm());
}

std::vector<double> values(const Spectrum& table, const std::vector<double>& nm,
                           Interpolation interpolation) {
  std::vector<double> out(nm.size());
  resample(table, interpolation, nm, out);
  return out;
}

std::vector<double> index_at(const OpticalConstants& constants, const std::vector<double>& nm,
                             Interpolation interpolation) {
  if (const auto* table = std::get_if<Spectrum>(&constants.n)) return values(*table, nm, interpolation);
  std::vector<double> out(nm.size());
  evaluate(std::get<DispersionFormula>(constants.n), nm, out);
  return out;
}

std::vector<double> samples_of(const Spectrum& table) {
  std::vector<double> nm;
  for (const double w : table.wavelength_nm)
    if (w >= grid_first_nm && w <= grid_last_nm) nm.push_back(w);
  return nm;
}

// A stack has no n and k of its own. No curves where its reflectance is not known.
OpticsCurves curves_of(const Stack& stack, const F0Options& options) {
  OpticsCurves curves;
  const F0Setup setup = f0_setup(options);
  Quadrature at;
  at.wavelength_nm = grid_between(grid_first_nm, grid_last_nm);
  F0Spectra room;
  room.resize(at.wavelength_nm.size());
  Stopwatch watch(false);
  F0Timing ignored;
  if (!reflectance_at(setup, stack, at, room, watch, ignored).empty()) return curves;
  curves.r_nm = std::move(at.wavelength_nm);
  curves.r0 = std::move(room.r0);
  curves.r82 = std::move(room.r82);
  return curves;
}

}  // namespace

OpticsCurves curves_of(const Optics& optics, const F0Options& options) {
  OpticsCurves curves;
  if (const auto* reflectance = std::get_if<Reflectance>(&optics)) {
    curves.r_nm = grid_of(reflectance->spectrum);
    curves.r0 = values(reflectance->spectrum, curves.r_nm, options.interpolation);
    curves.sample_nm = samples_of(reflectance->spectrum);
    return curves;
  }
  if (const auto* stack = std::get_if<Stack>(&optics)) return curves_of(*stack, options);
  const auto& constants = std::get<OpticalConstants>(optics);
  if (const auto* table = std::get_if<Spectrum>(&constants.n)) {
    curves.n_nm = grid_of(*table);
    curves.sample_nm = samples_of(*table);
  } else {
    const auto& formula = std::get<DispersionFormula>(constants.n);
    curves.n_nm = grid_between(formula.first_nm, formula.last_nm);
  }
  curves.n = index_at(constants, curves.n_nm, options.interpolation);
  std::vector<double> k(curves.n.size(), 0.0);
  if (constants.k) {
    curves.k_nm = grid_of(*constants.k);
    curves.k = values(*constants.k, curves.k_nm, options.interpolation);
    resample(*constants.k, options.interpolation, curves.n_nm, k);
  }

  std::vector<double> outside(curves.n.size(), 1.0);
  if (const auto* medium = std::get_if<OpticalConstants>(&options.outside.index))
    outside = index_at(*medium, curves.n_nm, options.interpolation);
  else
    std::fill(outside.begin(), outside.end(), std::get<double>(options.outside.index));
  curves.r_nm = curves.n_nm;
  for (std::size_t i = 0; i < curves.n.size(); ++i) {
    const double n = curves.n[i] / outside[i], kappa = k[i] / outside[i];
    curves.r0.push_back(n > 0 ? f64::f0(n, kappa) : std::nan(""));
    curves.r82.push_back(n > 0 ? f64::fresnel_exact(n, kappa, f82_cosine) : std::nan(""));
  }
  return curves;
}

}  // namespace etak
