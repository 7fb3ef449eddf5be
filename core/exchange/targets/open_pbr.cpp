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

}  // namespace

constinit const TargetRow target_open_pbr{
    {"openpbr", "OpenPBR 1.1", true, "openpbr-metal", "openpbr-dielectric"}, write_open_pbr};

}  // namespace etak
