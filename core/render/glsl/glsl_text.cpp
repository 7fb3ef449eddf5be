// SPDX-License-Identifier: Apache-2.0
#include "core/render/glsl/glsl_text.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/color/luminance.h"
#include "core/render/ambient/round_lobe.h"
#include "core/render/camera.h"
#include "core/render/environment.h"
#include "core/render/glsl/glsl_ambient.h"
#include "core/render/glsl/glsl_camera.h"
#include "core/render/glsl/glsl_glue.h"
#include "core/render/glsl/glsl_lights.h"
#include "core/render/glsl/glsl_model.h"
#include "core/render/glsl/glsl_source.h"
#include "core/render/glsl/glsl_transfer.h"
#include "core/render/glsl/texture_fetch.h"
#include "core/render/surface_textures.h"

namespace etak {
namespace {

// Writes the shaders of one scene, part by part.
class SceneText {
 public:
  SceneText(const Scene& scene, const GlslDisplay* display, const TextureUse* textures,
            bool backdrop_apart = false)
      : scene_(scene),
        display_(display),
        backdrop_apart_(backdrop_apart),
        textures_(textures),
        camera_(scene),
        textured_(scene.textured().values()),
        emits_(!is_black(scene.surface.emission)),
        opacity_(textures != nullptr ? 1 : scene.surface.opacity),
        any_light_(std::ranges::any_of(scene.lights.lights, shines)) {}

  // The scene's surface on a mesh of the caller's.
  GlslText mesh(GlslVersion version) {
    mesh_ = true;
    GlslText text = finish(version);
    text.corners = 0;
    return text;
  }

  GlslText finish(GlslVersion version) {
    if (display_ != nullptr) glue_.line(display_->text);
    textures();
    if (textures_ != nullptr) fetches();
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
      light_code_ += std::string("  sum = direct + occlusion") + (has.occlusion ? " * emission_here.w" : "") +
                     " * sum;\n";
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
      glue_.line(
          "  vec3 t = tangent_of(n);\n  vec3 b = cross(n, t);\n  vec3 local_v = in_frame(v, t, b, n);");
    glue_.line("  vec3 sum = vec3(0.0);");
    glue_.line(light_code_ + "  return sum;\n}\n");
    if (mesh_)
      on_mesh();
    else
      picture();
    return std::move(glue_).finish(version);
  }

  // The backdrop beside the object, alone.
  GlslText beside(GlslVersion version) {
    if (display_ != nullptr) glue_.line(display_->text);
    environment_turn();
    glue_.line(drawn_to);
    glue_.uniform("background", scene_.background);
    beside_text(glue_, scene_, camera_);
    transfer_text(glue_, scene_, display_);
    glue_.line("  pixel_color = vec4(color, 0.0);\n}");
    return std::move(glue_).finish(version);
  }

 private:
  static constexpr const char* drawn_to = "layout(location = 0) out vec4 pixel_color;\n";

  bool body_is_black(bool combined) const {
    return is_black(scene_.surface.diffuse) ||
           (combined
                ? etak::body_is_black(*scene_.specular, scene_.specular_values)
                : scene_.diffuse != nullptr && etak::body_is_black(*scene_.diffuse, scene_.diffuse_values));
  }

  // Declares the scene's textures, and the global variables that main() sets to the texels of its pixel.
  void textures() {
    const SurfaceTextures::Quantities has = scene_.textured();
    const bool emission = has.emission && emits_;
    std::string held;
    for (const auto& [is_held, quantity] :
         {std::pair(has.diffuse, "diffuse"), std::pair(has.opacity, "opacity"), std::pair(has.f0, "F0"),
          std::pair(has.gloss, "gloss"), std::pair(emission, "emission"),
          std::pair(has.occlusion, "occlusion")})
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
    glue_.use("textures", held);
  }

