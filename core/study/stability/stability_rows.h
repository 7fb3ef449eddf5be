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
  std::string_view expression;  // of ours, for GLSL
};
std::span<const StabilityFormula> stability_formulas();

/// A case about data, files or spectra: runs the real reader or solver and says what happened.
struct StabilityCheck {
  std::string_view id, title, input, expected, source;
  bool (*run)(std::string& found);  // true: as expected
};
std::span<const StabilityCheck> stability_checks();

// What two of the checks ask, of any formula: so that a test can put the wrong one in.

/// Whether the integral of D nm is 1.
///   integral   a function of `etak eval` that takes the slope m
bool counts_every_facet_once(std::string_view integral, std::string& found);
/// Whether each code comes out of the value it stands for.
bool gives_every_code_back(std::uint8_t (*code_of)(double linear), std::string& found);

}  // namespace etak
