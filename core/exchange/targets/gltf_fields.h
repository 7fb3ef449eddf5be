// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/exchange/targets/target.h"

namespace etak {

/// What a program calls the values of a glTF material.
///   color   how it writes colours
struct GltfNames {
  const char *base_color, *metallic, *roughness, *ior, *specular_color, *transmission, *attenuation_color,
      *attenuation_distance, *dispersion, *clearcoat, *clearcoat_roughness, *iridescence, *iridescence_ior,
      *opacity;
  std::string (*color)(const LinearRgb&);
};

/// Adds the fields that a material needs.
///   add_thickness   adds the thickness of a film, in nm
///   returns         F0 as the target draws it
template <class AddThickness>
LinearRgb write_gltf_fields(const TargetJob& j, const GltfNames& names, const AddThickness& add_thickness) {
  const GltfMaterialValues v = gltf_values(j.s, false, j.fit, j.out.changes);
  j.add(names.base_color, v.base_color, names.color);
  j.add(names.metallic, v.metallic);
  j.add(names.roughness, v.roughness);
  if (!j.metal()) {
    j.add(names.ior, v.ior);
    j.add(names.specular_color, v.specular_color, names.color);
  }
  if (v.transmission > 0) j.add(names.transmission, v.transmission);
  if (v.volume && v.volume->depth_m > 0) {
    j.add(names.attenuation_color, v.volume->color, names.color);
    j.add(names.attenuation_distance, v.volume->depth_m);
  }
  if (v.dispersion > 0) j.add(names.dispersion, v.dispersion);
  if (v.clearcoat > 0) {
    j.add(names.clearcoat, v.clearcoat);
    j.add(names.clearcoat_roughness, 0);
  }
  if (v.iridescence > 0) {
    j.add(names.iridescence, v.iridescence);
    j.add(names.iridescence_ior, v.iridescence_ior);
    add_thickness(v.iridescence_nm);
  }
  j.opacity(names.opacity);
  return j.metal() ? v.base_color : scaled(v.specular_color, f64::f0(v.ior, 0));
}

}  // namespace etak
