// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/study/stability/stability.h"

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
  std::string_view expression;  // the text of `ours`, for GLSL
};
std::span<const StabilityFormula> stability_formulas();

/// A case about data, files or spectra, run through the reader or solver that etak uses.
struct StabilityCheck {
  std::string_view id, title, input, expected, source;
  bool (*run)(std::string& found);  // sets `found` to what happened; true: as expected
};
std::span<const StabilityCheck> stability_checks();

// Two of the checks for any formula, so that a test can see them fail for a wrong one.

/// Whether the integral of D nm over the hemisphere is 1 at the slope m = 0.3.
///   integral   name of a function of `etak eval` that gives the integral for a slope `param`
bool counts_every_facet_once(std::string_view integral, std::string& found);
/// Whether each of the 256 sRGB codes is given for the linear value that it stands for.
bool gives_every_code_back(std::uint8_t (*code_of)(double linear), std::string& found);

}  // namespace etak
