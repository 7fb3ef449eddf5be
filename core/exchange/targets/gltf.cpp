// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/targets/gltf_fields.h"

namespace etak {
namespace {

constexpr GltfNames gltf_names{"baseColorFactor",
                               "metallicFactor",
                               "roughnessFactor",
                               "KHR_materials_ior.ior",
                               "KHR_materials_specular.specularColorFactor",
                               "KHR_materials_transmission.transmissionFactor",
                               "KHR_materials_volume.attenuationColor",
                               "KHR_materials_volume.attenuationDistance",
                               "KHR_materials_dispersion.dispersion",
                               "KHR_materials_clearcoat.clearcoatFactor",
                               "KHR_materials_clearcoat.clearcoatRoughnessFactor",
                               "KHR_materials_iridescence.iridescenceFactor",
                               "KHR_materials_iridescence.iridescenceIor",
                               "baseColorFactor alpha",
                               plain_text};

void write_gltf(const TargetJob& j) {
  j.below({}).shows_schlick(write_gltf_fields(j, gltf_names, [&](double nm) {
    j.add("KHR_materials_iridescence.iridescenceThicknessMinimum", nm);
    j.add("KHR_materials_iridescence.iridescenceThicknessMaximum", nm);
  }));
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
     .formula =
         "Schlick to 1 (glTF 2.0, appendix B; KHR_materials_specular); fresnel_coat of KHR_materials_clearcoat",
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
