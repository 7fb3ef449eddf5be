// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "core/material/material.h"

namespace etak {

/// n and k on the reference grid of 1 nm, 360..830 nm: linear between samples, ends held, no k taken as 0.
struct GridIndex {
  std::array<double, grid_size> n{}, k{};
};

/// Throws Error (naming `what`) where n is not above 0.
GridIndex grid_index(const OpticalConstants& optics, std::string_view what);

}  // namespace etak
