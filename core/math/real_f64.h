// SPDX-License-Identifier: Apache-2.0
// No include guard: makes the namespace it is included in one where the formula texts (*.glsl) compile as C++
// in double, the reference. real_f32.h does the same in float. Needs core/math/functions.h; the texts follow.
using real = double;
[[maybe_unused]] constexpr real tiny = 1e-300;         // divisors stay above it
[[maybe_unused]] constexpr real power_floor = -1e300;  // no floor: doubles underflow late enough
[[maybe_unused]] constexpr real exponent_floor = -1e300;
[[maybe_unused]] constexpr real largest_reflectance = 1 - 1e-12;  // an index stays finite below it
#include "core/math/glsl.h"
