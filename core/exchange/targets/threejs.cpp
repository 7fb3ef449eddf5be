// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/targets/gltf_fields.h"
#include "core/math/functions.h"

namespace etak {
namespace {

constexpr GltfNames threejs_names{
    "color",          "metalness",    "roughness",          "ior",
    "specularColor",  "transmission", "attenuationColor",   "attenuationDistance",
    "dispersion",     "clearcoat",    "clearcoatRoughness", "iridescence",
    "iridescenceIOR", "opacity",      threejs_text};

void write_threejs(const TargetJob& j) {
  const LinearRgb f0 = write_gltf_fields(j, threejs_names, [&](double nm) {
    j.add("iridescenceThicknessRange", {nm}, "[" + number(nm, digits) + ", " + number(nm, digits) + "]");
  });
  // The power of Schlick's curve as its shaders have it, by an exponential of a Gaussian.
  const auto curve = [](double cosine) { return math::exp2((-5.55473 * cosine - 6.98316) * cosine); };
  j.below({0, {1, 1, 1}, false, curve}).shows([&](double cosine) {
    Vec3 out = vec(f0);
    for (double& channel : out) channel += (1 - channel) * curve(cosine);
    return out;
  });
}

std::string threejs_body(const ExportSurface&, const EngineValues& values) {
  std::string out = "new THREE.MeshPhysicalMaterial({\n";
  for (const EngineField& field : values.fields) out += "  " + field.name + ": " + field.text + ",\n";
  return out + "})\n";
}

}  // namespace

constinit const TargetRow target_threejs{
    {.id = "threejs",
     .title = "three.js MeshPhysicalMaterial",
     .version = "r164 to r180",
     .formula = "F_Schlick of common.glsl.js, to 1, of the clearcoat too",
     .has_coat = true,
     .film_on_metal = "gltf",
     .film_on_dielectric = "gltf",
     .comment = "// "},
    write_threejs,
    threejs_body};

}  // namespace etak
