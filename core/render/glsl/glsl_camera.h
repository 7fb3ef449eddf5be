// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/render/camera.h"
#include "core/render/glsl/glsl_glue.h"

namespace etak {

/// The head of a scene's main(): where the pixel's ray meets the object. Afterwards there are `color` (the
/// background), `coverage` and, inside an open `if (coverage > 0.0) {`, position `p`, normal `n` and the
/// direction to the viewer `v`. The uniforms picture_size, background and, in perspective, camera_distance
/// and camera_spread are the caller's.
void camera_text(GlslGlue& glue, const Scene& scene, const Camera& camera);

}  // namespace etak
