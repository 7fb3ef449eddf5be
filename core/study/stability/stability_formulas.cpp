// SPDX-License-Identifier: Apache-2.0
// Compiles the formula texts in double and in single precision, and the rows of stability_formulas.inc with
// both.
#include <cmath>

#include "core/math/functions.h"
#include "core/study/stability/stability_rows.h"

#pragma GCC diagnostic push
// Some of the naive forms divide by zero, which is what their cases show.
#pragma GCC diagnostic ignored "-Wdiv-by-zero"

// One layer on a base, and a metal under a coat: the naive form has the numbers of ours.
#define ETAK_ONE_LAYER(form, n0, c, n, k, n1, k1, turns)                                               \
  form##_mean(form##_over(form##_on(real(n0), real(c), real(n), real(k)), real(n0), real(c), real(n1), \
                          real(k1), real(turns)),                                                      \
              real(n0), real(c))
#define ETAK_FILM(id, title, input, n0, c, n, k, n1, k1, turns, ...)                  \
  ETAK_STABILITY(id, title, input, ETAK_ONE_LAYER(naive, n0, c, n, k, n1, k1, turns), \
                 ETAK_ONE_LAYER(film, n0, c, n, k, n1, k1, turns), __VA_ARGS__)
#define ETAK_COAT(id, title, input, ours, f0, f82, n, ...)                                             \
  ETAK_STABILITY(id, title, input, naive_under(real(f0), real(n)), ours(real(f0), real(f82), real(n)), \
                 __VA_ARGS__)

namespace etak {
namespace {

namespace in_double {
#include "core/math/real_f64.h"

#include "core/brdf/texts.h"

#include "core/brdf/textbook.glsl"

#include "core/film/texts.h"

#include "core/film/textbook.glsl"

#include "core/light/texts.h"

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

// Powers below 2^power_floor are cut off as in shaders, which keeps loops in float fast.
namespace in_single {
#include "core/math/real_f32.h"

#include "core/brdf/texts.h"

#include "core/brdf/textbook.glsl"

#include "core/film/texts.h"

#include "core/film/textbook.glsl"

#include "core/light/texts.h"

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
