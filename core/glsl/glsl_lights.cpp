// SPDX-License-Identifier: Apache-2.0
#include "core/glsl/glsl_lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/math/functions.h"

namespace etak {
namespace {

constexpr double degree = std::numbers::pi / 180;

std::string loop(std::size_t count) {
  return "  for (int i = 0; i < " + std::to_string(count) + "; ++i) {";
}

bool in_setup(const Scene& scene, LightKind kind) {
  return std::ranges::any_of(scene.lights.lights,
                             [&](const Light& light) { return light.kind == kind && shines(light); });
}

// The call that sums what a light in the direction `to` gives.
std::string lit(const std::string& to, bool framed) {
  return framed ? "lit(in_frame(" + to + ", t, b, n), local_v)" : "lit(n, " + to + ", v)";
}

// The code that computes the distance `r` of a light that has a position, and the way to it.
std::string arriving(const std::string& kind) {
  return "\n    vec3 to = " + kind + "_position[i] - p;\n    float r = max(length(to), " +
         std::to_string(point_light_min_r) + ");";
}

}  // namespace

bool shines(const Light& light) {
  return light.intensity != 0 && !is_black(light.color);
}

std::string light_loops(GlslGlue& glue, const Scene& scene, bool with_lights, bool framed) {
  std::string code;
  std::vector<const Light*> kinds[light_kinds.size()];
  for (const Light& light : scene.lights.lights)
    if (with_lights && shines(light)) kinds[static_cast<std::size_t>(light.kind)].push_back(&light);
  const double scale = scene.lights.pi_scaled ? std::numbers::pi : 1;
  const auto uniforms = [&](const char* name, int width, const std::vector<const Light*>& of, auto value) {
    std::vector<float> values;
    for (const Light* light : of) value(values, *light);
    glue.uniforms(name, width, values);
  };
  const auto strength = [scale](std::vector<float>& out, const Light& light) {
    append_floats(out, scaled(light.color, light.intensity * scale));
  };
  const auto position = [](std::vector<float>& out, const Light& light) {
    append_floats(out, light.position);
  };
  const auto towards = [](std::vector<float>& out, const Light& light) {
    append_floats(out, scaled(light.direction, -1));
  };

  if (const auto& of = kinds[static_cast<std::size_t>(LightKind::directional)]; !of.empty()) {
    uniforms("directional_to_light", 3, of, towards);
    uniforms("directional_irradiance", 3, of, strength);
    code += loop(of.size()) + "\n    sum += " + lit("directional_to_light[i]", framed) +
            " * directional_irradiance[i];\n  }\n";
  }
  if (const auto& of = kinds[static_cast<std::size_t>(LightKind::point)]; !of.empty()) {
    uniforms("point_position", 3, of, position);
    uniforms("point_intensity", 3, of, strength);
    code += loop(of.size()) + arriving("point") + "\n    sum += " + lit("to / r", framed) +
            " * point_irradiance(point_intensity[i], r);\n  }\n";
  }
  if (const auto& of = kinds[static_cast<std::size_t>(LightKind::spot)]; !of.empty()) {
    uniforms("spot_position", 3, of, position);
    uniforms("spot_intensity", 3, of, strength);
    uniforms("spot_back", 3, of, towards);
    uniforms("spot_cosines", 2, of, [](std::vector<float>& out, const Light& light) {
      out.push_back(static_cast<float>(math::cos(light.inner_deg * degree)));
      out.push_back(static_cast<float>(math::cos(light.outer_deg * degree)));
    });
    code +=
        loop(of.size()) + arriving("spot") +
        "\n    float share = spot_share(dot(to, spot_back[i]) / r, spot_cosines[i].x, spot_cosines[i].y);\n    sum += " +
        lit("to / r", framed) + " * point_irradiance(spot_intensity[i], r) * share;\n  }\n";
  }
  constexpr std::pair<LightKind, const char*> rows[] = {{LightKind::directional, "directional lights"},
                                                        {LightKind::point, "point lights"},
                                                        {LightKind::spot, "spot lights"}};
  for (const auto& [kind, name] : rows) {
    const std::size_t count = kinds[static_cast<std::size_t>(kind)].size();
    if (count > 0)
      glue.use(name, std::to_string(count));
    else
      glue.leave_out(name, in_setup(scene, kind) ? "nothing for them to light" : "none in the setup");
  }
  return code;
}

}  // namespace etak
