// SPDX-License-Identifier: Apache-2.0
#include "core/glsl/glsl_surface.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/glsl/glsl_camera.h"
#include "core/glsl/glsl_lights.h"
#include "core/glsl/glsl_model.h"
#include "core/glsl/glsl_source.h"
#include "core/glsl/texture_fetch.h"
#include "core/render/environment.h"
#include "core/render/surface_textures.h"

namespace etak {

void environment_turn_of(GlslGlue& glue, const Scene& scene) {
  if (!scene.view && scene.environment_turn_deg == 0) return;
  const EnvironmentTurn turn(scene.environment_turn_deg);
  glue.uniform("environment_turn", turn.cosine(), turn.sine());
}

GlslSurface::GlslSurface(GlslGlue& glue, const Scene& scene, const TextureUse* textures)
    : glue_(glue),
      scene_(scene),
      textures_(textures),
      textured_(scene.textured().values()),
      emits_(!is_black(scene.surface.emission)),
      opacity_(textures != nullptr ? 1 : scene.surface.opacity),
      any_light_(std::ranges::any_of(scene.lights.lights, shines)) {}

void GlslSurface::write(std::string_view drawn_to) {
  declare_textures();
  if (textures_ != nullptr) declare_fetches();
  brdf();
  // A lobe that knows no tangent needs no frame.
  framed_ = any_light_ && glsl_reads_member(glue_.code() + specular_ + diffuse_, "hu2");
  light_code_ += light_loops(glue_, scene_, any_light_, framed_);
  areas();
  const SurfaceTextures::Quantities has = scene_.textured();
  const bool occluded = has.occlusion || scene_.surface.occlusion < 1;
  if (occluded) light_code_ += "  vec3 direct = sum;\n  sum = vec3(0.0);\n";
  if (scene_.lights.hemispheres || !scene_.lights.environment.empty()) make_ambient();
  hemispheres();
  environment();
  if (occluded) {
    glue_.uniform("occlusion", scene_.surface.occlusion);
    light_code_ +=
        std::string("  sum = direct + occlusion") + (has.occlusion ? " * emission_here.w" : "") + " * sum;\n";
    glue_.use("occlusion", "a factor of hemispheres and environment");
  }
  if (emits_) {
    glue_.uniform("emission", scene_.surface.emission);
    light_code_ += std::string("  sum += emission") + (has.emission ? " * emission_here.xyz" : "") + ";\n";
    glue_.use("emission", has.emission ? "a colour times the texture" : "a colour");
  }
  glue_.line(drawn_to);
  if (any_light_ && has_discrete(scene_))
    model_function("lit", specular_ + (specular_.empty() || diffuse_.empty() ? "" : " + ") + diffuse_,
                   " * a.nl");
  if (areas_ && !specular_.empty()) model_function("area_specular_model", specular_, "");
  if (areas_ && !diffuse_.empty()) model_function("area_diffuse_model", diffuse_, "");
  glue_.line("vec3 shade(vec3 p, vec3 n, vec3 v) {");
  if (any_light_ && framed_)
    glue_.line("  vec3 t = tangent_of(n);\n  vec3 b = cross(n, t);\n  vec3 local_v = in_frame(v, t, b, n);");
  glue_.line("  vec3 sum = vec3(0.0);");
  glue_.line(light_code_ + "  return sum;\n}\n");
}

bool GlslSurface::body_is_black(bool combined) const {
  return is_black(scene_.surface.diffuse) ||
         (combined
              ? etak::body_is_black(*scene_.specular, scene_.specular_values)
              : scene_.diffuse != nullptr && etak::body_is_black(*scene_.diffuse, scene_.diffuse_values));
}

// Declares the scene's textures, and the global variables that main() sets to the texels of its pixel.
void GlslSurface::declare_textures() {
  const SurfaceTextures::Quantities has = scene_.textured();
  const bool emission = has.emission && emits_;
  std::string held;
  for (const auto& [is_held, quantity] :
       {std::pair(has.diffuse, "diffuse"), std::pair(has.opacity, "opacity"), std::pair(has.f0, "F0"),
        std::pair(has.gloss, "gloss"), std::pair(emission, "emission"), std::pair(has.occlusion, "occlusion"),
        std::pair(has.normal, "normal")})
    if (is_held) held += (held.empty() ? "" : ", ") + std::string(quantity);
  if (held.empty()) {
    if (scene_.view) glue_.leave_out("textures", "the surface is the same everywhere");
    return;
  }
  const SurfaceValues& surface = scene_.surface;
  if (textured_) {
    texel_of("body", has.diffuse, surface.diffuse, has.opacity, surface.opacity);
    texel_of("gloss", has.f0, surface.f0, has.gloss, surface.gloss);
  }
  if (emission || has.occlusion) texel_of("emission", true, {}, true, 0);
  if (has.normal && !scene_.mesh) {
    glue_.declare("sampler2D", "surface_normal");
    texels_ += "    n = bent_normal(n, v, texture(surface_normal, texel_at).xyz);\n";
  }
  glue_.use("textures", held);
}

// Declares the texture `name` and the variable of its texel. What the texture does not hold is a uniform.
void GlslSurface::texel_of(const std::string& name, bool holds_color, const Vec3& color, bool holds_number,
                           double number) {
  const std::string here = "    " + name + "_here";
  glue_.line("vec4 " + name + "_here;\n");
  if (holds_color || holds_number) {
    glue_.declare("sampler2D", "surface_" + name);
    texels_ += here + " = texture(surface_" + name + ", texel_at);\n";
  }
  if (!holds_color) {
    glue_.uniform(name + "_color", color);
    texels_ += here + ".xyz = " + name + "_color;\n";
  }
  if (!holds_number) {
    glue_.uniform(name + "_number", number);
    texels_ += here + ".w = " + name + "_number;\n";
  }
}

void GlslSurface::brdf() {
  const Model* specular = scene_.specular;
  const Model* diffuse = scene_.diffuse;
  if (specular == nullptr && diffuse == nullptr)
    throw Error::at("scene", "no model", "a specular or a diffuse one");
  const bool combined = specular != nullptr && specular->kind == ModelKind::combined;
  const bool fetched = textures_ != nullptr && textures_->diffuse;
  const bool black = !textured_ && !fetched && body_is_black(combined);
  has_diffuse_ = !black && (combined || diffuse != nullptr);
  if (!any_light_) {
    // Hemispheres and environment have formulas of their own and do not evaluate the models.
    glue_.leave_out("specular", "no discrete light");
    glue_.leave_out("diffuse", "no discrete light");
    return;
  }
  if (specular != nullptr) {
    specular_ =
        model_call(glue_, {"specular", *specular, scene_.specular_values, opacity_, textured_, textures_});
    glue_.use("specular", std::string(specular->id));
  } else {
    glue_.leave_out("specular", "no specular model");
  }
  if (combined) {
    glue_.use("diffuse", "part of " + std::string(specular->id));
  } else if (has_diffuse_) {
    diffuse_ =
        model_call(glue_, {"diffuse", *diffuse, scene_.diffuse_values, opacity_, textured_, textures_});
    glue_.use("diffuse", std::string(diffuse->id));
  } else {
    glue_.leave_out("diffuse", diffuse == nullptr ? "no diffuse model" : "K_d is 0");
  }
  any_light_ = !specular_.empty() || !diffuse_.empty();
}

// Writes a function that evaluates models for a direction of light.
void GlslSurface::model_function(const std::string& name, const std::string& models,
                                 const std::string& times) {
  glue_.line("vec3 " + name +
             (framed_ ? "(vec3 l, vec3 v) {\n  Angles a = angles(l, v);"
                      : "(vec3 n, vec3 l, vec3 v) {\n  Angles a = angles_about(n, l, v);") +
             std::string("\n  if (a.valid <= 0.0) return vec3(0.0);"));
  glue_.line("  return (" + models + ")" + times + ";\n}\n");
}

void GlslSurface::areas() {
  areas_ = any_light_ && has_areas(scene_);
  if (!areas_) return;
  std::optional<AreaTable> lobes;
  const bool fetched = textures_ != nullptr && textures_->gloss;
  if (!specular_.empty())
    lobes = area_table(*scene_.specular, seen_specular_values(scene_),
                       fetched || (textured_ && width_follows_texture(*scene_.specular)));
  light_code_ += area_loops(glue_, scene_, lobes ? &*lobes : nullptr, !diffuse_.empty(),
                            fetched ? "texel_gloss" : "gloss_here.w", framed_);
}

void GlslSurface::hemispheres() {
  const auto& sky = scene_.lights.hemispheres;
  const bool dark = !sky || (is_black(sky->upper) && is_black(sky->lower));
  const std::string reason = !sky ? "none in the setup" : "both are black";
  const bool diffuse = !dark && has_diffuse_;
  const bool specular = !dark && scene_.specular != nullptr;
  if (diffuse || specular) {
    glue_.uniform("sky_upper", sky->upper);
    glue_.uniform("sky_lower", sky->lower);
    glue_.uniform("sky_axis", sky->axis);
  }
  if (diffuse) {
    body_uniform();
    light_code_ +=
        ambient_->diffuse("hemisphere_diffuse(" + body_color() + ", sky_lower, sky_upper, dot(n, sky_axis))");
    glue_.use("diffuse hemispheres", "K_d is not 0");
  } else {
    glue_.leave_out("diffuse hemispheres", dark ? reason : no_body());
  }
  if (!specular) return glue_.leave_out("specular hemispheres", dark ? reason : "no specular model");
  light_code_ += ambient_->hemispheres();
  glue_.use("specular hemispheres", std::string(name(hemisphere_form(scene_))));
}

void GlslSurface::environment() {
  if (scene_.lights.environment.empty()) return glue_.leave_out("environment", "none in the setup");
  std::string parts;
  const auto to_map = [this](const std::string& d) { return in_environment_map(scene_, d); };
  const bool looked_at =
      has_diffuse_ || scene_.specular != nullptr || scene_.backdrop.environment || is_clear_ball(scene_);
  if (looked_at) environment_turn_of(glue_, scene_);
  if (has_diffuse_) {
    body_uniform();
    light_code_ += ambient_->diffuse(body_color() + " * environment_diffuse(" + to_map("n") + ")");
    parts = "diffuse";
  }
  if (scene_.specular != nullptr) {
    light_code_ += ambient_->environment(to_map);
    parts += parts.empty() ? "specular" : " and specular";
  }
  if (parts.empty()) return glue_.leave_out("environment", "neither a diffuse nor a specular part");
  glue_.use("environment", parts);
}

std::string GlslSurface::no_body() const {
  return is_black(scene_.surface.diffuse) ? "K_d is 0" : "no diffuse model";
}

void GlslSurface::body_uniform() {
  if (textured_) return;
  if (textures_ != nullptr && textures_->diffuse)
    body_ = "texel_diffuse";
  else if (textures_ != nullptr && textures_->alpha == TextureUse::Alpha::blend)
    body_ = "(body_K * texel_opacity)";
  if (body_ != "texel_diffuse" && !std::exchange(body_declared_, true))
    glue_.uniform("body_K", scaled(scene_.surface.diffuse, opacity_));
}

// The parts that add light from all around.
void GlslSurface::make_ambient() {
  const Textured varies =
      textures_ != nullptr ? Textured{textures_->specular, textures_->gloss} : held_by_textures(scene_);
  const auto value = [&](bool of_atlas, const char* texel, const char* here) {
    return textured_ ? std::string(here) : of_atlas ? std::string(texel) : std::string();
  };
  ambient_.emplace(glue_, scene_, varies, value(varies.f0, "texel_f0", "gloss_here.xyz"),
                   value(varies.gloss, "texel_gloss", "gloss_here.w"));
}

void GlslSurface::declare_fetches() {
  TextureFetch fetch = texture_fetch(*textures_, scene_.surface.opacity);
  fetching_ = fetch.any;
  glue_.line(fetch.code);
  for (GlslUniform& uniform : fetch.uniforms) glue_.add(std::move(uniform));
  for (GlslFeature& feature : fetch.features) glue_.text.features.push_back(std::move(feature));
}

}  // namespace etak
