// SPDX-License-Identifier: Apache-2.0
// No include guard: the formula texts in double, for functions*.cpp inside an unnamed namespace. Needs
// <cmath>.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-parameter"
namespace formulas {
using real = double;
constexpr real tiny = 1e-300;
constexpr real power_floor = -1e300;
constexpr real exponent_floor = -1e300;
constexpr real largest_reflectance = 1 - 1e-12;
#include "core/math/glsl.h"

#include "core/brdf/texts.h"
#include "core/light/hemispheres.glsl"
#include "core/light/lights.glsl"
#include "core/light/transparency.glsl"
}  // namespace formulas
#pragma GCC diagnostic pop
