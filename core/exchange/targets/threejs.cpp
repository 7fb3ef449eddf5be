// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/targets/target.h"

namespace etak {
namespace {

void write_threejs(const TargetJob& j) {
  const GltfMaterialValues v = gltf_values(j.s, false, j.fit, j.out.changes);
  j.add("color", v.base_color, threejs_text);
  j.add("metalness", v.metallic);
  j.add("roughness", v.roughness);
  if (!j.metal()) {
    j.add("ior", v.ior);
    j.add("specularColor", v.specular_color, threejs_text);
  }
  if (v.transmission > 0) j.add("transmission", v.transmission);
  if (v.volume && v.volume->depth_m > 0) {
    j.add("attenuationColor", v.volume->color, threejs_text);
    j.add("attenuationDistance", v.volume->depth_m);
  }
  if (v.dispersion > 0) j.add("dispersion", v.dispersion);
  if (v.clearcoat > 0) {
    j.add("clearcoat", v.clearcoat);
    j.add("clearcoatRoughness", 0);
  }
  if (v.iridescence > 0) {
    j.add("iridescence", v.iridescence);
    j.add("iridescenceIOR", v.iridescence_ior);
    j.add("iridescenceThicknessRange", {v.iridescence_nm},
          "[" + number(v.iridescence_nm, digits) + ", " + number(v.iridescence_nm, digits) + "]");
  }
  j.opacity("opacity");
  // The power of Schlick's curve as its shaders have it, by an exponential of a Gaussian.
  const LinearRgb f0 = j.metal() ? v.base_color : scaled(v.specular_color, f64::f0(v.ior, 0));
  j.shows([&](double cosine) {
    const double curve = std::exp2((-5.55473 * cosine - 6.98316) * cosine);
    Vec3 out = vec(f0);
    for (double& channel : out) channel += (1 - channel) * curve;
    return out;
  });
}

std::string threejs_body(const ExportSurface&, const EngineValues& values) {
  std::string out = "new THREE.MeshPhysicalMaterial({\n";
  for (const EngineField& field : values.fields) out += "  " + field.name + ": " + field.text + ",\n";
  return out + "})\n";
}

}  // namespace

constinit const TargetRow target_threejs{{.id = "threejs",
                                          .title = "three.js MeshPhysicalMaterial",
                                          .version = "r164 to r180",
                                          .formula = "F_Schlick of common.glsl.js, to 1",
                                          .has_coat = true,
                                          .film_on_metal = "gltf",
                                          .film_on_dielectric = "gltf",
                                          .comment = "// "},
                                         write_threejs,
                                         threejs_body};

}  // namespace etak
