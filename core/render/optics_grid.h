// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "core/material/material.h"

namespace etak {

/// n and k on the reference grid of 1 nm, 360..830 nm. Between samples they are linear, outside of the
/// samples they keep the end values, and a missing k is 0.
struct GridIndex {
  std::array<double, grid_size> n{}, k{};
};

/// The index on the grid. Throws Error that names `what` where n is negative or NaN, and where n is 0 and k
/// is not above 0.
GridIndex grid_index(const OpticalConstants& optics, std::string_view what);

}  // namespace etak
