// SPDX-License-Identifier: Apache-2.0
// The part of a shader that lights the object with areas: see core/light/area.glsl.
#include <algorithm>

#include "core/color/gloss.h"
#include "core/glsl/glsl_lights.h"

namespace etak {
namespace {

// Area lights that are cut in one way.
struct Group {
  AreaCut cut;
  std::vector<const Light*> lights;
};

std::vector<Group> groups_of(const Scene& scene) {
  std::vector<Group> out;
  for (const Light& light : scene.lights.lights) {
    if (!is_area(light.kind) || !shines(light)) continue;
    AreaCut cut = area_cut(light);
    auto found = std::ranges::find(out, cut, &Group::cut);
    if (found == out.end()) found = out.insert(out.end(), Group{std::move(cut), {}});
    found->lights.push_back(&light);
  }
  return out;
}

// Declares the table of lobes and writes the code that looks it up: area_lobe and area_plain.
std::string lobe_text(GlslGlue& glue, const AreaTable& lobes, const std::string& gloss) {
  std::vector<float> values;
  for (const auto& row : lobes.rows)
    for (const AreaLobe& each : row)
      for (const double number : {each.a, each.b, each.d, each.e, each.cosine, 0.0})
        values.push_back(static_cast<float>(number));
  glue.uniforms("area_lobes", 3, values);
  const std::string last = std::to_string(area_lobe_columns - 2);
  std::string code = "  float area_at = sqrt(1.0 - clamp(dot(n, v), 0.0, 1.0)) * " +
                     glsl_decimal(area_lobe_columns - 1) + ";\n  int area_column = 2 * min(int(area_at), " +
                     last + ");\n  float area_share = area_at - float(area_column / 2);\n";
  const auto row = [&](const std::string& name, const std::string& first) {
    for (const auto& [part, offset] : {std::pair("_p", 0), std::pair("_q", 1)}) {
      const std::string at = "area_lobes[" + first + "area_column + ";
      code += "  vec3 " + name + part + " = mix(" + at + std::to_string(offset) + "], " + at +
              std::to_string(offset + 2) + "], area_share);\n";
    }
  };
  if (lobes.rows.size() == 1) {
    glue.uniform("area_alpha", lobes.fit.alpha);
    code += "  float area_width = area_alpha;\n";
    row("area", "");
  } else {
    const int rows = static_cast<int>(lobes.rows.size()), numbers = 2 * area_lobe_columns;
    const std::string steps = glsl_decimal(rows - 1), alpha = "exponent_alpha(gloss_exponent(";
    code += "  float area_gloss = clamp(" + gloss + ", 0.0, 1.0);\n  int area_row = min(int(area_gloss * " +
            steps + "), " + std::to_string(rows - 2) + ");\n  float area_width = " + alpha +
            "area_gloss));\n" + "  float area_first = " + alpha + "float(area_row) / " + steps +
            "));\n  float area_next = " + alpha + "float(area_row + 1) / " + steps + "));\n" +
            "  float area_between = (area_width - area_first) / (area_next - area_first);\n";
    row("area_dull", "area_row * " + std::to_string(numbers) + " + ");
    row("area_sharp", "(area_row + 1) * " + std::to_string(numbers) + " + ");
    for (const char* part : {"_p", "_q"})
      code += std::string("  vec3 area") + part + " = mix(area_dull" + part + ", area_sharp" + part +
              ", area_between);\n";
  }
  return code +
         "  AreaMatrix area_lobe;\n  area_lobe.a = area_p.x;\n  area_lobe.b = area_p.y;\n"
         "  area_lobe.d = area_p.z * area_width;\n  area_lobe.e = area_q.x * area_width;\n";
}

}  // namespace

bool has_areas(const Scene& scene) {
  return std::ranges::any_of(scene.lights.lights,
                             [](const Light& light) { return is_area(light.kind) && shines(light); });
}

bool has_discrete(const Scene& scene) {
  return std::ranges::any_of(scene.lights.lights,
                             [](const Light& light) { return !is_area(light.kind) && shines(light); });
}

std::string area_loops(GlslGlue& glue, const Scene& scene, const AreaTable* lobes, bool diffuse,
                       const std::string& gloss, bool framed) {
  const std::vector<Group> groups = groups_of(scene);
  std::string code =
      "  vec3 area_x = v - dot(n, v) * n;\n"
      "  area_x = dot(area_x, area_x) > 1e-12 ? normalize(area_x) : tangent_of(n);\n"
      "  vec3 area_y = cross(n, area_x);\n";
  if (lobes != nullptr) code += lobe_text(glue, *lobes, gloss);
  const auto reflected = [&](const std::string& model) {
    const std::string l = "area_x * by.towards.x + area_y * by.towards.y + n * by.towards.z";
    return "      sum += " + model +
           (framed ? "(in_frame(" + l + ", t, b, n), local_v)" : "(n, " + l + ", v)") +
           " * (by.irradiance * radiance);\n";
  };
  std::size_t count = 0;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const auto& [cut, lights] = groups[g];
    count += lights.size();
    const std::string name = "area" + std::to_string(g + 1);
    std::vector<float> centre, right, up, radiance, corners;
    for (const Light* light : lights) {
      const AreaAxes axes = area_axes(*light);
      append_floats(centre, light->position);
      append_floats(right, axes.right);
      append_floats(up, axes.up);
      append_floats(radiance, scaled(light->color, light->intensity));
    }
    for (const auto& corner : cut) corners.insert(corners.end(), {float(corner[0]), float(corner[1])});
    glue.uniforms(name + "_centre", 3, centre);
    glue.uniforms(name + "_right", 3, right);
    glue.uniforms(name + "_up", 3, up);
    glue.uniforms(name + "_radiance", 3, radiance);
    glue.uniforms(name + "_cut", 2, corners);
    code += "  for (int i = 0; i < " + std::to_string(lights.size()) +
            "; ++i) {\n    vec3 radiance = " + name + "_radiance[i];\n    for (int k = 0; k < " +
            std::to_string(corners.size() / 2) + "; k += 4) {\n";
    std::string four;
    for (int k = 0; k < 4; ++k) {
      const std::string at = "p" + std::to_string(k), place = name + "_cut[k + " + std::to_string(k) + "]";
      code += "      vec3 " + at + " = in_frame(" + name + "_centre[i] - p + " + name + "_right[i] * " +
              place + ".x + " + name + "_up[i] * " + place + ".y, area_x, area_y, n);\n";
      four += (k > 0 ? ", " : "") + at;
    }
    if (lobes != nullptr)
      code += "      AreaLit by = area_specular(area_lobe, area_q.y, " + four + ");\n" +
              reflected("area_specular_model");
    if (diffuse)
      code += std::string(lobes != nullptr ? "      by" : "      AreaLit by") + " = area_diffuse(" + four +
              ");\n" + reflected("area_diffuse_model");
    code += "    }\n  }\n";
  }
  glue.use("area lights", std::to_string(count));
  return code;
}

}  // namespace etak
