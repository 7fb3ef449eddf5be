// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/atlas/layout.h"
#include "core/color/rgb.h"
#include "core/render/glsl/glsl_text.h"

namespace etak {

/// What a shader is to draw of a material in an atlas: what it fetches, and what is the same all over the
/// material and so comes as uniforms; a value that is fetched is none here.
///   f0, diffuse   linear sRGB
///   gloss         Schueler's g, [0, 1]
///   opacity       [0, 1]
struct LayoutShader {
  TextureUse use;
  std::optional<LinearRgb> f0, diffuse;
  std::optional<double> gloss, opacity;
};

/// Of `row`, a material of `layout`. Throws Error for defines that are not known.
LayoutShader layout_shader(const AtlasLayout& layout, const AtlasMaterialRow& row);

}  // namespace etak
