// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/render/glsl/glsl_text.h"

namespace etak {

/// The part of a shader that reads a material's texels: variables texel_diffuse, texel_f0, texel_gloss and
/// texel_opacity (those that are asked for), and `void fetch(vec2 at)`, which sets them for a place in
/// [-1, 1]^2, row 1 on top.
struct TextureFetch {
  std::string code;
  std::vector<GlslUniform> uniforms;
  std::vector<GlslFeature> features;
  bool any = false;  // there is a fetch() to call
};

///   opacity   where no texture says it
TextureFetch texture_fetch(const TextureUse& use, double opacity);

}  // namespace etak
