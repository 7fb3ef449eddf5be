// SPDX-License-Identifier: Apache-2.0
#include "core/glsl/glsl_text.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/color/luminance.h"
#include "core/glsl/glsl_camera.h"
#include "core/glsl/glsl_glue.h"
#include "core/glsl/glsl_source.h"
#include "core/glsl/glsl_surface.h"
#include "core/glsl/glsl_transfer.h"
#include "core/glsl/texture_fetch.h"
#include "core/render/ambient/round_lobe.h"
#include "core/render/camera.h"

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
        surface_(glue_, scene, textures) {}

  // The scene's surface on a mesh of the caller's.
  GlslText mesh(GlslVersion version) {
    surface();
    on_mesh();
    GlslText text = std::move(glue_).finish(version);
    text.corners = 0;
    return text;
  }

  GlslText finish(GlslVersion version) {
    surface();
    picture();
    return std::move(glue_).finish(version);
  }

  // The backdrop beside the object, alone.
  GlslText beside(GlslVersion version) {
    if (display_ != nullptr) glue_.line(display_->text);
    environment_turn_of(glue_, scene_);
    glue_.line(drawn_to);
    glue_.uniform("background", scene_.background);
    beside_text(glue_, scene_, camera_);
    transfer_text(glue_, scene_, display_);
    glue_.line("  pixel_color = vec4(color, 0.0);\n}");
    return std::move(glue_).finish(version);
  }

 private:
  static constexpr const char* drawn_to = "layout(location = 0) out vec4 pixel_color;\n";

  void surface() {
    if (display_ != nullptr) glue_.line(display_->text);
    surface_.write(drawn_to);
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
    if (!surface_.texels().empty()) {
      glue_.line(sphere ? "    vec2 texel_at = sphere_texel(p);" : "    vec2 texel_at = square_texel(p);");
      if (scene_.texture_scale != std::array{1.0, 1.0}) {
        glue_.uniform("texture_scale", scene_.texture_scale[0], scene_.texture_scale[1]);
        glue_.line("    texel_at = fract(texel_at * texture_scale);");
      }
      glue_.line(surface_.texels());
    }
    if (surface_.fetches()) glue_.line("    fetch(p.xy);");
    glue_.line("    vec3 object = shade(p, n, v);");
    transparency();
    marks_text(glue_, scene_, surface_.body_color());
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
    if (!surface_.texels().empty()) glue_.line("    vec2 texel_at = mesh_texel;\n" + surface_.texels());
    if (surface_.fetches()) glue_.line("  fetch(mesh_texel * vec2(2.0, -2.0) + vec2(-1.0, 1.0));");
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
    if (surface_.opacity() >= 1) {
      glue_.leave_out("transparency", "opacity is 1");
      return "1.0";
    }
    glue_.uniform("opacity", surface_.opacity());
    glue_.use("transparency", "opacity below 1");
    return "fresnel_opacity(opacity, " + f0_luminance() + ", clamp(dot(n, v), 0.0, 1.0))";
  }

  // The luminance of F0, of the texel where the textures hold F0.
  std::string f0_luminance() {
    if (textures_ != nullptr && textures_->specular) return "luminance_of(texel_f0)";
    glue_.uniform("f0_luminance", unseen_luminance(scene_.surface));
    return "f0_luminance";
  }

  // The environment through a clear ball. An atlas has no clear bodies.
  void clear_ball() {
    glue_.uniform("opacity", surface_.opacity());
    const auto& layers = scene_.surface.layers;
    glue_.uniform("ball_n", layers ? layers->n : scene_.surface.n[1]);
    glue_.uniform("ball_level", level_of_gloss(scene_.surface.gloss));
    glue_.uniform("ball_passing", *scene_.surface.passing);
    std::string curve;
    for (std::size_t i = 0; layers && i < FresnelCurve::count; ++i) {
      const std::string name = "ball_r" + std::to_string(i);
      glue_.uniform(name, layers->twice.colors[i]);
      curve += name + ", ";
    }
    const std::string nv = "clamp(dot(n, v), 0.0, 1.0)";
    glue_.line("    object += (1.0 - opacity) * " +
               (layers ? "through_layers(" + nv + ", ball_n, ball_passing, f_curve(" + curve + nv + "))"
                       : "through_ball(" + nv + ", ball_n, ball_passing)") +
               " *");
    glue_.line("              environment_specular(" +
               in_environment_map(scene_, "beyond_ball(n, v, ball_n)") + ", ball_level);");
    glue_.use("transparency", "a clear ball bends the environment");
  }

  void transparency() {
    const std::string behind = " * " + backdrop_name(scene_) + ";";
    if (textures_ == nullptr && is_clear_ball(scene_) && !scene_.lights.environment.empty())
      return clear_ball();
    if (surface_.is_textured()) {
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
    if (surface_.opacity() >= 1) return glue_.leave_out("transparency", "opacity is 1");
    glue_.uniform("opacity", surface_.opacity());
    glue_.line("    object += (1.0 - fresnel_opacity(opacity, " + f0_luminance() + ", dot(n, v)))" + behind);
    glue_.use("transparency", "opacity below 1");
  }

  const Scene& scene_;
  const GlslDisplay* display_;
  const bool backdrop_apart_;   // whether the backdrop beside the object is drawn by itself
  const TextureUse* textures_;  // what is fetched from an atlas; null: nothing
  const Camera camera_;
  GlslGlue glue_;
  GlslSurface surface_;
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
