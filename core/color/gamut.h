// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "core/color/rgb.h"

namespace etak {

/// Amounts by which the channels of a linear colour leave [0, 1]: above 0 beyond 1, below 0 beyond 0; 0
/// inside, and where it is no more than what rounding leaves behind.
std::array<double, 3> gamut_excess(const LinearRgb& color);

/// The same for people: "r +0.0428, b -0.0011"; empty for a colour inside.
std::string gamut_text(const LinearRgb& color);

}  // namespace etak
