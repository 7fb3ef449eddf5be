// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/brdf/models.h"
#include "core/render/glsl/glsl_glue.h"

namespace etak {

/// Declares the model's parameters as uniforms, "specular_K" for the part "specular", and gives the call that
/// evaluates it, for Angles `a`. Throws Error for values that do not fit the model, and for a model that no
/// texture can feed.
///   opacity    scales what is diffuse in it: every model is linear in its diffuse colour
///   textured   parameters that follow a texture are taken from body_here and gloss_here
///   textures   of an atlas: what it holds is taken from its texels; null: none
std::string model_call(GlslGlue& glue, const std::string& part, const Model& model,
                       const std::vector<double>& values, double opacity, bool textured = false,
                       const TextureUse* textures = nullptr);

}  // namespace etak
