// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/targets/target.h"

namespace etak {
namespace {

void write_godot(const TargetJob& j) {
  LinearRgb f0;
  if (j.metal()) {
    f0 = j.fit_f0("albedo_color", "albedo_color ends at 1");
    j.add("albedo_color", f0, godot_text);
    j.add("metallic", 1);
    j.note("metallic_specular has no effect on a metal");
  } else {
    j.add("albedo_color", j.clear() ? grey(1) : j.s.diffuse, godot_text);
    j.add("metallic", 0);
    const double wanted = std::sqrt(std::max(j.one_f0("metallic_specular is one number"), 0.0) / 0.16);
    const double specular = fitted(wanted, 0, 1, "metallic_specular",
                                   "metallic_specular ends at 1, an F0 of 0.16", j.out.changes);
    j.add("metallic_specular", specular);
    f0 = grey(0.16 * specular * specular);
  }
  j.add("roughness", j.roughness());
  j.schlick_edge(f0);
  j.shows_schlick(f0, j.metal() ? 1 : faded_f90(f0));
  if (j.clear())
    j.note(
        "the body is clear: transparency Alpha with refraction_enabled, which bends the screen's picture (" +
        j.index_text() + ")");
  j.note_absorption("no field of the material takes it");
  j.opacity("albedo_color alpha");
}

std::string godot_body(const ExportSurface&, const EngineValues& values) {
  std::string out = "var material := StandardMaterial3D.new()\n";
  for (const EngineField& field : values.fields)
    out += field.name == "albedo_color alpha" ? "material.albedo_color.a = " + field.text + '\n'
                                              : "material." + field.name + " = " + field.text + '\n';
  return out +
         (values.fields.back().name.starts_with("emission") ? "material.emission_enabled = true\n" : "");
}

}  // namespace

constinit const TargetRow target_godot{
    {.id = "godot",
     .title = "Godot StandardMaterial3D",
     .version = "4.3",
     .formula = "Schlick to clamp(50 F0, metallic, 1) (scene_forward_lights_inc.glsl)"},
    write_godot,
    godot_body};

}  // namespace etak
