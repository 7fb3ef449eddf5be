// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "core/material/material.h"

namespace etak {

/// Whether row `i` of a table of n says n = 0 and k = 0, k read as F0Solver reads it (linear, ends held; no k
/// is 0). That is no medium: most often a number is missing. n = 0 with k above 0 is a metal without loss,
/// which reflects everything.
bool no_medium_in_row(const OpticalConstants& optics, std::size_t i);

/// The wavelength (nm) of the first such row; none for formulas.
std::optional<double> no_medium_at(const OpticalConstants& optics);

}  // namespace etak
