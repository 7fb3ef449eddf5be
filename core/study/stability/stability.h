// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace etak {

// Stiff and extreme cases: the values of etak where formulas as usually written lose digits, overflow or
// divide by zero, and the treatment of data that no material has.

/// A value, and its error against the expected one.
struct StabilityValue {
  double value = 0;
  double error = 0;  // relative; absolute where 0 is expected; infinity for NaN
  bool passed = true;
};

/// A case and its outcome.
struct StabilityCase {
  std::string id, title, input;
  std::string expected;                                // a number, or what should happen
  std::string source;                                  // of the expectation
  std::optional<StabilityValue> naive_f64, naive_f32;  // the usual formula: its verdict is shown, not counted
  std::optional<StabilityValue> f64, f32, gl;
  std::string found;                  // what happened, in cases that give no number
  double most_f64 = 0, most_f32 = 0;  // allowed errors; GL has that of single precision times gl_allowance
  bool passed = false;
};

/// Factor of the error that GL may have over single precision in C++: exp2, log2, pow and division of shaders
/// may be wrong by some units in the last place.
inline constexpr double gl_allowance = 100;

/// Evaluates a GLSL expression of etak's formula texts on a GPU; nullopt where that failed.
using GlEvaluate = std::function<std::optional<double>(std::string_view expression)>;

/// Runs every case through the code that etak uses. The order of the cases is fixed.
///   gl   none: the values of GL stay empty
std::vector<StabilityCase> stability_cases(const GlEvaluate& gl = {});

bool all_passed(const std::vector<StabilityCase>& cases);

/// Whether the formula as usually written is outside of the allowed error, in double or in single precision.
/// False for cases without a usual formula.
bool usual_fails(const StabilityCase& one);

}  // namespace etak
