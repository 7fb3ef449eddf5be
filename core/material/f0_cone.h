// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/material/f0.h"

namespace etak {

/// The instrument through which a reflectance is seen.
///   aperture   of an objective whose pupil is filled: the reflectance is the mean over its cone, uniform in the squared
///              sine, over s and p; 0: normal incidence alone
///   scatter    share of the reflected light that is lost, [0, 1]
struct Instrument {
  double aperture = 0, scatter = 0;
  bool any() const { return aperture > 0 || scatter > 0; }
};

/// Throws Error for values out of range: an aperture must be below the index outside. The method of the options must be
/// a sum over wavelengths.
void validate(const Instrument& instrument, const F0Options& options);

/// `ahead`, the result at normal incidence under these options, as the instrument has it; without F82, which an aperture
/// does not have. Refused for reflectance data, which tell nothing of a cone.
F0Result seen_through(const Instrument& instrument, const F0Options& options, const Optics& optics,
                      F0Result ahead);

}  // namespace etak
