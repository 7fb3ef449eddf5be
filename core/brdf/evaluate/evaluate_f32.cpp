// SPDX-License-Identifier: Apache-2.0
// The formula texts compiled in float, the precision of a GPU, with exp and pow of the C library.
#include <cmath>

#include "core/brdf/evaluate/evaluators.h"
#include "core/math/functions.h"

namespace etak::f32 {
namespace {
#include "core/math/real_f32.h"

#include "core/brdf/evaluate/evaluate.h"
#include "core/brdf/evaluate/evaluate_one.inc"
}  // namespace
}  // namespace etak::f32

namespace etak::evaluators {
std::span<const One<float>> all_f32() {
  return f32::one_table;
}
}  // namespace etak::evaluators
