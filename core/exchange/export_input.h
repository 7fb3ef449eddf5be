// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "core/exchange/export_surface.h"
#include "core/exchange/material_input.h"
#include "core/material/f0_coat.h"

namespace etak {

/// What is asked of an exported surface beside its optics.
struct ExportWishes {
  std::optional<LinearRgb> diffuse;  // of dielectrics; none: as export_surface() has it
  std::optional<Gloss> gloss;
  double opacity = 1;
  bool axis_average = false;  // crystals as random grains: solve_averaged()
  LinearRgb emission{0, 0, 0};
  std::optional<Coat> coat = {};  // a clear layer over it; not beside axis_average
};

/// The surface of an input, or why its F0 is refused.
struct ExportAnswer {
  std::optional<ExportSurface> surface;  // its notes hold what its name was answered by
  std::string dataset, refusal;
  std::string remark;  // a wish that the material does not take
};

/// Throws Error for a coat beside another medium outside than air.
void validate(const ExportWishes& wishes, const F0Options& options);

/// export_surface() of what is named. Throws Error for what cannot be read, and for wishes out of range.
ExportAnswer export_answer(const MaterialInput& input, const TableOptions& tables, const F0Solver& solver,
                           const ExportWishes& wishes);

}  // namespace etak
