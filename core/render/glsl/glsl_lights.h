// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/render/glsl/glsl_glue.h"

namespace etak {

inline bool is_black(const Vec3& color) {
  return color[0] == 0 && color[1] == 0 && color[2] == 0;
}

/// Whether the light has an intensity and a colour above 0.
bool shines(const Light& light);

/// The loops over the scene's discrete lights, as code for the body of shade(). Each loop adds lit(l,
/// local_v) times the irradiance to `sum`. Declares the uniforms of the lights. Lights that do not shine are
/// left out.
///   with_lights   false: no model reflects discrete light, and no loop is written
std::string light_loops(GlslGlue& glue, const Scene& scene, bool with_lights);

}  // namespace etak
