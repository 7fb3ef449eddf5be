// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/targets/gltf_fields.h"
#include "core/exchange/targets/material_x.h"

namespace etak {
namespace {

constexpr GltfNames gltf_pbr_names{"base_color",
                                   "metallic",
                                   "roughness",
                                   "ior",
                                   "specular_color",
                                   "transmission",
                                   "attenuation_color",
                                   "attenuation_distance",
                                   "dispersion",
                                   "clearcoat",
                                   "clearcoat_roughness",
                                   "iridescence",
                                   "iridescence_ior",
                                   "alpha",
                                   plain_text};

void write_gltf_pbr(const TargetJob& j) {
  j.below({1.5}).shows_schlick(
      write_gltf_fields(j, gltf_pbr_names, [&](double nm) { j.add("iridescence_thickness", nm); }));
  if (j.s.opacity < 1) j.note("alpha_mode is to be 2 (blend)");
}

}  // namespace

constinit const TargetRow target_gltf_pbr{
    {.id = "gltf-pbr",
     .title = "MaterialX gltf_pbr",
     .version = "MaterialX 1.39, gltf_pbr 2.0.1",
     .formula = "generalized_schlick_bsdf to color90 = 1; layer of a smooth dielectric_bsdf",
     .has_coat = true,
     .film_on_metal = "gltf",
     .film_on_dielectric = "gltf",
     .opens = material_x_opens,
     .closes = material_x_closes},
    write_gltf_pbr,
    material_x_body};

}  // namespace etak
