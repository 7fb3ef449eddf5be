// SPDX-License-Identifier: Apache-2.0
// The formula texts compiled in double, for functions*.cpp. There is no include guard: each of these sources
// includes this inside an unnamed namespace, after core/math/functions.h.
namespace formulas {
#include "core/math/real_f64.h"

#include "core/brdf/texts.h"

#include "core/light/texts.h"
}  // namespace formulas
