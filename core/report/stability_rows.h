// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/report/stability.h"

namespace etak {

/// A row of stability_formulas.inc.
struct StabilityFormula {
  std::string_view id, title, input;
  double expected, most_f64, most_f32;
  std::string_view source;
  double (*naive_f64)();
  double (*naive_f32)();
  double (*ours_f64)();
  double (*ours_f32)();
  std::string_view expression;  // of ours, for GLSL
};
std::span<const StabilityFormula> stability_formulas();

/// A case about data, files or spectra: runs the real reader or solver and says what happened.
struct StabilityCheck {
  std::string_view id, title, input, expected, source;
  bool (*run)(std::string& found);  // true: as expected
};
std::span<const StabilityCheck> stability_checks();

}  // namespace etak
