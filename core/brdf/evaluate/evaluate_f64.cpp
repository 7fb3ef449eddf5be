// SPDX-License-Identifier: Apache-2.0
// The formula texts compiled in double: the reference.
#include <cmath>

#include "core/brdf/evaluate/evaluators.h"
#include "core/math/functions.h"

namespace etak::f64 {
namespace {
#include "core/math/real_f64.h"

#include "core/brdf/evaluate/evaluate.h"
#include "core/brdf/evaluate/evaluate_one.inc"
}  // namespace
}  // namespace etak::f64

namespace etak::evaluators {
std::span<const One<double>> all_f64() {
  return f64::one_table;
}
}  // namespace etak::evaluators
