// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "core/color/rgb.h"

namespace etak {

/// Amounts by which the channels of a linear colour leave [0, 1]: positive above 1, negative below 0; 0
/// inside, and for amounts that are no more than rounding errors.
std::array<double, 3> gamut_excess(const LinearRgb& color);

/// gamut_excess() for people: "r +0.0428, b -0.0011"; empty for a colour inside.
std::string gamut_text(const LinearRgb& color);

}  // namespace etak
