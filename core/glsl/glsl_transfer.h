// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/glsl/glsl_glue.h"
#include "core/glsl/glsl_text.h"

namespace etak {

/// Writes the steps from the linear `color` of a pixel to the code of the screen: exposure, then the display's own
/// function or, where `display` is null, the scene's tone curve and transfer.
void transfer_text(GlslGlue& glue, const Scene& scene, const GlslDisplay* display);

/// Writes the tints and stripes over `object` (core/light/marks.glsl), where the scene asks for them.
///   body_color   the GLSL expression of the diffuse colour, of a scene with textures
void marks_text(GlslGlue& glue, const Scene& scene, const std::string& body_color);

}  // namespace etak
