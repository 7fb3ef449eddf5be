// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "core/material/f0.h"

// What F0Solver asks of data before it integrates them.
namespace etak {

struct Range {
  double first_nm, last_nm;
};
Range range_of(const OpticalConstants& optics);

/// Running sums of the three weights over the reference grid; [0] is 0.
using WeightSums = std::array<std::array<double, 3>, grid_size + 1>;
WeightSums weight_sums(Viewing viewing);

///   table   of n or of the reflectance; null for a formula
Coverage coverage_of(Range range, const Spectrum* table, const WeightSums& sums);

/// Whether a table of n or reflectance has fewer than 10 samples in 400..700 nm; false for a formula.
bool is_sparse(const Coverage& coverage);
bool is_sparse(const Optics& optics);

/// Two sources at once (axes of a crystal): only what all of them cover counts.
void intersect(Coverage& a, const Coverage& b);

/// Adds all wavelengths at which the optics are not smooth; `knots` is ascending and stays so.
void append_knots(const Optics& optics, std::vector<double>& knots);
void append_knots(const OpticalConstants& constants, std::vector<double>& knots);

/// The smallest distance between neighbouring samples of one table inside 360..830 nm; infinite for formulas.
double finest_spacing_nm(const Optics& optics);

}  // namespace etak
