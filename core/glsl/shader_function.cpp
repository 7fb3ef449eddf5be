// SPDX-License-Identifier: Apache-2.0
// A scene's BRDF as one function, and its text in HLSL and MSL, which differ from GLSL in words alone.
#include "core/glsl/shader_function.h"

#include <map>
#include <utility>

#include "core/base/error.h"
#include "core/glsl/glsl_glue.h"
#include "core/glsl/glsl_model.h"
#include "core/glsl/glsl_tokens.h"

namespace etak {
namespace {

constexpr std::string_view language_names[] = {"glsl", "hlsl", "msl", "wgsl"};

using Words = std::map<std::string_view, std::string_view>;

// Whether the arguments that follow, from their opening bracket on, are one alone.
bool is_one_argument(std::string_view rest) {
  int depth = 0;
  for (const char c : rest) {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (c == ',' && depth == 1) return false;
    if (depth == 0) break;
  }
  return true;
}

// `text` with other words. `constant` is what stands for `const` outside of functions.
//   splat   what stands for vec3 where it has one argument
std::string with_words(std::string_view text, const Words& words, std::string_view constant,
                       std::string_view splat) {
  std::string out;
  int depth = 0;
  for_each_token(text, [&](std::string_view token, std::string_view rest) {
    depth += token == "{" ? 1 : token == "}" ? -1 : 0;
    const auto found = words.find(token);
    if (token == "const" && depth == 0)
      out += constant;
    else if (token == "vec3" && rest.starts_with('(') && is_one_argument(rest))
      out += splat;
    else
      out += found == words.end() ? token : found->second;
  });
  return out;
}

//   models   ids of the models whose sum it is
std::string head(const std::string& models, ShaderLanguage language) {
  return "// etak_brdf(l, v): f_r in 1/sr of " + models + ", for linear red, green and blue.\n" +
         "// l, v: unit vectors to the light and to the viewer in the surface's frame, normal +z, tangent +x.\n" +
         "// What a light of irradiance E sends to the viewer is etak_brdf(l, v) * E * l.z.\n" +
         (language == ShaderLanguage::msl ? "// No Metal compiler has seen this text: it is tested as C++.\n"
                                          : "");
}

}  // namespace

std::span<const std::string_view> shader_language_names() {
  return language_names;
}

std::string_view name(ShaderLanguage language) {
  return language_names[static_cast<std::size_t>(language)];
}

std::string shader_function(const Scene& scene, ShaderLanguage language) {
  if (scene.specular == nullptr && scene.diffuse == nullptr)
    throw Error::at("scene", "no model", "a specular or a diffuse one");
  GlslGlue glue;
  std::string sum, models;
  const auto add = [&](const std::string& part, const Model& model, const std::vector<double>& values) {
    if (!sum.empty()) sum += " + ", models += " and ";
    sum += model_call(glue, {part, model, values, scene.surface.opacity});
    models += model.id;
  };
  if (scene.specular != nullptr) add("specular", *scene.specular, scene.specular_values);
  const bool apart = scene.specular == nullptr || scene.specular->kind != ModelKind::combined;
  if (scene.diffuse != nullptr && apart &&
      (sum.empty() || !body_is_black(*scene.diffuse, scene.diffuse_values)))
    add("diffuse", *scene.diffuse, scene.diffuse_values);
  glue.line("vec3 etak_brdf(vec3 l, vec3 v) {\n  Angles a = angles(l, v);\n  vec3 value = " + sum + ";");
  glue.line("  return a.valid > 0.0 ? value : vec3(0.0);\n}");
  const std::string text = std::move(glue).function();
  switch (language) {
    case ShaderLanguage::glsl:
      return head(models, language) + "#define real float\n\n" + text;
    case ShaderLanguage::hlsl:
      return head(models, language) + '\n' + to_hlsl(text);
    case ShaderLanguage::msl:
      return head(models, language) + '\n' + to_msl(text);
    case ShaderLanguage::wgsl:
      break;
  }
  return head(models, language) + '\n' + to_wgsl(text);
}

std::string to_hlsl(std::string_view text) {
  static const Words words{
      {"real", "float"}, {"vec2", "float2"}, {"vec3", "float3"}, {"mix", "lerp"}, {"inversesqrt", "rsqrt"}};
  return with_words(text, words, "static const", "(float3)");
}

std::string to_msl(std::string_view text) {
  static const Words words{
      {"real", "float"}, {"vec2", "float2"}, {"vec3", "float3"}, {"inversesqrt", "rsqrt"}};
  return "#include <metal_stdlib>\nusing namespace metal;\n\n" +
         with_words(text, words, "constant", "float3");
}

}  // namespace etak
