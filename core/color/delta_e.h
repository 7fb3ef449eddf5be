// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/color/rgb.h"
#include "core/math/mat3.h"

namespace etak {

/// CIE L*a*b* (CIE 15:2004); L in [0, 100] for reflectances.
struct Lab {
  double l = 0, a = 0, b = 0;
  friend bool operator==(const Lab&, const Lab&) = default;
};

Lab to_lab(const Xyz& color, const Xyz& white);

/// Linear sRGB (D65) to Lab.
Lab to_lab(const LinearRgb& srgb);

/// CIEDE2000 with kL = kC = kH = 1.
///   from   Sharma, Wu and Dalal 2005, "The CIEDE2000 Color-Difference Formula", Color Res. Appl. 30(1)
double delta_e2000(const Lab& a, const Lab& b);

/// CIEDE2000 of small differences: the square of one is difference * (matrix * difference), in L, a and b.
///   from   the same, with what its means are at one colour, where the chroma's own stretch does not change
Mat3 delta_e2000_around(const Lab& at);

}  // namespace etak
