// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/spectrum/spectrum.h"

namespace etak {

/// How values between two samples are found. Outside the table both hold the end value (and the caller
/// reports the share of the visible weight that lies outside). An unconstrained cubic is not offered: it
/// overshoots at steps, and k or R below zero follows.
///   linear   straight line in wavelength: the reference policy
///   pchip    piecewise cubic Hermite, monotone; slopes by Fritsch and Butland 1984 (harmonic mean), at the
///            ends one-sided three-point slopes, limited as in Fritsch and Carlson 1980
enum class Interpolation { linear, pchip };

std::string_view name(Interpolation interpolation);
std::optional<Interpolation> interpolation_named(std::string_view text);

/// Values of `spectrum` at `at_nm` (ascending), one merge pass over both.
///   out   as long as at_nm
void resample(const Spectrum& spectrum, Interpolation interpolation, std::span<const double> at_nm,
              std::span<double> out);

/// The linear rule on the reference grid 360..830 nm: the same numbers as resample(), faster.
///   out   grid_size values
void resample_to_grid(const Spectrum& spectrum, std::span<double, grid_size> out);

}  // namespace etak
