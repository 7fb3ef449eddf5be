// SPDX-License-Identifier: Apache-2.0
// No include guard: the formula texts in double, for functions*.cpp inside an unnamed namespace. Needs
// <cmath>.
namespace formulas {
#include "core/math/real_f64.h"

#include "core/brdf/texts.h"

#include "core/light/texts.h"
}  // namespace formulas
