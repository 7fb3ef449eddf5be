// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/render/scene.h"

namespace etak {

enum class GlslVersion { core_330, es_300 };
std::string_view name(GlslVersion version);  // "330 core", "300 es"

/// Something a shader can hold. `reason`: what of it is in, or why it was left out ("K_d is 0").
struct GlslFeature {
  std::string name;
  bool in = false;
  std::string reason;
  friend bool operator==(const GlslFeature&, const GlslFeature&) = default;
};

/// A uniform and what it is to be set to: `values` holds `count` times `width` numbers.
struct GlslUniform {
  std::string name;
  int width = 1;  // 1: float, 2: vec2, 3: vec3
  int count = 1;  // above 1 or `array`: an array
  bool array = false;
  std::vector<float> values;
};

/// A shader pair for one scene. The text depends on which things the scene has, the uniforms on how much of
/// each, so that moving a slider keeps the text unless it switches something on or off.
/// Diffuse colours come times the opacity. A scene with an environment also reads the samplers and the share
/// of shaders/environment.glsl, which are the caller's to bind.
struct GlslText {
  std::string vertex, fragment;
  std::vector<GlslFeature> features;
  std::vector<GlslUniform> uniforms;
  int corners = 3;  // to draw, as a triangle fan. Above 3: around the object alone, the rest is to be cleared

  const GlslFeature* feature(std::string_view feature_name) const;
};

/// What stands in place of a scene's transfer: text of functions and samplers, which the caller binds, and
/// the name of one that takes linear sRGB (a vec3) to display code values.
struct GlslDisplay {
  std::string text, function, name;
};

/// The shaders that draw `scene` over the whole target. Throws Error for a scene without any model, and for
/// one whose values do not fit its models.
///   A scene with a view is one of a window's frames: the text then stays the same for any camera, exposure
///   and turn of the environment, and the uniform picture_origin (0, 0 if it is not set) says where in the
///   target its left lower pixel lies.
GlslText glsl_text(const Scene& scene, GlslVersion version = GlslVersion::core_330,
                   const GlslDisplay* display = nullptr);

/// What the shader of a material fetches from the two textures of an atlas; what it does not fetch comes from
/// the scene, as uniforms. Without members changed: everything, which suits any material that is opaque.
///   gloss_form   what the fetched gloss is
struct TextureUse {
  enum class Alpha { none, test, blend };
  bool diffuse = true, specular = true, gloss = true;
  bool fetch_alpha = false;  // else the scene's opacity
  Alpha alpha = Alpha::none;
  double cutoff = 0.5;      // of Alpha::test: less is not drawn
  bool scalar_f0 = false;   // F0 is grey: one channel or one number
  bool no_diffuse = false;  // black everywhere
  GlossForm gloss_form = GlossForm::schueler;
  // Where the material lies on its page: left, top, width, height as shares of it; and whether by a quarter
  // turn: column c of the picture is row c there, rows run from right to left.
  std::array<double, 4> region{0, 0, 1, 1};
  bool rotated = false;
};

/// By the defines that `etak pack` lists (core/atlas/defines.h). Throws Error for one that is not known.
TextureUse texture_use(std::span<const std::string> defines);

/// The same by a text of one define a line, "#define " before it or not.
TextureUse texture_use(std::string_view text);

/// The shaders of a scene whose material is in the textures `diffuse_alpha` and `specular_gloss`, samplers of
/// sRGB formats that are the caller's to bind. Throws Error for a model that asks for more than F0 and gloss
/// where these are fetched.
GlslText glsl_text(const Scene& scene, const TextureUse& textures,
                   GlslVersion version = GlslVersion::core_330);

/// A fragment shader that writes f_r of `model` for the directions in two float textures, one pixel each
/// (core/brdf's frame): what tests compare with C++.
GlslText glsl_evaluation_text(const Model& model, const std::vector<double>& values,
                              GlslVersion version = GlslVersion::core_330);

/// A fragment shader that writes the value of an expression in the formula texts' subset ("f0(real(1.5),
/// real(0))") to all four channels.
GlslText glsl_expression_text(std::string_view expression, GlslVersion version = GlslVersion::core_330);

}  // namespace etak
