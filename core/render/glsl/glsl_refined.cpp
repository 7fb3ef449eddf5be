// SPDX-License-Identifier: Apache-2.0
// The same sums as shade_refined.h, for a GPU.
#include "core/render/glsl/glsl_refined.h"

#include "core/render/glsl/glsl_camera.h"
#include "core/render/glsl/glsl_glue.h"
#include "core/render/glsl/glsl_model.h"

namespace etak {
namespace {

class RefinedText {
 public:
  RefinedText(const Scene& scene, const AmbientPlan& plan, const RefinedLight* light)
      : scene_(scene), plan_(plan), light_(light), textured_(scene.textures != nullptr) {
    // Beside the object nothing is summed.
    scene_.background = {0, 0, 0};
    scene_.backdrop = {};
    if (light == nullptr) scene_.lights.environment.clear();
  }

  GlslText finish() {
    const std::string texels = texel_text(glue_, scene_);
    opacity_ = textured_ ? 1 : scene_.surface.opacity;
    glue_.declare("float", "ambient_pass");
    glue_.declare("sampler2D", "ambient_samples");
    uniforms();
    glue_.line("layout(location = 0) out vec4 pixel_color;\n");
    if (plan_.specular != nullptr) lobe();
    if (plan_.diffuse != nullptr) body();
    ambient();
    glue_.uniform("picture_size", scene_.width, scene_.height);
    glue_.uniform("background", scene_.background);
    const Camera camera(scene_);
    if (scene_.perspective) {
      glue_.uniform("camera_distance", camera.distance());
      glue_.uniform("camera_spread", camera.spread());
    }
    camera_text(glue_, scene_, camera);
    if (textured_)
      glue_.line(scene_.shape == Shape::sphere ? "    vec2 texel_at = sphere_texel(p);\n" + texels
                                               : "    vec2 texel_at = square_texel(p);\n" + texels);
    const std::string origin = scene_.view ? " - picture_origin" : "";
    glue_.line("    vec2 seen_at = gl_FragCoord.xy" + origin + ";");
    glue_.line(
        "    float turn = 6.283185307179586 * pixel_turn(uint(seen_at.x), uint(picture_size.y - "
        "seen_at.y));");
    glue_.line(
        "    color = ambient(n, v, vec2(cos(turn), sin(turn)));\n  }\n  pixel_color = vec4(color, 0.0);\n}");
    return std::move(glue_).finish(GlslVersion::core_330);
  }

 private:
  void uniforms() {
    if (light_ != nullptr) {
      for (const char* map : {"light_whole", "light_dim"}) glue_.declare("sampler2D", map);
      glue_.declare("sampler2D", "light_bright");
      glue_.uniform("bright_count", light_->bright.width);
      // Those of resources/shaders/refined.glsl.
      glue_.text.uniforms.push_back({"light_map_side", 1, 1, false, {float(light_->whole.side())}});
      glue_.text.uniforms.push_back({"light_map_last", 1, 1, false, {float(light_->whole.last_level())}});
      if (scene_.view || scene_.environment_turn_deg != 0) {
        const EnvironmentTurn turn(scene_.environment_turn_deg);
        glue_.uniform("environment_turn", turn.cosine(), turn.sine());
      }
    }
    if (const auto& sky = scene_.lights.hemispheres) {
      glue_.uniform("sky_upper", sky->upper);
      glue_.uniform("sky_lower", sky->lower);
      glue_.uniform("sky_axis", sky->axis);
    }
  }

  // The value of a model; where textures give a body that shall not count, it is black meanwhile.
  void function(const std::string& name, const std::string& call, bool without_texture) {
    glue_.line("vec3 " + name + "(Angles a) {\n  if (a.valid <= 0.0) return vec3(0.0);");
    if (without_texture) glue_.line("  vec4 kept = body_here;\n  body_here = vec4(0.0);");
    glue_.line("  vec3 f = " + call + ";");
    if (without_texture) glue_.line("  body_here = kept;");
    glue_.line("  return f;\n}\n");
  }

  void lobe() {
    function("lobe_f", model_call(glue_, "lobe", *plan_.specular, plan_.specular_values, 1, textured_),
             textured_ && plan_.combined);
  }

  void body() {
    const double opacity = plan_.combined ? 1 : opacity_;  // that of a combined model is in its values
    function("whole_f", model_call(glue_, "body", *plan_.diffuse, plan_.diffuse_values, opacity, textured_),
             false);
    glue_.line(plan_.combined ? "vec3 body_f(Angles a) {\n  return whole_f(a) - lobe_f(a);\n}\n"
                              : "vec3 body_f(Angles a) {\n  return whole_f(a);\n}\n");
  }

  std::string to_map(const std::string& d) const { return in_environment_map(scene_, d); }

