// SPDX-License-Identifier: Apache-2.0
#include <type_traits>

#include "core/exchange/targets/target.h"

namespace etak {
namespace {

constexpr std::string_view open_pbr_formula =
    "F82 tint of a metal, Fresnel's equations of a dielectric times specular_color";

void write_open_pbr(const TargetJob& j) {
  const OpenPbrValues v = open_pbr_values(j.s, j.fit, j.out.changes);
  j.add("base_metalness", v.base_metalness);
  j.add("base_color", v.base_color, plain_text);
  j.add("specular_color", v.specular_color, plain_text);
  if (!j.metal()) j.add("specular_ior", v.specular_ior);
  j.add("specular_roughness", v.specular_roughness);
  open_pbr_layers(v, [&](const char* name, const auto& value) {
    if constexpr (std::is_same_v<decltype(value), const double&>)
      j.add(name, value);
    else
      j.add(name, value, plain_text);
  });
  j.opacity("geometry_opacity");
  if (j.metal())
    j.shows_f82(v.base_color, v.specular_color);
  else
    j.shows_dielectric(v.specular_ior, v.specular_color);
}

// The same fields. A film's numbers are those for Adobe's openpbr-bsdf, which draws them in its own way.
void write_open_pbr_adobe(const TargetJob& j) {
  ExportSurface surface = j.s;
  if (surface.film) surface.film->adobe = true;
  write_open_pbr({surface, j.fit, j.out});
}

}  // namespace

constinit const TargetRow target_open_pbr{{.id = "openpbr",
                                           .title = "OpenPBR 1.1",
                                           .version = "1.1.1",
                                           .formula = open_pbr_formula,
                                           .has_coat = true,
                                           .film_on_metal = "openpbr-metal",
                                           .film_on_dielectric = "openpbr-dielectric"},
                                          write_open_pbr};
constinit const TargetRow target_open_pbr_adobe{{.id = "openpbr-adobe",
                                                 .title = "OpenPBR 1.1 in Adobe's openpbr-bsdf",
                                                 .version = "1.1.1",
                                                 .formula = open_pbr_formula,
                                                 .has_coat = true,
                                                 .film_on_metal = "openpbr-adobe-metal",
                                                 .film_on_dielectric = "openpbr-adobe-dielectric"},
                                                write_open_pbr_adobe};

}  // namespace etak
