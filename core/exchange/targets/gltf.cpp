// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/gltf_material.h"
#include "core/exchange/targets/target.h"

namespace etak {
namespace {

void write_gltf(const TargetJob& j) {
  const GltfMaterialValues v = gltf_values(j.s, false, j.fit, j.out.changes);
  j.add("baseColorFactor", v.base_color, plain_text);
  j.add("metallicFactor", v.metallic);
  j.add("roughnessFactor", v.roughness);
  j.shows_schlick(j.metal() ? v.base_color : scaled(v.specular_color, f64::f0(v.ior, 0)));
  if (!j.metal()) {
    j.add("KHR_materials_ior.ior", v.ior);
    j.add("KHR_materials_specular.specularColorFactor", v.specular_color, plain_text);
  }
  if (v.transmission > 0) j.add("KHR_materials_transmission.transmissionFactor", v.transmission);
  if (v.volume && v.volume->depth_m > 0) {
    j.add("KHR_materials_volume.attenuationColor", v.volume->color, plain_text);
    j.add("KHR_materials_volume.attenuationDistance", v.volume->depth_m);
  }
  if (v.dispersion > 0) j.add("KHR_materials_dispersion.dispersion", v.dispersion);
  if (v.clearcoat > 0) {
    j.add("KHR_materials_clearcoat.clearcoatFactor", v.clearcoat);
    j.add("KHR_materials_clearcoat.clearcoatRoughnessFactor", 0);
  }
  if (v.iridescence > 0) {
    j.add("KHR_materials_iridescence.iridescenceFactor", v.iridescence);
    j.add("KHR_materials_iridescence.iridescenceIor", v.iridescence_ior);
    j.add("KHR_materials_iridescence.iridescenceThicknessMinimum", v.iridescence_nm);
    j.add("KHR_materials_iridescence.iridescenceThicknessMaximum", v.iridescence_nm);
  }
  j.opacity("baseColorFactor alpha");
}

void write_gltf_gloss(const TargetJob& j) {
  const GltfMaterialValues v = gltf_values(j.s, true, j.fit, j.out.changes);
  j.add("diffuseFactor", v.base_color, plain_text);
  j.add("specularFactor", v.specular_color, plain_text);
  j.add("glossinessFactor", v.glossiness);
  j.shows_schlick(v.specular_color);
  j.note_no_transmission("this form of material does not say; gltf does");
  j.opacity("diffuseFactor alpha");
}

}  // namespace

constinit const TargetRow target_gltf{
    {.id = "gltf",
     .title = "glTF 2.0 metal-rough",
     .version = "2.0.1",
     .formula = "Schlick to 1 (glTF 2.0, appendix B; KHR_materials_specular)",
     .has_coat = true,
     .film_on_metal = "gltf",
     .film_on_dielectric = "gltf"},
    write_gltf};
constinit const TargetRow target_gltf_gloss{{.id = "gltf-specular-glossiness",
                                             .title = "glTF 2.0 specular-glossiness",
                                             .version = "2.0.1",
                                             .formula = "Schlick to 1 (KHR_materials_pbrSpecularGlossiness)"},
                                            write_gltf_gloss};

}  // namespace etak
