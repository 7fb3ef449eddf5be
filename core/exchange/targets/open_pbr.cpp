// SPDX-License-Identifier: Apache-2.0
#include <type_traits>

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
  open_pbr_layers(v, [&](const char* name, const auto& value) {
    if constexpr (std::is_same_v<decltype(value), const double&>)
      j.add(name, value);
    else
      j.add(name, value, plain_text);
  });
  j.opacity("geometry_opacity");
}

// The same fields. A film's numbers are those for Adobe's openpbr-bsdf, which draws them in its own way.
void write_open_pbr_adobe(const TargetJob& j) {
  ExportSurface surface = j.s;
  if (surface.film) surface.film->adobe = true;
  write_open_pbr({surface, j.fit, j.out});
}

}  // namespace

constinit const TargetRow target_open_pbr{
    {"openpbr", "OpenPBR 1.1", true, "openpbr-metal", "openpbr-dielectric"}, write_open_pbr};
constinit const TargetRow target_open_pbr_adobe{{"openpbr-adobe", "OpenPBR 1.1 in Adobe's openpbr-bsdf", true,
                                                 "openpbr-adobe-metal", "openpbr-adobe-dielectric"},
                                                write_open_pbr_adobe};

}  // namespace etak
