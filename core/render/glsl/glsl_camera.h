// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/render/camera.h"
#include "core/render/glsl/glsl_glue.h"

namespace etak {

/// Writes the beginning of a scene's main(), which finds where the ray of the pixel meets the object. It sets
/// the variables `color` (the background) and `coverage`, opens the block `if (coverage > 0.0) {`, and in it
/// sets the position `p`, the normal `n` and the direction `v` to the viewer. The caller declares the
/// uniforms picture_size, background and, in perspective, camera_distance and camera_spread.
void camera_text(GlslGlue& glue, const Scene& scene, const Camera& camera);

}  // namespace etak
