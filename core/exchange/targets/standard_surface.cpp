// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/targets/material_x.h"
#include "core/exchange/targets/target.h"

namespace etak {
namespace {

void write_metal(const TargetJob& j) {
  const ArtisticIndex index = artistic_index(j, "base_color");
  j.add("base", 1);
  j.add("base_color", index.reflectivity, plain_text);
  j.add("metalness", 1);
  j.add("specular_color", index.edge_color, plain_text);
  j.shows_conductor(index.n, index.k);
}

void write_dielectric(const TargetJob& j) {
  const OpenPbrValues v = open_pbr_values(j.s, j.fit, j.out.changes);
  j.add("base", 1);
  j.add("base_color", v.base_color, plain_text);
  j.add("metalness", 0);
  j.add("specular_color", v.specular_color, plain_text);
  j.add("specular_IOR", v.specular_ior);
  j.shows_dielectric(v.specular_ior, v.specular_color);
  if (v.transmission_weight == 0) return;
  j.add("transmission", v.transmission_weight);
  j.add("transmission_color", v.transmission_color, plain_text);
  j.add("transmission_depth", v.transmission_depth);
  if (j.s.clear->v_d) j.add("transmission_dispersion", *j.s.clear->v_d);
}

void write_standard_surface(const TargetJob& j) {
  j.metal() ? write_metal(j) : write_dielectric(j);
  j.add("specular_roughness", j.roughness());
  if (j.s.opacity < 1) j.add("opacity", grey(j.s.opacity), plain_text);
}

}  // namespace

constinit const TargetRow target_standard_surface{
    {.id = "standard-surface",
     .title = "Standard Surface (Arnold, MaterialX standard_surface)",
     .version = "1.0.1",
     .formula =
         "Fresnel's equations: of a metal with Gulbrandsen's n and k, of a dielectric times specular_color",
     .opens = material_x_opens,
     .closes = material_x_closes},
    write_standard_surface,
    material_x_body};

}  // namespace etak
