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
  if (!j.metal()) {
    j.add("KHR_materials_ior.ior", v.ior);
    j.add("KHR_materials_specular.specularColorFactor", v.specular_color, plain_text);
  }
  if (v.transmission > 0) j.add("KHR_materials_transmission.transmissionFactor", v.transmission);
  if (v.volume && v.volume->depth_m > 0) {
    j.add("KHR_materials_volume.attenuationColor", v.volume->color, plain_text);
    j.add("KHR_materials_volume.attenuationDistance", v.volume->depth_m);
  }
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
  j.note_no_transmission("this form of material does not say; gltf does");
  j.opacity("diffuseFactor alpha");
}

}  // namespace

constinit const TargetRow target_gltf{{"gltf", "glTF 2.0 metal-rough", true, "gltf", "gltf"}, write_gltf};
constinit const TargetRow target_gltf_gloss{{"gltf-specular-glossiness", "glTF 2.0 specular-glossiness"},
                                            write_gltf_gloss};

}  // namespace etak
