// SPDX-License-Identifier: Apache-2.0
#include "core/material/optics/medium.h"

#include "core/spectrum/interpolate.h"

namespace etak {

bool no_medium_in_row(const OpticalConstants& optics, std::size_t i) {
  const Spectrum& n = std::get<Spectrum>(optics.n);
  if (n.value[i] != 0) return false;
  const double nm[] = {n.wavelength_nm[i]};
  double k[] = {0};
  if (optics.k) resample(*optics.k, Interpolation::linear, nm, k);
  return !(k[0] > 0);
}

std::optional<double> no_medium_at(const OpticalConstants& optics) {
  const auto* n = std::get_if<Spectrum>(&optics.n);
  if (n == nullptr) return {};
  for (std::size_t i = 0; i < n->size(); ++i)
    if (no_medium_in_row(optics, i)) return n->wavelength_nm[i];
  return {};
}

}  // namespace etak
