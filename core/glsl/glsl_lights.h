// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/glsl/glsl_glue.h"
#include "core/light/area_lobes.h"

namespace etak {

inline bool is_black(const Vec3& color) {
  return color[0] == 0 && color[1] == 0 && color[2] == 0;
}

/// Whether the light has an intensity and a colour above 0.
bool shines(const Light& light);

/// The loops over the scene's discrete lights, as code for the body of shade(). Each loop adds lit() times the
/// irradiance to `sum`. Declares the uniforms of the lights. Lights that do not shine are left out.
///   with_lights   false: no model reflects discrete light, and no loop is written
///   framed        whether lit() takes directions in the frame of tangent, bitangent and normal (t, b, n); else it takes
///                 the normal and directions in the scene
std::string light_loops(GlslGlue& glue, const Scene& scene, bool with_lights, bool framed);

/// Whether the scene has an area light that shines, and one of another kind.
bool has_areas(const Scene& scene);
bool has_discrete(const Scene& scene);

/// The loops over area lights, which call area_specular_model(l, v) and area_diffuse_model(l, v) as lit() is called.
///   lobes     of the specular model; null where there is none
///   diffuse   whether there is a diffuse model
///   gloss     the GLSL expression of the texel's gloss, where the lobes have rows for it
std::string area_loops(GlslGlue& glue, const Scene& scene, const AreaTable* lobes, bool diffuse,
                       const std::string& gloss, bool framed);

}  // namespace etak
