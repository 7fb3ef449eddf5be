// SPDX-License-Identifier: Apache-2.0
// The values of OpenPBR and glTF of engine_values.h.
#include <algorithm>
#include <cmath>

#include "core/exchange/color_parts.h"
#include "core/exchange/engine_values.h"
#include "core/exchange/export_coat.h"
#include "core/fresnel/fresnel.h"

namespace etak {
namespace {

// A metal under OpenPBR's coat, or a dielectric, whose index the target compares with the coat's itself.
OpenPbrValues coated_open_pbr(const ExportSurface& s, Fit fit, Changes& changes) {
  ExportSurface base = under_coat(s, {s.coat->n, s.coat->passes});
  if (s.kind == SurfaceKind::dielectric) {
    base = s;
    base.coat.reset();
  }
  OpenPbrValues out = open_pbr_values(base, fit, changes);
  out.coat_weight = 1;
  out.coat_ior = s.coat->n;
  out.coat_darkening = s.diffuse == LinearRgb{} ? 0 : 1;
  out.coat_color = fitted(s.coat->passes, {fit, 1, s.space}, "coat_color", "coat_color is 0 to 1", changes);
  return out;
}

// A surface whose F0 and edge are those of the base of a form's film; without the film.
ExportSurface film_base_of(const ExportSurface& s, const double* f0, std::optional<LinearRgb> f82) {
  ExportSurface out = s;
  out.film.reset();
  out.f0 = {f0[0], f0[1], f0[2]};
  out.f82 = f82;
  return out;
}

OpenPbrValues filmed_open_pbr(const ExportSurface& s, Fit fit, Changes& changes) {
  const bool metal = s.kind == SurfaceKind::metal;
  const char* const form = s.film->adobe ? (metal ? "openpbr-adobe-metal" : "openpbr-adobe-dielectric")
                                         : (metal ? "openpbr-metal" : "openpbr-dielectric");
  const FilmNumbers& x = s.film->values(form).numbers;
  ExportSurface base = film_base_of(s, x.data(), std::nullopt);
  if (metal) {
    const LinearRgb edge = schlick82(base.f0);
    base.f82 = LinearRgb{edge.r * x[3], edge.g * x[4], edge.b * x[5]};
  } else {
    const double f0 = f64::f0(x[3], 0);
    base.f0 = {f0, f0, f0};
  }
  OpenPbrValues out = open_pbr_values(base, fit, changes);
  if (!metal) out.specular_color = {x[0], x[1], x[2]};
  const std::size_t index = metal ? 6 : 4;
  out.thin_film_ior = x[index];
  out.thin_film_thickness = x[index + 1] / 1000;
  out.thin_film_weight = x[index + 2];
  return out;
}

GltfMaterialValues filmed_gltf(const ExportSurface& s, Fit fit, Changes& changes) {
  const FilmNumbers& x = s.film->values("gltf").numbers;
  GltfMaterialValues out = gltf_values(film_base_of(s, x.data(), std::nullopt), false, fit, changes);
  out.iridescence = x[3];
  out.iridescence_ior = x[4];
  out.iridescence_nm = x[5];
  return out;
}

}  // namespace

LinearRgb layered_diffuse(const ExportSurface& s) {
  // The F0 that goes with a total is below 0.05, so that the divisor is far from 0.
  return s.total ? scaled(s.diffuse, 1 / (1 - largest(s.f0))) : s.diffuse;
}

OpenPbrValues open_pbr_values(const ExportSurface& s, Fit fit, Changes& changes) {
  if (s.coat) return coated_open_pbr(s, fit, changes);
  if (s.film) return filmed_open_pbr(s, fit, changes);
  OpenPbrValues out;
  out.specular_roughness = s.gloss.roughness();
  out.geometry_opacity = s.opacity;
  if (s.kind == SurfaceKind::metal) {
    out.base_metalness = 1;
    out.base_color = fitted(s.f0, {fit, 1, s.space}, "base_color", "base_color ends at 1", changes);
    out.specular_color = fitted(tint82(s, out.base_color), {Fit::clamp, 1, s.space}, "specular_color",
                                "the edge tint ends at 1", changes);
    return out;
  }
  out.base_color = layered_diffuse(s);
  if (s.clear) {
    out.transmission_weight = 1;
    out.transmission_depth = s.clear->depth_m;
    out.transmission_color = fitted(s.clear->color, {fit, 1, s.space}, "transmission_color",
                                    "transmission_color is 0 to 1", changes);
  }
  const LinearRgb f0 = fitted(s.f0, {fit, largest_dielectric_f0, s.space}, "F0",
                              "the index of a dielectric has to be finite", changes);
  const double most = largest(f0), y = luminance(f0, s.space);
  // Errors averaged over a sphere seen from far away, where the mean of (1 - c)^5 is 1/21: the luminance
  // gives a wrong F0, the tint a wrong rim.
  double by_luminance = 0, by_tint = 0;
  for (const double channel : vec(f0)) {
    by_luminance += std::abs(channel - y) * 20 / 21;
    if (most > 0) by_tint += (1 - channel / most) / 21;
  }
  // The index of a clear body also decides how light is bent; that of the luminance is the best one for it.
  if (!s.clear && by_tint < by_luminance) {
    out.specular_ior = ior_of_f0(most);
    out.specular_color = scaled(f0, 1 / most);
    note_change(changes, "F90", {1, 1, 1}, list(out.specular_color), "tint",
                "the colour of a dielectric also tints its rim");
  } else {
    out.specular_ior = ior_of_f0(y);
    note_change(changes, "F0", list(f0), list(grey(y)), "luminance", "specular_ior is one number");
  }
  return out;
}

GltfMaterialValues gltf_values(const ExportSurface& s, bool specular_glossiness, Fit fit, Changes& changes) {
  if (s.coat && specular_glossiness) return gltf_values(as_whole(s), true, fit, changes);
  if (s.coat) {
    note_fixed_coat(*s.coat, changes);
    GltfMaterialValues out = gltf_values(under_coat(s, {}), false, fit, changes);
    out.clearcoat = 1;
    return out;
  }
  if (s.film && !specular_glossiness) return filmed_gltf(s, fit, changes);
  GltfMaterialValues out;
  out.specular_glossiness = specular_glossiness;
  out.roughness = s.gloss.roughness();
  out.glossiness = 1 - out.roughness;
  out.opacity = s.opacity;
  const auto edge = [&](const LinearRgb& f0) {
    if (s.f82)
      note_change(changes, "F82", list(*s.f82), list(schlick82(f0)), "schlick",
                  "no edge colour: the edge follows from F0 alone");
  };
  if (s.kind == SurfaceKind::metal && !specular_glossiness) {
    out.metallic = 1;
    out.base_color = fitted(s.f0, {fit, 1, s.space}, "baseColorFactor", "baseColorFactor ends at 1", changes);
    edge(out.base_color);
    return out;
  }
  const LinearRgb f0 = specular_glossiness ? fitted(s.f0, {fit, 1, s.space}, "specularFactor",
                                                    "specularFactor ends at 1", changes)
                                           : fitted(s.f0, {fit, largest_dielectric_f0, s.space}, "F0",
                                                    "the index of a dielectric has to be finite", changes);
  const double most = largest(f0);
  const char* const field = specular_glossiness ? "diffuseFactor" : "baseColorFactor";
  const LinearRgb body = most < 1 ? scaled(s.diffuse, 1 / (1 - most)) : LinearRgb{};
  if (most >= 1)
    note_change(changes, field, list(s.diffuse), {0, 0, 0}, "fixed", "an F0 of 1 leaves no light for it");
  out.base_color = fitted(body, {fit, 1, s.space}, field,
                          std::string(field) + " ends at 1; the largest F0 is taken off it", changes);
  if (s.clear && !specular_glossiness) {
    out.base_color = {1, 1, 1};
    out.transmission = 1;
    out.volume = *s.clear;
    if (s.clear->v_d) out.dispersion = 20 / *s.clear->v_d;
    out.volume->color =
        fitted(s.clear->color, {fit, 1, s.space}, "attenuationColor", "attenuationColor is 0 to 1", changes);
  }
  if (specular_glossiness) {
    out.specular_color = f0;
  } else {
    out.ior = s.ior.value_or(ior_of_f0(most));
    const double reflected = s.ior ? f64::f0(*s.ior, 0) : most;
    if (reflected > 0 && (s.ior || smallest(f0) < most)) out.specular_color = scaled(f0, 1 / reflected);
  }
  edge(f0);
  return out;
}

}  // namespace etak
