// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/render/glsl/glsl_glue.h"

namespace etak {

inline bool is_black(const Vec3& color) {
  return color[0] == 0 && color[1] == 0 && color[2] == 0;
}

bool shines(const Light& light);

/// Loops over the scene's discrete lights for the body of shade(), each of which adds to `sum` what lit(l,
/// local_v) gives; declares their uniforms. Lights that do not shine are left out.
///   with_lights   some model answers to discrete light; false: nothing is written
std::string light_loops(GlslGlue& glue, const Scene& scene, bool with_lights);

}  // namespace etak
