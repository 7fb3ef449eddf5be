// SPDX-License-Identifier: Apache-2.0
// The formula texts in double: the reference.
#include <cmath>

#include "core/brdf/evaluate/evaluators.h"

namespace etak::f64 {
namespace {
using real = double;
constexpr real tiny = 1e-300;
constexpr real power_floor = -1e300;
constexpr real exponent_floor = -1e300;
constexpr real largest_reflectance = 1 - 1e-12;
#include "core/brdf/evaluate/evaluate.h"
#include "core/brdf/evaluate/evaluate_one.inc"
}  // namespace
}  // namespace etak::f64

namespace etak::evaluators {
std::span<const One<double>> all_f64() {
  return f64::one_table;
}
}  // namespace etak::evaluators
