// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/color/colorspace.h"

namespace etak::test {

/// The white of chromaticity x, y, with Y = 1.
inline Xyz white_of(double x, double y) {
  return {x / y, 1, (1 - x - y) / y};
}

inline const Xyz d65 = white_of(0.3127, 0.3290);
inline const Xyz aces_white = white_of(0.32168, 0.33767);

}  // namespace etak::test
