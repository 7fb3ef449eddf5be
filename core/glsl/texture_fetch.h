// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/glsl/glsl_text.h"

namespace etak {

/// The part of a shader that reads the texels of a material: the variables texel_diffuse, texel_f0,
/// texel_gloss and texel_opacity, as far as they are fetched, and `void fetch(vec2 at)`, which sets them for
/// a place in [-1, 1]^2 where y = 1 is the top of the picture.
struct TextureFetch {
  std::string code;
  std::vector<GlslUniform> uniforms;
  std::vector<GlslFeature> features;
  bool any = false;  // whether there is a fetch() to call
};

/// The code for one use of the textures.
///   opacity   used where it is not fetched
TextureFetch texture_fetch(const TextureUse& use, double opacity);

}  // namespace etak
