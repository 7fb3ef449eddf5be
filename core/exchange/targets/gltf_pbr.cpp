// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/targets/material_x.h"
#include "core/exchange/targets/target.h"

namespace etak {
namespace {

void write_gltf_pbr(const TargetJob& j) {
  const GltfMaterialValues v = gltf_values(j.s, false, j.fit, j.out.changes);
  j.add("base_color", v.base_color, plain_text);
  j.add("metallic", v.metallic);
  j.add("roughness", v.roughness);
  if (!j.metal()) {
    j.add("ior", v.ior);
    j.add("specular_color", v.specular_color, plain_text);
  }
  if (v.transmission > 0) j.add("transmission", v.transmission);
  if (v.volume && v.volume->depth_m > 0) {
    j.add("attenuation_color", v.volume->color, plain_text);
    j.add("attenuation_distance", v.volume->depth_m);
  }
  if (v.dispersion > 0) j.add("dispersion", v.dispersion);
  if (v.clearcoat > 0) {
    j.add("clearcoat", v.clearcoat);
    j.add("clearcoat_roughness", 0);
  }
  if (v.iridescence > 0) {
    j.add("iridescence", v.iridescence);
    j.add("iridescence_ior", v.iridescence_ior);
    j.add("iridescence_thickness", v.iridescence_nm);
  }
  j.opacity("alpha");
  if (j.s.opacity < 1) j.note("alpha_mode is to be 2 (blend)");
  j.shows_schlick(j.metal() ? v.base_color : scaled(v.specular_color, f64::f0(v.ior, 0)));
}

std::string gltf_pbr_body(const ExportSurface& s, const EngineValues& values) {
  return material_x_body("gltf_pbr", s, values);
}

}  // namespace

constinit const TargetRow target_gltf_pbr{{.id = "gltf-pbr",
                                           .title = "MaterialX gltf_pbr",
                                           .version = "MaterialX 1.39, gltf_pbr 2.0.1",
                                           .formula = "generalized_schlick_bsdf to color90 = 1",
                                           .has_coat = true,
                                           .film_on_metal = "gltf",
                                           .film_on_dielectric = "gltf",
                                           .opens = material_x_opens,
                                           .closes = material_x_closes},
                                          write_gltf_pbr,
                                          gltf_pbr_body};

}  // namespace etak
