// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/brdf/models.h"
#include "core/glsl/glsl_glue.h"

namespace etak {

/// A model as one part of a surface evaluates it.
///   part       "specular": its parameters become uniforms of names such as "specular_K"
///   values     of the model's parameters
///   opacity    factor of the diffuse colours, in which every model is linear
///   textured   true: parameters that follow the scene's textures are taken from body_here and gloss_here
///   textures   what is fetched from the textures of an atlas; null: nothing
struct ModelPart {
  std::string part;
  const Model& model;
  const std::vector<double>& values;
  double opacity = 1;
  bool textured = false;
  const TextureUse* textures = nullptr;
};

/// Declares the model's parameters as uniforms, and returns the call that evaluates the model for Angles `a`. Throws
/// Error for values that do not fit the model, and for a model with parameters that the textures cannot give.
std::string model_call(GlslGlue& glue, const ModelPart& of);

}  // namespace etak
