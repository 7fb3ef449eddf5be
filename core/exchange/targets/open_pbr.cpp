// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/material_x.h"
#include "core/exchange/targets/target.h"

namespace etak {
namespace {

void write_open_pbr(const TargetJob& j) {
  const OpenPbrValues v = open_pbr_values(j.s, j.fit, j.out.changes);
  j.add("base_metalness", v.base_metalness);
  j.add("base_color", v.base_color, plain_text);
  j.add("specular_color", v.specular_color, plain_text);
  if (!j.metal()) j.add("specular_ior", v.specular_ior);
  j.add("specular_roughness", v.specular_roughness);
  if (v.transmission_weight > 0) {
    j.add("transmission_weight", v.transmission_weight);
    j.add("transmission_color", v.transmission_color, plain_text);
    j.add("transmission_depth", v.transmission_depth);
  }
  if (v.coat_weight > 0) {
    j.add("coat_weight", v.coat_weight);
    j.add("coat_color", v.coat_color, plain_text);
    j.add("coat_roughness", 0);
    j.add("coat_ior", v.coat_ior);
    j.add("coat_darkening", v.coat_darkening);
  }
  if (v.thin_film_weight > 0) {
    j.add("thin_film_weight", v.thin_film_weight);
    j.add("thin_film_thickness", v.thin_film_thickness);
    j.add("thin_film_ior", v.thin_film_ior);
  }
  j.opacity("geometry_opacity");
}

}  // namespace

constinit const TargetRow target_open_pbr{
    {"openpbr", "OpenPBR 1.1", true, "openpbr-metal", "openpbr-dielectric"}, write_open_pbr};

}  // namespace etak
