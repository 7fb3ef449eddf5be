// SPDX-License-Identifier: Apache-2.0
// No include guard: makes the namespace it is included in one where the formula texts (*.glsl) compile as C++
// in float, with the constants that shaders get from resources/shaders/constants.glsl. Needs core/math/functions.h;
// the texts are included after this file.
using real = float;
[[maybe_unused]] constexpr real tiny = 1e-37f;         // divisors stay above it
[[maybe_unused]] constexpr real power_floor = -90;     // of powers of 2: subnormal numbers slow a loop down
[[maybe_unused]] constexpr real exponent_floor = -62;  // e^-62 is about 2^-90
[[maybe_unused]] constexpr real largest_reflectance = 1 - 1e-6f;  // an index stays finite below it
#include "core/math/glsl.h"