  // Declares the texture `name` and the variable of its texel. What the texture does not hold is a uniform.
  void texel_of(const std::string& name, bool holds_color, const Vec3& color, bool holds_number,
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

  void brdf() {
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
          model_call(glue_, "specular", *specular, scene_.specular_values, opacity_, textured_, textures_);
      glue_.use("specular", std::string(specular->id));
    } else {
      glue_.leave_out("specular", "no specular model");
    }
    if (combined) {
      glue_.use("diffuse", "part of " + std::string(specular->id));
    } else if (has_diffuse_) {
      diffuse_ =
          model_call(glue_, "diffuse", *diffuse, scene_.diffuse_values, opacity_, textured_, textures_);
      glue_.use("diffuse", std::string(diffuse->id));
    } else {
      glue_.leave_out("diffuse", diffuse == nullptr ? "no diffuse model" : "K_d is 0");
    }
    any_light_ = !specular_.empty() || !diffuse_.empty();
  }

  // Writes a function that evaluates models for a direction of light.
  void model_function(const std::string& name, const std::string& models, const std::string& times) {
    glue_.line("vec3 " + name +
               (framed_ ? "(vec3 l, vec3 v) {\n  Angles a = angles(l, v);"
                        : "(vec3 n, vec3 l, vec3 v) {\n  Angles a = angles_about(n, l, v);") +
               std::string("\n  if (a.valid <= 0.0) return vec3(0.0);"));
    glue_.line("  return (" + models + ")" + times + ";\n}\n");
  }

  void areas() {
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

  void hemispheres() {
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
      light_code_ += ambient_->diffuse("hemisphere_diffuse(" + body_color() +
                                       ", sky_lower, sky_upper, dot(n, sky_axis))");
      glue_.use("diffuse hemispheres", "K_d is not 0");
    } else {
      glue_.leave_out("diffuse hemispheres", dark ? reason : no_body());
    }
    if (!specular) return glue_.leave_out("specular hemispheres", dark ? reason : "no specular model");
    light_code_ += ambient_->hemispheres();
    glue_.use("specular hemispheres", std::string(name(hemisphere_form(scene_))));
  }