  // The radiance around the direction `l` of the frame, over `solid_angle`.
  std::string around(const char* map) const {
    std::string out;
    if (scene_.lights.hemispheres)
      out = "mix(sky_lower, sky_upper, sky_share_around(dot(outside, sky_axis), solid_angle))";
    if (light_ != nullptr)
      out += (out.empty() ? "" : " + ") + std::string("light_map_around(") + map + ", " + to_map("outside") +
             ", solid_angle)";
    return out;
  }

  // Sums over the samples and lights of the pass.
  void samples(const char* f, bool half_vectors) {
    const bool apart = light_ != nullptr && (!half_vectors || plan_.wide);
    std::string row = "0";
    if (half_vectors)
      row = plan_.samples.height == 2 ? "1"
                                      : "1 + int(clamp(gloss_here.w, 0.0, 1.0) * " +
                                            glsl_decimal(plan_.samples.height - 2) + " + 0.5)";
    glue_.line("  for (int i = int(ambient_pass); i < " + std::to_string(plan_.samples.width) +
               "; i += " + std::to_string(GlslRefined::passes) + ") {");
    glue_.line("    vec4 s = turned_sample(ambient_samples, i, " + row + ", turn);");
    if (half_vectors)
      glue_.line(
          "    float vh = dot(s.xyz, local_v);\n    vec3 l = 2.0 * vh * s.xyz - local_v;\n"
          "    float solid_angle = s.w * max(vh, 0.0);");
    else
      glue_.line("    vec3 l = s.xyz;\n    float solid_angle = s.w;");
    glue_.line("    float share = max(l.z, 0.0) * solid_angle;\n    if (share <= 0.0) continue;");
    glue_.line("    vec3 outside = t * l.x + b * l.y + n * l.z;");
    glue_.line("    sum += " + std::string(f) + "(angles(l, local_v)) * (share * (" +
               around(apart ? "light_dim" : "light_whole") + "));\n  }");
    if (!apart) return;
    glue_.line("  for (int i = int(ambient_pass); i < int(bright_count); i += " +
               std::to_string(GlslRefined::passes) + ") {");
    const bool turned = scene_.view || scene_.environment_turn_deg != 0;
    const std::string from = "texelFetch(light_bright, ivec2(i, 0), 0).xyz";
    glue_.line("    vec3 l = in_frame(" +
               (turned ? "turned_from_map(" + from + ", environment_turn)" : from) +
               ", t, b, n);\n    if (l.z <= 0.0) continue;");
    glue_.line("    sum += " + std::string(f) +
               "(angles(l, local_v)) * (l.z * texelFetch(light_bright, ivec2(i, 1), 0).xyz);\n  }");
  }

  void ambient() {
    glue_.line("vec3 ambient(vec3 n, vec3 v, vec2 turn) {");
    glue_.line("  vec3 t = tangent_of(n);\n  vec3 b = cross(n, t);\n  vec3 local_v = in_frame(v, t, b, n);");
    glue_.line("  vec3 sum = vec3(0.0);");
    if (plan_.specular != nullptr) samples("lobe_f", true);
    if (plan_.body == AmbientPlan::Body::sampled) samples("body_f", false);
    if (plan_.body == AmbientPlan::Body::flat) {
      // The irradiance over pi, times a white body's f_r of 1 / pi and the body's colour.
      const bool plain = !textured_;
      const double opacity = plan_.combined || textured_ ? 1 : opacity_;
      glue_.uniform("flat_body", scaled(plan_.flat, 3.14159265358979323846 * opacity));
      glue_.line("  vec3 white = vec3(0.0);");
      if (scene_.lights.hemispheres)
        glue_.line("  white += hemisphere_diffuse(vec3(1.0), sky_lower, sky_upper, dot(n, sky_axis));");
      if (light_ != nullptr) glue_.line("  white += environment_diffuse(" + to_map("n") + ");");
      glue_.line("  if (ambient_pass == 0.0) sum += flat_body * " +
                 std::string(plain ? "white;" : "(body_here.xyz * body_here.w) * white;"));
    }
    glue_.line("  return sum;\n}\n");
  }

  Scene scene_;
  const AmbientPlan& plan_;
  const RefinedLight* light_;
  const bool textured_;
  double opacity_ = 1;
  GlslGlue glue_;
};

}  // namespace

GlslRefined glsl_refined(const Scene& scene, const Environment* environment, unsigned threads) {
  GlslRefined out;
  out.plan = ambient_plan(scene);
  const RefinedLight* light = environment != nullptr ? &environment->refined(threads) : nullptr;
  out.text = RefinedText(scene, out.plan, light).finish();
  if (light == nullptr) return out;
  out.textures = {{"light_whole", &light->whole.picture()},
                  {"light_dim", &light->dim.picture()},
                  {"environment_irradiance", &environment->irradiance_map()}};
  if (light->bright.width > 0) out.textures.emplace_back("light_bright", &light->bright);
  return out;
}

}  // namespace etak
