// SPDX-License-Identifier: Apache-2.0
#include "core/glsl/glsl_ambient.h"

#include <numbers>
#include <utility>

namespace etak {
namespace {

// The numbers `what` of a pixel in GLSL: linear between the nodes of view and gloss.
std::string between(const AmbientTable& table, const std::string& what, bool rows) {
  const auto in_row = [&](int row) {
    const std::string from = row == 0 ? "" : " + " + std::to_string(row * table.views);
    const std::string to = " + " + std::to_string(row * table.views + 1);
    return "mix(" + what + "_at[ambient_node" + from + "], " + what + "_at[ambient_node" + to +
           "], ambient_view)";
  };
  return "  vec3 " + what + " = " +
         (rows ? "mix(" + in_row(0) + ",\n      " + in_row(1) + ", ambient_row)" : in_row(0)) + ";\n";
}

// The place between the views of a table: sets the float `view` and the int `node`.
std::string view_code(const AmbientTable& table, const std::string& view, const std::string& node) {
  return "  float " + view + " = sqrt(clamp(nv, 0.0, 1.0)) * " + glsl_decimal(table.views - 1) + ";\n  int " +
         node + " = min(int(" + view + "), " + std::to_string(table.views - 2) + ");\n  " + view +
         " -= float(" + node + ");\n";
}

}  // namespace

GlslAmbient::GlslAmbient(GlslGlue& glue, const Scene& scene, const Textured& varies, std::string f0,
                         std::string gloss)
    : glue_(glue),
      scene_(scene),
      table_(ambient_table(scene, varies)),
      f0_(std::move(f0)),
      gloss_(std::move(gloss)) {}

std::string GlslAmbient::needs_cosine() {
  return std::exchange(has_cosine_, true) ? "" : "  float nv = dot(n, v);\n";
}

std::string GlslAmbient::needs_probes() {
  if (std::exchange(has_probes_, true)) return "";
  const bool rows = table_->glosses > 1;
  std::string code = needs_cosine() + view_code(*table_, "ambient_view", "ambient_node");
  if (rows)
    code += "  float ambient_row = clamp(" + gloss_ + ", 0.0, 1.0) * " + glsl_decimal(table_->glosses - 1) +
            ";\n  int ambient_first = min(int(ambient_row), " + std::to_string(table_->glosses - 2) +
            ");\n  ambient_row -= float(ambient_first);\n  ambient_node += ambient_first * " +
            std::to_string(table_->views) + ";\n";
  glue_.uniforms("ambient_albedo_at", 3, table_->albedo);
  code += between(*table_, "ambient_albedo", rows);
  if (table_->of_f0) code += "  ambient_albedo = albedo_of_f0(ambient_albedo, " + f0_ + ");\n";
  for (std::size_t k = 0; k < probe_count; ++k) {
    const std::string probe = "probe_" + std::to_string(k);
    glue_.uniforms(probe + "_at", 3, table_->probes[k]);
    code += between(*table_, probe, rows);
  }
  return code;
}

// Adds what a lobe reflects by its samples.
//   seen   the light of a sample, of its `axis` and its level s.w
std::string GlslAmbient::samples(const std::string& seen) {
  const LobeSamples& of = table_->samples;
  const std::string last = std::to_string(of.views - 2), views = std::to_string(of.views);
  if (!std::exchange(has_probes_, true)) {
    glue_.declare("sampler2D", "ambient_samples");
    glue_.uniform("sample_count", of.count);
  }
  std::string row = "0";
  if (of.by_azimuth)
    row = "(int(floor(atan(dot(v, cross(n, tangent_of(n))), dot(v, tangent_of(n))) * " +
          glsl_decimal(of.rows / std::numbers::pi) + " + 0.5)) + " + std::to_string(of.rows) + ") % " +
          std::to_string(of.rows) + " * " + views;
  else if (of.rows > 1)
    row = "int(clamp(" + gloss_ + ", 0.0, 1.0) * " + glsl_decimal(of.rows - 1) + " + 0.5) * " + views;
  const auto between = [](const std::string& column) {
    return "mix(texelFetch(ambient_samples, ivec2(" + column +
           ", sample_row), 0),\n                 texelFetch(ambient_samples, ivec2(" + column +
           ", sample_row + 1), 0), sample_view)";
  };
  return needs_cosine() + "  {\n  float sample_view = sqrt(clamp(nv, 0.0, 1.0)) * " +
         glsl_decimal(of.views - 1) + ";\n  int sample_row = min(int(sample_view), " + last +
         ");\n  sample_view -= float(sample_row);\n" + "  sample_row += " + row +
         ";\n  vec3 seen = vec3(0.0);\n  vec3 along = viewer_tangent(n, v, nv);\n  vec3 across = cross(n, along);\n" +
         "  for (int i = 0; i < int(sample_count); ++i) {\n    vec4 s = " + between("i") +
         ";\n    vec3 share = " + between("i + int(sample_count)") +
         ".xyz;\n    vec3 axis = sample_axis(s.xyz, along, across, n, v);\n    seen += share * " + seen +
         ";\n  }\n  vec3 sample_albedo = " + between("2 * int(sample_count)") +
         ".xyz;\n  sum += " + (table_->of_f0 ? "albedo_of_f0(sample_albedo, " + f0_ + ")" : "sample_albedo") +
         " * seen;\n  }\n";
}

std::string GlslAmbient::hemispheres() {
  const HemisphereForm form = hemisphere_form(scene_);
  if (form == HemisphereForm::model && !table_->samples.empty())
    return samples("mix(sky_lower, sky_upper, probe_share(dot(normalize(axis), sky_axis), s.w))");
  if (form == HemisphereForm::model)
    return needs_probes() + "  sum += ambient_albedo * mix(sky_lower, sky_upper, " +
           sum_of_probes([](const std::string& probe) {
             return "probe_share(dot(normalize(probe_axis(n, v, nv, " + probe + ".x)), sky_axis), " + probe +
                    ".y)";
           }) +
           ");\n";
  const std::string function = form == HemisphereForm::printed ? "hemisphere_specular_printed"
                               : form == HemisphereForm::wide  ? "hemisphere_specular_wide"
                                                               : "hemisphere_specular";
  if (f0_.empty()) glue_.uniform("gloss_K", scene_.surface.f0);
  if (gloss_.empty()) glue_.uniform("gloss", scene_.surface.gloss);
  return needs_cosine() + "  sum += " + function + "(" + (f0_.empty() ? "gloss_K" : f0_) + ", " +
         (gloss_.empty() ? "gloss" : gloss_) +
         ", nv, dot(2.0 * nv * n - v, sky_axis), sky_lower, sky_upper);\n";
}

std::string GlslAmbient::diffuse(const std::string& light) {
  if (table_->plain_body) return "  sum += " + light + ";\n";
  std::string code;
  if (!std::exchange(has_body_, true)) {
    glue_.uniforms("ambient_body_at", 3, table_->body);
    code =
        needs_cosine() + view_code(*table_, "body_view", "body_node") +
        "  vec3 ambient_body = mix(ambient_body_at[body_node], ambient_body_at[body_node + 1], body_view);\n";
  }
  return code + "  sum += ambient_body * " + light + ";\n";
}

}  // namespace etak
