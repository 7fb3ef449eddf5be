// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/color/rgb.h"
#include "core/material/f0.h"
#include "core/material/material.h"
#include "core/spectrum/spectrum.h"

namespace etak {

// The thickness of one layer of a stack, of which all else is known: from the colour of the stack, or from its reflectance
// at normal incidence. Several thicknesses may look alike; all that fit are told.

/// A thickness that fits.
///   interval_nm   first and last thickness that fit as well
///   misfit        of the best: CIEDE2000 of a colour, root mean square of a spectrum
struct FittedThickness {
  double thickness_nm = 0;
  std::array<double, 2> interval_nm{};
  double misfit = 0;
};

/// The largest thickness that is looked for.
inline constexpr double most_thickness_nm = 1000;

/// The thicknesses from 0 to 1 um whose F0 lies within `tolerance` of a colour, best first; none: no thickness does.
///   layer       index in stack.layers; its thickness is not looked at
///   colour      linear sRGB
///   tolerance   CIEDE2000
/// Throws Error as SeenStack does.
std::vector<FittedThickness> thickness_of_colour(const Stack& stack, std::size_t layer,
                                                 const LinearRgb& colour, double tolerance,
                                                 const F0Options& options = {});

/// What fits a spectrum: the best thickness with its interval at 90 %, other orders that fit nearly as well, and CIEDE2000
/// between the colours of the measurement and of the fit; none where the measurement has no colour.
struct SpectrumFit {
  FittedThickness best;
  std::vector<FittedThickness> others;
  std::optional<double> delta_e;
};

/// Least squares over the wavelengths of `measured` within 360 nm and 830 nm, noise taken to be equal and independent: the
/// interval holds what Student's t does not tell from the best at 0.9, other orders what it does not at 0.999. The model is
/// straight between its samples at every nanometre. Throws Error for a spectrum of fewer than 10 samples, and for data that
/// do not cover it.
SpectrumFit thickness_of_spectrum(const Stack& stack, std::size_t layer, const Spectrum& measured,
                                  const F0Options& options = {});

}  // namespace etak