  void environment() {
    if (scene_.lights.environment.empty()) return glue_.leave_out("environment", "none in the setup");
    std::string parts;
    const auto to_map = [this](const std::string& d) { return in_environment_map(scene_, d); };
    const bool looked_at =
        has_diffuse_ || scene_.specular != nullptr || scene_.backdrop.environment || is_clear_ball(scene_);
    if (looked_at) environment_turn();
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

  void environment_turn() {
    if (!scene_.view && scene_.environment_turn_deg == 0) return;
    const EnvironmentTurn turn(scene_.environment_turn_deg);
    glue_.uniform("environment_turn", turn.cosine(), turn.sine());
  }

  std::string no_body() const { return is_black(scene_.surface.diffuse) ? "K_d is 0" : "no diffuse model"; }

  std::string body_color() const { return textured_ ? "(body_here.xyz * body_here.w)" : body_; }

  void body_uniform() {
    if (textured_) return;
    if (textures_ != nullptr && textures_->diffuse)
      body_ = "texel_diffuse";
    else if (textures_ != nullptr && textures_->alpha == TextureUse::Alpha::blend)
      body_ = "(body_K * texel_opacity)";
    if (body_ != "texel_diffuse" && !std::exchange(body_declared_, true))
      glue_.uniform("body_K", scaled(scene_.surface.diffuse, opacity_));
  }

  // The parts that add light from all around.
  void make_ambient() {
    const Textured varies =
        textures_ != nullptr ? Textured{textures_->specular, textures_->gloss} : held_by_textures(scene_);
    const auto value = [&](bool of_atlas, const char* texel, const char* here) {
      return textured_ ? std::string(here) : of_atlas ? std::string(texel) : std::string();
    };
    ambient_.emplace(glue_, scene_, varies, value(varies.f0, "texel_f0", "gloss_here.xyz"),
                     value(varies.gloss, "texel_gloss", "gloss_here.w"));
  }

  void picture() {
    glue_.uniform("picture_size", scene_.width, scene_.height);
    glue_.uniform("background", scene_.background);
    if (scene_.perspective) {
      glue_.uniform("camera_distance", camera_.distance());
      glue_.uniform("camera_spread", camera_.spread());
    }
    const bool sphere = scene_.shape == Shape::sphere;
    glue_.use("shape", sphere ? "sphere" : "quad");
    glue_.use("camera", scene_.perspective ? "perspective" : "orthographic");
    camera_text(glue_, scene_, camera_, backdrop_apart_);
    if (!texels_.empty()) {
      glue_.line(sphere ? "    vec2 texel_at = sphere_texel(p);" : "    vec2 texel_at = square_texel(p);");
      glue_.line(texels_);
    }
    if (fetching_) glue_.line("    fetch(p.xy);");
    glue_.line("    vec3 object = shade(p, n, v);");
    transparency();
    marks_text(glue_, scene_, body_color());
    glue_.line("    color = mix(" + backdrop_name(scene_) + ", object, coverage);\n  }");
    transfer_text(glue_, scene_, display_);
    glue_.line("  pixel_color = vec4(color, coverage);\n}");
  }

  // Writes main() for a mesh: the vertex shader gives position, normal and texel.
  void on_mesh() {
    glue_.text.vertex = std::string(glsl_file("shaders/mesh.vert"));
    glue_.uniform("viewer", Vec3{0, 0, 1});
    glue_.use("shape", "a mesh of the caller's");
    glue_.line("in vec3 mesh_position;\nin vec3 mesh_normal;\nin vec2 mesh_texel;\n\nvoid main() {");
    glue_.line(
        "  vec3 p = mesh_position;\n  vec3 n = normalize(mesh_normal);\n  vec3 v = normalize(viewer - p);");
    if (!texels_.empty()) glue_.line("    vec2 texel_at = mesh_texel;\n" + texels_);
    if (fetching_) glue_.line("  fetch(mesh_texel * vec2(2.0, -2.0) + vec2(-1.0, 1.0));");
    glue_.line("  vec3 color = shade(p, n, v);");
    const std::string alpha = mesh_alpha();
    transfer_text(glue_, scene_, display_);
    glue_.line("  pixel_color = vec4(color, " + alpha + ");\n}");
  }

  std::string mesh_alpha() {
    if (textures_ != nullptr && textures_->alpha == TextureUse::Alpha::blend) {
      glue_.use("transparency", "alpha blends");
      return "fresnel_opacity(texel_opacity, " + f0_luminance() + ", clamp(dot(n, v), 0.0, 1.0))";
    }
    if (opacity_ >= 1) {
      glue_.leave_out("transparency", "opacity is 1");
      return "1.0";
    }
    glue_.uniform("opacity", opacity_);
    glue_.use("transparency", "opacity below 1");
    return "fresnel_opacity(opacity, " + f0_luminance() + ", clamp(dot(n, v), 0.0, 1.0))";
  }

  // The luminance of F0, of the texel where the textures hold F0.
  std::string f0_luminance() {
    if (textures_ != nullptr && textures_->specular) return "luminance_of(texel_f0)";
    glue_.uniform("f0_luminance", luminance_of(scene_.surface.f0));
    return "f0_luminance";
  }

  void fetches() {
    TextureFetch fetch = texture_fetch(*textures_, scene_.surface.opacity);
    fetching_ = fetch.any;
    glue_.line(fetch.code);
    for (GlslUniform& uniform : fetch.uniforms) glue_.add(std::move(uniform));
    for (GlslFeature& feature : fetch.features) glue_.text.features.push_back(std::move(feature));
  }

  // The environment through a clear ball. An atlas has no clear bodies.
  void clear_ball() {
    glue_.uniform("opacity", opacity_);
    glue_.uniform("ball_n", scene_.surface.n[1]);
    glue_.uniform("ball_level", level_of_gloss(scene_.surface.gloss));
    glue_.uniform("ball_passing", *scene_.surface.passing);
    glue_.line(
        "    object += (1.0 - opacity) * through_ball(clamp(dot(n, v), 0.0, 1.0), ball_n, ball_passing) *");
    glue_.line("              environment_specular(" +
               in_environment_map(scene_, "beyond_ball(n, v, ball_n)") + ", ball_level);");
    glue_.use("transparency", "a clear ball bends the environment");
  }

  void transparency() {
    const std::string behind = " * " + backdrop_name(scene_) + ";";
    if (textures_ == nullptr && is_clear_ball(scene_) && !scene_.lights.environment.empty())
      return clear_ball();
    if (textured_) {
      glue_.line(
          "    object += (1.0 - fresnel_opacity(body_here.w, luminance_of(gloss_here.xyz), dot(n, v)))" +
          behind);
      return glue_.use("transparency", "of the texture");
    }
    if (textures_ != nullptr && textures_->alpha == TextureUse::Alpha::blend) {
      glue_.line("    object += (1.0 - fresnel_opacity(texel_opacity, " + f0_luminance() + ", dot(n, v)))" +
                 behind);
      return glue_.use("transparency", "alpha blends");
    }
    if (opacity_ >= 1) return glue_.leave_out("transparency", "opacity is 1");
    glue_.uniform("opacity", opacity_);
    glue_.line("    object += (1.0 - fresnel_opacity(opacity, " + f0_luminance() + ", dot(n, v)))" + behind);
    glue_.use("transparency", "opacity below 1");
  }

  const Scene& scene_;
  const GlslDisplay* display_;
  const bool backdrop_apart_;   // whether the backdrop beside the object is drawn by itself
  const TextureUse* textures_;  // what is fetched from an atlas; null: nothing
  const Camera camera_;
  const bool textured_, emits_;
  const double opacity_;
  GlslGlue glue_;
  std::string specular_, diffuse_, light_code_;  // the calls of the models, and the sum over the lights
  std::string texels_;                           // the code that sets the variables of the textures
  std::string body_ = "body_K";
  std::optional<GlslAmbient> ambient_;  // where the scene has hemispheres or an environment
  bool any_light_;                      // whether a discrete light lights a model
  bool areas_ = false;                  // whether an area light does
  bool framed_ = false;                 // whether the models read where the tangent lies
  bool mesh_ = false;                   // whether the caller's mesh is drawn
  bool fetching_ = false;               // whether a texture of an atlas is read
  bool has_diffuse_ = false, body_declared_ = false;
};

}  // namespace

std::string_view name(GlslVersion version) {
  return version == GlslVersion::core_330 ? "330 core" : version == GlslVersion::es_300 ? "300 es" : "450";
}

const GlslFeature* GlslText::feature(std::string_view feature_name) const {
  const auto found = std::find_if(features.begin(), features.end(),
                                  [&](const GlslFeature& each) { return each.name == feature_name; });
  return found == features.end() ? nullptr : &*found;
}

GlslText glsl_text(const Scene& scene, GlslVersion version, const GlslDisplay* display) {
  return SceneText(scene, display, nullptr).finish(version);
}

GlslParts glsl_parts(const Scene& scene, const GlslDisplay* display) {
  constexpr auto version = GlslVersion::core_330;
  const bool apart = scene.view && has_backdrop(scene) && !(scene.shape == Shape::quad && scene.perspective);
  GlslParts out{SceneText(scene, display, nullptr, apart).finish(version), std::nullopt};
  if (apart) out.beside = SceneText(scene, display, nullptr).beside(version);
  return out;
}

GlslText glsl_mesh_text(const Scene& scene, const TextureUse* textures, GlslVersion version) {
  return SceneText(scene, nullptr, textures).mesh(version);
}

GlslText glsl_text(const Scene& scene, const TextureUse& textures, GlslVersion version) {
  return SceneText(scene, nullptr, &textures).finish(version);
}

}  // namespace etak
