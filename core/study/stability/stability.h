// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace etak {

// The stiff and extreme cases: what etak gives where formulas as usually written lose digits, overflow or
// divide by zero, and what it does with data that no material has.

/// One value and how far it is from the expected one.
struct StabilityValue {
  double value = 0;
  double error = 0;  // relative; absolute where 0 is expected; infinity for NaN
  bool passed = true;
};

struct StabilityCase {
  std::string id, title, input;
  std::string expected;                                // a number, or what should happen
  std::string source;                                  // of the expectation
  std::optional<StabilityValue> naive_f64, naive_f32;  // the usual formula: its verdict is shown, not counted
  std::optional<StabilityValue> f64, f32, gl;
  std::string found;                  // of cases that are no number: what happened
  double most_f64 = 0, most_f32 = 0;  // allowed errors; GL has that of single precision times gl_allowance
  bool passed = false;
};

/// Shader arithmetic has fewer rules than C's: exp2, log2, pow and division may be off by some units in the
/// last place.
inline constexpr double gl_allowance = 100;

/// Evaluates a GLSL expression of etak's formula texts on a GPU; none where that failed.
using GlEvaluate = std::function<std::optional<double>(std::string_view expression)>;

/// Every case through the real code. The order is fixed.
///   gl   none: the GL column stays empty
std::vector<StabilityCase> stability_cases(const GlEvaluate& gl = {});

bool all_passed(const std::vector<StabilityCase>& cases);

}  // namespace etak
