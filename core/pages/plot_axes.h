// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/plot/svg_plot.h"
#include "core/spectrum/spectrum.h"

namespace etak {

/// Wavelength over the whole grid of colour, in nanometres.
inline PlotAxis wavelength_axis() {
  return {"wavelength, nm", grid_first_nm, grid_last_nm, {400, 500, 600, 700, 800}};
}

/// The range of the finite values that were added.
struct Extent {
  double least = INFINITY, most = -INFINITY;

  void add(const std::vector<double>& values) {
    for (const double value : values)
      if (std::isfinite(value)) {
        least = std::min(least, value);
        most = std::max(most, value);
      }
  }
  bool empty() const { return least > most; }
};

}  // namespace etak
