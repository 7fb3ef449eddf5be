// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/image/image.h"
#include "core/render/environment.h"
#include "core/study/fresnel_forms.h"

namespace etak {

/// A sphere as one way to compute its reflectance shows it.
///   picture   R G B A in sRGB codes, colour not multiplied by A, which is the share of a pixel that the
///             sphere covers
///   mean_de, worst_de   CIEDE2000 (D65) against the exact reflectance, over the pixels that lie whole on the
///             sphere, of the colours that the display shows; 0 for the exact one itself
struct SphereLook {
  Image8 picture;
  double mean_de = 0, worst_de = 0;
};

/// The sphere of a material without a body in `around`, drawn with the exact reflectance first, then with that
/// of each form. A pixel shows the radiance around the mirror direction, through the lobe of `gloss`, times F
/// at the angle between viewer and normal. The light is thus the same in all pictures, and they differ by F
/// alone.
///   exposure   linear factor before the display's sRGB curve
///   side       of the square pictures, in pixels; the sphere touches all four sides
std::vector<SphereLook> sphere_looks(const FresnelTruth& truth, std::span<const FresnelForm* const> forms,
                                     const Environment& around, double gloss, double exposure, int side);

}  // namespace etak
