// SPDX-License-Identifier: Apache-2.0

#include "core/base/json/json_text.h"
#include "core/exchange/targets/rgb_index.h"
#include "core/fresnel/fresnel.h"

namespace etak {
namespace {

void write_principled(const TargetJob& j) {
  if (j.metal()) {
    const LinearRgb f0 = j.fit_f0("Base Color", "Base Color of a metal ends at 1");
    j.add("Base Color", f0, blender_text);
    j.add("Metallic", 1);
    const LinearRgb tint = fitted(tint82(j.s, f0), {Fit::clamp, 1, j.s.space}, "Specular Tint",
                                  "the edge tint ends at 1", j.out.changes);
    j.add("Specular Tint", tint, blender_text);
    j.shows_f82(f0, tint);
  } else {
    const LinearRgb f0 = fitted(j.s.f0, {j.fit, largest_dielectric_f0, j.s.space}, "F0",
                                "the index of a dielectric has to be finite", j.out.changes);
    const double most = largest(f0);
    j.add("Base Color", j.clear() ? grey(1) : j.layered_body(), blender_text);
    j.add("Metallic", 0);
    const double ior = j.s.ior.value_or(ior_of_f0(most)), reflected = j.s.ior ? f64::f0(ior, 0) : most;
    j.add("IOR", ior);
    j.add("IOR Level", 0.5);
    const LinearRgb tint = reflected > 0 ? scaled(f0, 1 / reflected) : grey(1);
    const LinearRgb used =
        fitted(tint, {j.fit, 1, j.s.space}, "Specular Tint", "Specular Tint ends at 1", j.out.changes);
    j.add("Specular Tint", used, blender_text);
    // The curve of the index from its F0 to 1, spread from the tinted F0 to 1.
    const double head_on = f64::f0(ior, 0);
    j.shows([&](double cosine) {
      const double curve = head_on < 1 ? (f64::fresnel_exact(ior, 0, cosine) - head_on) / (1 - head_on) : 1;
      Vec3 out = vec(scaled(used, head_on));
      for (double& channel : out) channel += (1 - channel) * curve;
      return out;
    });
    if (j.clear() && !j.s.ior && f0 != grey(most))
      j.note("IOR is that of the channel that reflects most, and Specular Tint lowers the others: " +
             j.index_text() + " by luminance");
  }
  j.add("Roughness", j.roughness());
  if (j.clear()) {
    j.add("Transmission Weight", 1);
    j.note_absorption("a Volume Absorption node beside the shader takes it");
  }
  j.opacity("Alpha");
}

void write_blender(const TargetJob& j) {
  if (!j.s.coat) return write_principled(j);
  const CoatedF0& coat = *j.s.coat;
  const TargetCoat over{coat.n, coat.passes, true};
  const ExportSurface base = under_coat(j.s, over);
  write_principled({base, j.fit, j.out, over});
  j.add("Coat Weight", 1);
  j.add("Coat Roughness", 0);
  j.add("Coat IOR", coat.n);
  j.add("Coat Tint",
        fitted(coat.passes, {j.fit, 1, j.s.space}, "Coat Tint", "Coat Tint is 0 to 1", j.out.changes),
        blender_text);
}

// The Metallic BSDF has two forms of F, of which the one with the smaller error is written.
void write_metallic(const TargetJob& j) {
  if (!j.metal()) {
    j.note("the Metallic BSDF is for metals: the values are those of the Principled BSDF");
    return write_principled(j);
  }
  const LinearRgb f0 = j.fit_f0("Base Color", "Base Color of a metal ends at 1");
  const LinearRgb tint = fitted(tint82(j.s, f0), {Fit::clamp, 1, j.s.space}, "Edge Tint",
                                "the edge tint ends at 1", j.out.changes);
  const RgbIndex index = rgb_index(j.s);
  j.shows_conductor(index.n, index.k);
  const std::optional<FilmError> physical = j.out.error;
  j.shows_f82(f0, tint);
  j.add("Base Color", f0, blender_text);
  j.add("Edge Tint", tint, blender_text);
  j.out.choice = "F82";
  if (physical) {
    const bool better = physical->mean < j.out.error->mean;
    j.add("IOR", index.n, vector_text);
    j.add("Extinction", index.k, vector_text);
    j.note(std::string("Fresnel Type ") + (better ? "Physical Conductor" : "F82 Tint") + ": dE2000 " +
           number(physical->mean, 2) + " on the mean by IOR and Extinction, " + number(j.out.error->mean, 2) +
           " by Base Color and Edge Tint");
    if (better) {
      j.out.choice = "PHYSICAL_CONDUCTOR";
      j.out.error = physical;
    }
  }
  j.add("Roughness", j.roughness());
}

std::string metallic_script(const ExportSurface& s, const EngineValues& values) {
  const bool metal = s.kind == SurfaceKind::metal;
  std::string out = "\n# " + line_text(s.title()) + "\nmaterial = bpy.data.materials.new(" + json(s.name) +
                    ")\nmaterial.use_nodes = True\nnodes = material.node_tree.nodes\nnodes.clear()\n"
                    "shader = nodes.new(\"ShaderNodeBsdf" +
                    (metal ? "Metallic" : "Principled") + "\")\n";
  if (metal) out += "shader.fresnel_type = \"" + values.choice + "\"\n";
  for (const EngineField& field : values.fields)
    out += "shader.inputs[\"" + (field.name == "IOR Level" ? "Specular IOR Level" : field.name) +
           "\"].default_value = " + field.text + '\n';
  return out +
         "output = nodes.new(\"ShaderNodeOutputMaterial\")\n"
         "material.node_tree.links.new(shader.outputs[\"BSDF\"], output.inputs[\"Surface\"])\n";
}

}  // namespace

constinit const TargetRow target_blender_metallic{
    {.id = "blender-metallic",
     .title = "Blender Metallic BSDF, as a Python script",
     .version = "4.3",
     .formula = "Cycles: Fresnel's equations of each channel, or F82 tint",
     .opens = "import bpy\n"},
    write_metallic,
    metallic_script};

constinit const TargetRow target_blender{
    {.id = "blender",
     .title = "Blender 4 Principled BSDF",
     .version = "4.2",
     .formula =
         "Cycles: F82 tint of a metal; a dielectric's curve spread from its F0 to 1; Fresnel's equations of a coat",
     .has_coat = true},
    write_blender};

}  // namespace etak
