// SPDX-License-Identifier: Apache-2.0
// The formula texts twice, in double and in single precision, and the rows of stability_formulas.inc through
// both.
#include <cmath>

#include "core/study/stability/stability_rows.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-parameter"
// The naive forms divide by zero: that is what they are here for.
#pragma GCC diagnostic ignored "-Wdiv-by-zero"

namespace etak {
namespace {

namespace in_double {
using real = double;
constexpr real tiny = 1e-300;
constexpr real power_floor = -1e300;
constexpr real exponent_floor = -1e300;
constexpr real largest_reflectance = 1 - 1e-12;
#include "core/math/glsl.h"
// The order is the meaning.
// clang-format off
#include "core/brdf/texts.h"
#include "core/brdf/textbook.glsl"
#include "core/light/hemispheres.glsl"
#include "core/light/transfer.glsl"
// clang-format on

#define ETAK_STABILITY(id, title, input, naive, ours, expected, most64, most32, source) \
  double naive_##id() {                                                                 \
    return naive;                                                                       \
  }                                                                                     \
  double ours_##id() {                                                                  \
    return ours;                                                                        \
  }
#include "core/study/stability/stability_formulas.inc"
#undef ETAK_STABILITY
}  // namespace in_double

// As in a shader: what only keeps loops fast (power_floor) is in.
namespace in_single {
using real = float;
constexpr real tiny = 1e-37f;
constexpr real power_floor = -90;
constexpr real exponent_floor = -62;
constexpr real largest_reflectance = 1 - 1e-6f;
#include "core/math/glsl.h"
// The order is the meaning.
// clang-format off
#include "core/brdf/texts.h"
#include "core/brdf/textbook.glsl"
#include "core/light/hemispheres.glsl"
#include "core/light/transfer.glsl"
// clang-format on

#define ETAK_STABILITY(id, title, input, naive, ours, expected, most64, most32, source) \
  float naive_##id() {                                                                  \
    return naive;                                                                       \
  }                                                                                     \
  float ours_##id() {                                                                   \
    return ours;                                                                        \
  }
#include "core/study/stability/stability_formulas.inc"
#undef ETAK_STABILITY
}  // namespace in_single
#pragma GCC diagnostic pop

}  // namespace

std::span<const StabilityFormula> stability_formulas() {
#define ETAK_STABILITY(id, title, input, naive, ours, expected, most64, most32, source) \
  {#id,                                                                                 \
   title,                                                                               \
   input,                                                                               \
   expected,                                                                            \
   most64,                                                                              \
   most32,                                                                              \
   source,                                                                              \
   [] { return in_double::naive_##id(); },                                              \
   [] { return double{in_single::naive_##id()}; },                                      \
   [] { return in_double::ours_##id(); },                                               \
   [] { return double{in_single::ours_##id()}; },                                       \
   #ours},
  static constexpr StabilityFormula rows[] = {
#include "core/study/stability/stability_formulas.inc"
  };
#undef ETAK_STABILITY
  return rows;
}

}  // namespace etak
