// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/brdf/models.h"
#include "core/render/glsl/glsl_glue.h"

namespace etak {

/// Declares the model's parameters as uniforms, such as "specular_K" for the part "specular", and returns the
/// call that evaluates the model for Angles `a`. Throws Error for values that do not fit the model, and for a
/// model with parameters that the textures cannot give.
///   opacity    factor of the diffuse colours, in which every model is linear
///   textured   true: parameters that follow the scene's textures are taken from body_here and gloss_here
///   textures   what is fetched from the textures of an atlas; null: nothing
std::string model_call(GlslGlue& glue, const std::string& part, const Model& model,
                       const std::vector<double>& values, double opacity, bool textured = false,
                       const TextureUse* textures = nullptr);

}  // namespace etak
