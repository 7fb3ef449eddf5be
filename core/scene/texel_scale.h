// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/scene/material_uses.h"

namespace etak {

/// How large the texels of a texture are in the world, and from the scene's cameras.
struct TexelScale {
  // Texels per unit of the world along the direction that has the fewest, on the triangle that has the
  // fewest; 0: a triangle reads one point only, or there is none.
  double least_density = 0;
  bool seen = false;  // some triangle lies before a camera, at whatever angle and behind whatever else
  // log2 of the texels that a pixel covers, at the place with the fewest and at the one with the most, over
  // the triangles that are seen.
  //   least_level   along the direction of the fewest texels, at the nearest corner, in the corner of a
  //                 picture of 16:9 (where a pixel covers least)
  //   most_level    along the direction of the most texels, at the farthest corner, looked at face on
  double least_level = 0, most_level = 0;
};

/// Looks at all triangles of a material.
///   texture         whose UVs count
///   width, height   of the texture's picture, in texels
///   view_height     of the cameras' pictures, in pixels; 0: cameras are not looked at
TexelScale texel_scale(const MaterialUses& uses, int material, const GltfTexture& texture, int width,
                       int height, int view_height);

}  // namespace etak
