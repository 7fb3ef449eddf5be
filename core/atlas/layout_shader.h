// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/atlas/layout.h"
#include "core/color/rgb.h"
#include "core/glsl/glsl_text.h"

namespace etak {

/// What a shader of a material in an atlas needs: which values it fetches from textures, and the values that
/// are the same in all texels and therefore come as uniforms. A value that is fetched is none here.
///   f0, diffuse   linear sRGB
///   gloss         Schueler's g, [0, 1]
///   opacity       [0, 1]
struct LayoutShader {
  TextureUse use;
  std::optional<LinearRgb> f0, diffuse;
  std::optional<double> gloss, opacity;
};

/// The shader of `row`, a material of `layout`. Throws Error for defines that are not known.
LayoutShader layout_shader(const AtlasLayout& layout, const AtlasMaterialRow& row);

}  // namespace etak
