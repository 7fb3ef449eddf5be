// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/material/material.h"
#include "core/spectrum/interpolate.h"

namespace etak {

/// How optics are read at wavelengths of one's own.
///   extrapolate   wavelengths outside of the data take the value at the nearer end, instead of being refused
struct ReadOptions {
  Interpolation interpolation = Interpolation::linear;
  bool extrapolate = false;
};

/// n at wavelengths in nanometres, in any order. Throws Error (naming `what`) for a wavelength that is no
/// positive number, or outside of the data and not to be extrapolated, and where a formula has no value.
std::vector<double> n_at(const OpticalConstants& optics, std::span<const double> at_nm, std::string_view what,
                         const ReadOptions& options = {});

/// k at wavelengths. Throws Error where no k is given: it is then not known, though F0Solver takes 0.
std::vector<double> k_at(const OpticalConstants& optics, std::span<const double> at_nm, std::string_view what,
                         const ReadOptions& options = {});

/// The values of a table at wavelengths.
std::vector<double> values_at(const Spectrum& table, std::span<const double> at_nm, std::string_view what,
                              const ReadOptions& options = {});

}  // namespace etak
