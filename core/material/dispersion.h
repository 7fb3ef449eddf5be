// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "core/material/material.h"

namespace etak {

/// n of a dispersion formula at `at_nm`, wavelengths outside the stated range taken at its nearer end. NaN
/// where the formula gives n^2 < 0 or a pole is hit; formula numbers outside 1..9 and too few coefficients
/// are the caller's mistake (validate() finds them).
///   from   refractiveindex.info, "Dispersion formulas": 1 Sellmeier, 2 Sellmeier-2, 3 polynomial,
///          4 RefractiveIndex.INFO, 5 Cauchy, 6 gases, 7 Herzberger, 8 retro, 9 exotic
void evaluate(const DispersionFormula& formula, std::span<const double> at_nm, std::span<double> n);

/// What is wrong with a formula, in a few words; empty when nothing is. validate() throws it.
std::string_view defect(const DispersionFormula& formula);

/// Throws Error (naming `what`) for an unknown number, too few or too many coefficients, non-finite ones, or
/// an empty or non-positive range.
void validate(const DispersionFormula& formula, std::string_view what);

}  // namespace etak
