// SPDX-License-Identifier: Apache-2.0
#include "core/study/stability/stability.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/number.h"
#include "core/study/stability/stability_rows.h"

namespace etak {
namespace {

constexpr int expected_digits = 10;

StabilityValue judged(double value, double expected, double most) {
  StabilityValue out;
  out.value = value;
  out.error = std::abs(value - expected) / (expected == 0 ? 1 : std::abs(expected));
  if (std::isnan(value)) out.error = std::numeric_limits<double>::infinity();
  out.passed = out.error <= most;
  return out;
}

}  // namespace

std::vector<StabilityCase> stability_cases(const GlEvaluate& gl) {
  std::vector<StabilityCase> out;
  for (const StabilityFormula& row : stability_formulas()) {
    StabilityCase one;
    one.id = row.id;
    one.title = row.title;
    one.input = row.input;
    one.expected = number(row.expected, expected_digits);
    one.source = row.source;
    one.most_f64 = row.most_f64;
    one.most_f32 = row.most_f32;
    one.naive_f64 = judged(row.naive_f64(), row.expected, row.most_f64);
    one.naive_f32 = judged(row.naive_f32(), row.expected, row.most_f32);
    one.f64 = judged(row.ours_f64(), row.expected, row.most_f64);
    one.f32 = judged(row.ours_f32(), row.expected, row.most_f32);
    if (gl)
      if (const auto value = gl(row.expression))
        one.gl = judged(*value, row.expected, row.most_f32 * gl_allowance);
    one.passed = one.f64->passed && one.f32->passed && (!gl || (one.gl && one.gl->passed));
    out.push_back(std::move(one));
  }
  for (const StabilityCheck& check : stability_checks()) {
    StabilityCase one;
    one.id = check.id;
    one.title = check.title;
    one.input = check.input;
    one.expected = check.expected;
    one.source = check.source;
    one.passed = check.run(one.found);
    out.push_back(std::move(one));
  }
  return out;
}

bool all_passed(const std::vector<StabilityCase>& cases) {
  return std::all_of(cases.begin(), cases.end(), [](const StabilityCase& one) { return one.passed; });
}

bool usual_fails(const StabilityCase& one) {
  return one.naive_f64 && one.naive_f32 && !(one.naive_f64->passed && one.naive_f32->passed);
}

}  // namespace etak
