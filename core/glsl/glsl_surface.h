// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/glsl/glsl_ambient.h"
#include "core/glsl/glsl_glue.h"
#include "core/render/scene.h"

namespace etak {

struct TextureUse;

/// Declares how the environment is turned, where it is or can be.
void environment_turn_of(GlslGlue& glue, const Scene& scene);

/// Writes what a scene's surface sends to the viewer: the function `vec3 shade(vec3 p, vec3 n, vec3 v)` for a place,
/// its normal and the direction to the viewer, with all that it calls.
class GlslSurface {
 public:
  /// All three must outlive the object.
  ///   textures   what is fetched from an atlas; null: nothing
  GlslSurface(GlslGlue& glue, const Scene& scene, const TextureUse* textures);

  /// Writes shade() and before it the line that declares what the shader draws to.
  void write(std::string_view drawn_to);

  /// The code that sets the variables of the scene's textures for the place `texel_at`; empty: it has none.
  const std::string& texels() const { return texels_; }
  /// Whether the function `fetch(vec2)` must be called before shade(), because a texture of an atlas is read.
  bool fetches() const { return fetching_; }
  /// Whether textures of the scene hold F0, gloss, K_d or opacity.
  bool is_textured() const { return textured_; }
  /// The opacity that is the same everywhere; 1 where an atlas may hold it.
  double opacity() const { return opacity_; }
  /// K_d at this place, times the opacity.
  std::string body_color() const { return textured_ ? "(body_here.xyz * body_here.w)" : body_; }

 private:
  bool body_is_black(bool combined) const;
  void declare_textures();
  void texel_of(const std::string& name, bool holds_color, const Vec3& color, bool holds_number,
                double number);
  void brdf();
  void model_function(const std::string& name, const std::string& models, const std::string& times);
  void areas();
  void hemispheres();
  void environment();
  std::string no_body() const;
  void body_uniform();
  void make_ambient();
  void declare_fetches();

  GlslGlue& glue_;
  const Scene& scene_;
  const TextureUse* textures_;
  const bool textured_, emits_;
  const double opacity_;
  std::string specular_, diffuse_, light_code_;  // the calls of the models, and the sum over the lights
  std::string texels_;
  std::string body_ = "body_K";
  std::optional<GlslAmbient> ambient_;  // where the scene has hemispheres or an environment
  bool any_light_;                      // whether a discrete light lights a model
  bool areas_ = false;                  // whether an area light does
  bool framed_ = false;                 // whether the models read where the tangent lies
  bool fetching_ = false;
  bool has_diffuse_ = false, body_declared_ = false;
};

}  // namespace etak
