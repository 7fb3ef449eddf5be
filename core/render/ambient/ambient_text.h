// SPDX-License-Identifier: Apache-2.0
// The formulas of light from all around in double precision, as the namespace ambient_text. There is no include guard:
// include this once in an unnamed namespace.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"  // no including source uses every function
namespace ambient_text {
#include "core/math/real_f64.h"

#include "core/light/ambient.glsl"
}  // namespace ambient_text
#pragma GCC diagnostic pop
