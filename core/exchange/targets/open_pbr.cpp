// SPDX-License-Identifier: Apache-2.0
#include <type_traits>

#include "core/exchange/targets/target.h"

namespace etak {
namespace {

constexpr std::string_view open_pbr_formula =
    "F82 tint of a metal, Fresnel's equations of a dielectric times specular_color, and of a coat";

// specular_color with what MaterialX's graph leaves of a base under a coat, which it takes for a diffuse one of its
// base_color.
LinearRgb darkened(const OpenPbrValues& v) {
  const double kept = 1 - (1 - f64::f0(v.coat_ior, 0)) / (v.coat_ior * v.coat_ior);
  Vec3 out = vec(v.specular_color);
  for (std::size_t c = 0; c < 3; ++c)
    out[c] *= 1 + v.coat_darkening * ((1 - kept) / (1 - kept * vec(v.base_color)[c]) - 1);
  return to_rgb(out);
}

// F over the angle. Under a coat a dielectric has the index relative to it, or the inverse of that where it is below 1.
void show(const TargetJob& j, const OpenPbrValues& v, bool adobe) {
  if (v.coat_weight == 0)
    return j.metal() ? j.shows_f82(v.base_color, v.specular_color)
                     : j.shows_dielectric(v.specular_ior, v.specular_color);
  if (adobe && v.coat_darkening > 0) {
    j.out.error_reason = "how Adobe's renderer darkens a diffuse body under a coat is not computed";
    return;
  }
  const TargetJob base = j.below({v.coat_ior, v.coat_color, adobe});
  const double ratio = v.specular_ior / v.coat_ior;
  if (j.metal()) return base.shows_f82(v.base_color, v.specular_color);
  base.shows_dielectric(std::max(ratio, 1 / ratio), darkened(v));
}

void write_fields(const TargetJob& j, bool adobe) {
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
  show(j, v, adobe);
}

void write_open_pbr(const TargetJob& j) {
  write_fields(j, false);
}

// The same fields. A film's numbers are those for Adobe's openpbr-bsdf, which draws them in its own way.
void write_open_pbr_adobe(const TargetJob& j) {
  ExportSurface surface = j.s;
  if (surface.film) surface.film->adobe = true;
  write_fields({surface, j.fit, j.out}, true);
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
