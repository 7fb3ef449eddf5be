// SPDX-License-Identifier: Apache-2.0
// The part of a shader that evaluates a model: its parameters, which are uniforms or texels, and the call.
#include "core/glsl/glsl_model.h"

#include "core/base/error.h"
#include "core/glsl/glsl_source.h"
#include "core/render/surface_textures.h"

namespace etak {
namespace {

// The GLSL expression for a parameter that follows the texture; the same value as that of TexturedValues.
std::string from_texture(const Parameter& parameter) {
  const auto held = [&](const std::string& value) {
    return "clamp(" + value + ", " + glsl_decimal(parameter.min) + ", " + glsl_decimal(parameter.max) + ")";
  };
  const std::string channels = parameter.color ? ".xyz" : ".x";
  switch (parameter.role) {
    case Role::diffuse:
      return "(body_here" + channels + " * body_here.w)";
    case Role::f0:
      return "gloss_here" + channels;
    case Role::gloss:
      return held("gloss_here.w");
    case Role::alpha:
      return held("exponent_alpha(gloss_exponent(gloss_here.w))");
    default:
      return held("gloss_exponent(gloss_here.w)");
  }
}

// The GLSL expression for a parameter whose value a texture of an atlas holds; empty for one that is a
// uniform.
std::string fetched_value(const Model& model, const Parameter& parameter, const TextureUse& textures) {
  switch (parameter.role) {
    case Role::diffuse:
      return textures.diffuse ? "texel_diffuse" : "";
    case Role::f0:
      return textures.specular ? "texel_f0" : "";
    case Role::f82:
    case Role::n:
    case Role::k:
    case Role::curve:
      if (textures.specular)
        throw Error::at(std::string(model.id),
                        "needs " + std::string(parameter.name) + ", which no texture holds",
                        "a model of F0 and gloss, such as schueler-optimized or ggx-schlick");
      return "";
    case Role::gloss:
      return textures.gloss ? "texel_gloss" : "";
    case Role::alpha:
      return textures.gloss ? "exponent_alpha(gloss_exponent(texel_gloss))" : "";
    case Role::exponent:
      return textures.gloss ? "gloss_exponent(texel_gloss)" : "";
    case Role::other:
      break;
  }
  return "";
}

}  // namespace

std::string model_call(GlslGlue& glue, const ModelPart& of) {
  const auto& [part, model, values, opacity, textured, textures] = of;
  if (values.size() != model.value_count())
    throw Error::at(model.id, std::to_string(values.size()) + " values",
                    std::to_string(model.value_count()) + " for its parameters");
  std::string call = std::string(model.entry) + "(a";
  std::size_t at = 0;
  for (const Parameter& parameter : model.parameters) {
    if (const std::string fetched = textures == nullptr ? "" : fetched_value(model, parameter, *textures);
        !fetched.empty()) {
      at += parameter.color ? 3 : 1;
      call += ", " + fetched;
      continue;
    }
    const std::string uniform = part + '_' + std::string(parameter.name);
    if (textures != nullptr && textures->scalar_f0 && parameter.color && parameter.role == Role::f0) {
      glue.uniform(uniform, values[at]);
      at += 3;
      call += ", vec3(" + uniform + ")";
      continue;
    }
    const double scale = parameter.role == Role::diffuse ? opacity : 1;
    if (textured && follows_texture(model, parameter)) {
      at += parameter.color ? 3 : 1;
      call += ", " + from_texture(parameter);
      continue;
    }
    if (parameter.color)
      glue.uniform(uniform, Vec3{values[at] * scale, values[at + 1] * scale, values[at + 2] * scale});
    else
      glue.uniform(uniform, values[at] * scale);
    at += parameter.color ? 3 : 1;
    call += ", " + uniform;
    if (parameter.role == Role::diffuse && textures != nullptr && textures->alpha == TextureUse::Alpha::blend)
      call += " * texel_opacity";
  }
  if (textures != nullptr && textures->gloss && model.derives_from_width())
    throw Error::at(std::string(model.id), "has numbers that are computed from gloss beforehand",
                    "a model that can take gloss from a texture, such as schueler-optimized or ggx-schlick");
  std::vector<double> derived(model.derived_count());
  model.derive(values.data(), derived.data());
  at = 0;
  for (const Parameter& each : model.derived) {
    const std::string uniform = part + '_' + std::string(each.name);
    if (each.color)
      glue.uniform(uniform, Vec3{derived[at], derived[at + 1], derived[at + 2]});
    else
      glue.uniform(uniform, derived[at]);
    at += each.color ? 3 : 1;
    call += ", " + uniform;
  }
  if (!model.text.empty()) glue.line(real_literals(model.text));
  return call + ')';
}

}  // namespace etak
