// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/material/f0.h"
#include "core/material/material.h"

namespace etak {

/// The curves of a dataset over 360-830 nm, for plots. They end where the data end; no value is held beyond.
///   n_nm, k_nm, r_nm   wavelengths, ascending, 1 nm apart but for the ends of the data
///   n, k               as published, against vacuum; k empty where none is given
///   r0, r82            reflectance at normal incidence and at cos 1/7, with the options' outside medium; NaN
///                      where n is not above 0; r82 empty for reflectance data
///   sample_nm          the table's own wavelengths inside 360-830 nm (those of the reflectance for
///                      reflectance data); empty for a formula
struct OpticsCurves {
  std::vector<double> n_nm, n, k_nm, k, r_nm, r0, r82, sample_nm;
};

/// The curves of `optics`. Of the options only interpolation and outside medium are used.
OpticsCurves curves_of(const Optics& optics, const F0Options& options);

}  // namespace etak
