// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/render/glsl/glsl_text.h"

namespace etak::cli {

/// What `etak shader` is to draw from an atlas.
struct AtlasShader {
  TextureUse use;
  // What is the same all over the material, as `etak shader` takes it: "f0=0.04", "gloss=0.5", ...
  std::vector<std::string> subject;
};

/// Of a material of the layout that `etak pack` wrote; `name` may be empty where there is one alone. Throws
/// Error.
AtlasShader atlas_shader(const std::string& layout_file, const std::string& name);

/// The defines in a file: one a line, "#define " before it or not.
TextureUse defined_use(const std::string& file);

}  // namespace etak::cli
