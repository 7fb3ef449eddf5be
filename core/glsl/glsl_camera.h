// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/glsl/glsl_glue.h"
#include "core/render/camera.h"

namespace etak {

/// Writes the beginning of a scene's main(), which finds where the ray of the pixel meets the object. It sets
/// the variables `color` (the background) and `coverage`, opens the block `if (coverage > 0.0) {`, and in it
/// sets the position `p`, the normal `n` and the direction `v` to the viewer. The caller declares the
/// uniforms picture_size, background and, in perspective, camera_distance and camera_spread.
/// Where the scene has a backdrop that is not plain, main() begins with the variable `behind`, by
/// backdrop_text(); backdrop_name() is what the radiance behind the pixel is called.
///   backdrop_apart   the backdrop beside the object is drawn by beside_text(), so that this is drawn around the
///                    object alone
void camera_text(GlslGlue& glue, const Scene& scene, const Camera& camera, bool backdrop_apart = false);

/// Writes the beginning of the main() that draws the backdrop of a window's scene beside the object, up to the
/// variable `color`.
void beside_text(GlslGlue& glue, const Scene& scene, const Camera& camera);

/// Whether the backdrop differs from pixel to pixel.
bool has_backdrop(const Scene& scene);
inline std::string backdrop_name(const Scene& scene) {
  return has_backdrop(scene) ? "behind" : "background";
}

/// The name of a direction in the environment's map, of one in the scene. The caller declares the uniform
/// environment_turn where the scene is turned.
std::string in_environment_map(const Scene& scene, const std::string& direction);

}  // namespace etak
