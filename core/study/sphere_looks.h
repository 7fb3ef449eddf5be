// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
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

/// How spheres are drawn.
///   exposure   linear factor before the tone curve
///   side       of the square pictures, in pixels; the sphere touches all four sides
///   passing    SurfaceValues::passing of a clear body; none: nothing is seen through the sphere
struct SphereOptions {
  double gloss = 1, exposure = 1;
  int side = 0;
  std::optional<Vec3> passing = {};
};

/// The sphere of a material in `around`, drawn with the exact reflectance first, then with that of each form. A
/// pixel shows the radiance around the mirror direction, through the lobe of its gloss, times F at the angle
/// between viewer and normal. A clear ball shows besides what it bends into view (core/light/clear_ball.glsl),
/// times (1 - F)^2. The light is thus the same in all pictures, and they differ by F alone. They go through the
/// tone curve of Khronos PBR Neutral, which keeps the hue of what is too bright for a display.
std::vector<SphereLook> sphere_looks(const FresnelTruth& truth, std::span<const FresnelForm* const> forms,
                                     const Environment& around, const SphereOptions& options);

}  // namespace etak
