// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "core/glsl/glsl_transfer.h"

namespace etak {

void marks_text(GlslGlue& glue, const Scene& scene, const std::string& body_color) {
  const bool textured = scene.textured().values();
  const std::vector<float>& energy = scene.mark_energy;
  const bool zone = scene.mark_zone;
  // Only windows can ask for stripes, so the feature is listed for their scenes alone (those with a view).
  if (!zone && scene.view) glue.leave_out("zone stripes", "not asked for");
  if (energy.empty() && scene.view) glue.leave_out("energy stripes", "not asked for");
  if (!scene.mark_angles && scene.view) glue.leave_out("angle zones", "not asked for");
  const std::string exposure = scene.exposure != 1 || scene.view ? "exposure" : "1.0";
  if (scene.mark_angles) {
    glue.line("    object = with_angle_zones(object, dot(n, v), " + exposure + ");");
    glue.use("angle zones", "45 and 75 degrees");
  }
  if (!zone && energy.empty()) return;
  std::string in_zone = "false", in_energy = "false";
  if (zone) {
    // F0 has a uniform of its own, because that of the hemispheres exists only where the setup has them.
    if (!textured) glue.uniform("zone_f0", scene.surface.f0);
    in_zone = "in_forbidden_zone(" + std::string(textured ? "gloss_here.xyz" : "zone_f0") + ")";
    glue.use("zone stripes", "luminance of F0");
  }
  if (!energy.empty() && textured) {
    in_energy = "sends_too_much(gloss_here.xyz, " + body_color + ")";
    glue.use("energy stripes", "diffuse colour and F0");
  } else if (!energy.empty()) {
    const std::string last = std::to_string(energy.size() - 1),
                      size = glsl_decimal(double(energy.size() - 1));
    glue.uniforms("mark_energy", 1, energy);
    glue.line("    float step = clamp(dot(n, v), 0.0, 1.0) * " + size + ";");
    glue.line("    int lower = min(int(step), " + last + " - 1);");
    glue.line("    float albedo = mix(mark_energy[lower], mark_energy[lower + 1], step - float(lower));");
    in_energy = "albedo > too_much";
    glue.use("energy stripes", "albedo towards the viewer");
  }
  const bool anywhere = scene.view.has_value();
  glue.line(std::string("    vec2 stripe_at = floor(gl_FragCoord.xy") +
            (anywhere ? " - picture_origin" : "") + ");");
  glue.line("    object = with_stripes(object, " + in_zone + ", " + in_energy +
            ", stripe_at.x, picture_size.y - 1.0 - stripe_at.y, " + exposure + ");");
}

}  // namespace etak
