// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/render/scene.h"

namespace etak {

/// vulkan_450 has bindings and locations, so that compilers to SPIR-V take it for Vulkan and for OpenGL: its uniforms
/// are the block of binding 0 in the layout std140, its samplers have the bindings from 1 on.
enum class GlslVersion { core_330, es_300, vulkan_450 };
std::string_view name(GlslVersion version);  // "330 core", "300 es", "450"

/// A part that a shader can have.
///   in       whether the shader has it
///   reason   which form of it is in, or why it was left out ("K_d is 0")
struct GlslFeature {
  std::string name;
  bool in = false;
  std::string reason;
  friend bool operator==(const GlslFeature&, const GlslFeature&) = default;
};

/// A uniform and its value; `values` has `count` times `width` numbers.
struct GlslUniform {
  std::string name;
  int width = 1;  // 1: float, 2: vec2, 3: vec3
  int count = 1;  // how many elements the array has; 1 where it is none
  bool array = false;
  std::vector<float> values;
};

/// The two shaders of one scene. The text depends on which parts the scene has, and the uniforms on their
/// values, so that moving a slider does not change the text unless it switches a part on or off. Diffuse
/// colours are multiplied by the opacity. For a scene with an environment, the caller also binds the samplers
/// of shaders/environment.glsl (Environment::level_stack() and its other maps).
struct GlslText {
  std::string vertex, fragment;
  std::vector<GlslFeature> features;
  std::vector<GlslUniform> uniforms;
  // How many corners to draw. 3 are a triangle that covers the whole target; a larger number is a fan around the
  // object alone, and the caller must clear the rest; those of a ring are a strip around the object.
  int corners = 3;
  bool ring = false;

  const GlslFeature* feature(std::string_view feature_name) const;
};

struct TextureUse;

/// A display transform in place of a scene's transfer curve.
///   text       functions and samplers; the caller binds the samplers
///   function   the one of them that converts linear sRGB (a vec3) to display values
///   name       of the transform, for GlslFeature::reason
struct GlslDisplay {
  std::string text, function, name;
};

/// The shaders that draw `scene` over the whole target. Throws Error for a scene without a model, and for one
/// whose values do not fit its models.
///
/// A scene with a view is a frame of a window: its text stays the same for any camera, exposure and turn of
/// the environment, and the uniform picture_origin (0, 0 if it is not set) is the place of its bottom left
/// pixel in the target.
GlslText glsl_text(const Scene& scene, GlslVersion version = GlslVersion::core_330,
                   const GlslDisplay* display = nullptr);

/// The shaders that draw a mesh of the caller's with the scene's surface and light, without background and camera.
///   vertex     attributes position, normal, texel (locations 0 to 2); uniforms model_matrix and its inverse transpose
///              normal_matrix, view_projection
///   fragment   uniform viewer, the place of the camera in the scene; writes colour times alpha, and alpha
/// Lights that have a place, and the axis of hemispheres, are in the coordinates into which model_matrix leads.
GlslText glsl_mesh_text(const Scene& scene, const TextureUse* textures = nullptr,
                        GlslVersion version = GlslVersion::core_330);

/// The shaders of glsl_text() in two parts, for a software rasteriser, for which code costs time in pixels too where its result is
/// not used: the object with its edge, and the backdrop beside it, which must be drawn first.
///   beside   none where the caller can clear the target, or where the object may be anywhere
struct GlslParts {
  GlslText object;
  std::optional<GlslText> beside;
};
GlslParts glsl_parts(const Scene& scene, const GlslDisplay* display = nullptr);

/// Which values the shader of a material fetches from the two textures of an atlas; the others are uniforms
/// with the values of the scene. By default it fetches all but alpha, which fits every opaque material.
///   gloss_form   the quantity that the gloss channel holds
struct TextureUse {
  /// What is done with the alpha that is fetched.
  enum class Alpha { none, test, blend };
  bool diffuse = true, specular = true, gloss = true;
  bool fetch_alpha = false;  // false: the scene's opacity
  Alpha alpha = Alpha::none;
  double cutoff = 0.5;      // of Alpha::test: texels with a smaller alpha are not drawn
  bool scalar_f0 = false;   // F0 is grey: it is one channel or one number
  bool no_diffuse = false;  // diffuse is black everywhere
  GlossForm gloss_form = GlossForm::schueler;
  /// Which channels of the second texture hold F0 and gloss: RGB and alpha; or, of a format without sRGB, gloss alone in
  /// red; or a grey F0 in red, sRGB-encoded, with gloss in green.
  enum class Channels { rgb_alpha, gloss_alone, f0_gloss };
  Channels channels = Channels::rgb_alpha;
  /// Opacity or gloss is red of a texture of its own, the sampler `alpha_apart` or `gloss_apart`, of no sRGB format.
  bool alpha_apart = false, gloss_apart = false;
  /// The texture ends before its small levels, which are those of a texture of their own, the sampler `diffuse_alpha_tail` or
  /// `specular_gloss_tail`.
  bool diffuse_tail = false, specular_tail = false;
  /// Where a part of the material lies on its page.
  ///   region    left, top, width and height as shares of the page; of no width and height: one point
  ///   rotated   a quarter turn: column c of the picture is row c on the page, and the picture's rows run from
  ///             right to left
  struct Place {
    std::array<double, 4> region{0, 0, 1, 1};
    bool rotated = false;
    friend bool operator==(const Place&, const Place&) = default;
  };
  std::array<Place, 4> places;  // of diffuse, alpha, F0 and gloss
};

/// The use that the defines of `etak pack` state (core/atlas/defines.h). Throws Error for unknown defines.
TextureUse texture_use(std::span<const std::string> defines);

/// The use that a text with one define on each line states, with or without "#define " in front.
TextureUse texture_use(std::string_view text);

/// The shaders of a scene whose material is in the textures `diffuse_alpha` and `specular_gloss`, samplers of
/// sRGB formats that the caller binds. Throws Error for a model that needs more than F0 and gloss where these
/// are fetched.
GlslText glsl_text(const Scene& scene, const TextureUse& textures,
                   GlslVersion version = GlslVersion::core_330);

/// A fragment shader that writes f_r of `model` for the directions in two float textures, in the frame of
/// core/brdf: one pixel for each pair. Tests compare its results with those of C++.
GlslText glsl_evaluation_text(const Model& model, const std::vector<double>& values,
                              GlslVersion version = GlslVersion::core_330);

/// A fragment shader that writes the value of an expression to all four channels. The expression is in the
/// language of the formula texts: "f0(real(1.5), real(0))".
GlslText glsl_expression_text(std::string_view expression, GlslVersion version = GlslVersion::core_330);

}  // namespace etak
