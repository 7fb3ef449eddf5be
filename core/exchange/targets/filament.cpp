// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/exchange/targets/target.h"

namespace etak {
namespace {

// Of Beer and Lambert, in 1/m: what turns white light into `color` over `depth_m`.
LinearRgb absorption_of(const ClearBody& body) {
  // Against the infinity of a channel that nothing passes, or that is out of gamut.
  constexpr double darkest = 1e-6;
  const auto channel = [&](double c) {
    return std::max(0.0, -std::log(std::max(c, darkest)) / body.depth_m);
  };
  return {channel(body.color.r), channel(body.color.g), channel(body.color.b)};
}

void write_filament(const TargetJob& j) {
  const LinearRgb base = j.metal()   ? j.fit_f0("baseColor", "baseColor ends at 1")
                         : j.clear() ? grey(1)
                                     : j.s.diffuse;
  j.add("baseColor", base, plain_text);
  j.add("metallic", j.metal() ? 1 : 0);
  if (j.metal()) {
    j.note("reflectance has no effect on a metal");
    j.schlick_edge(base);
  } else {
    const double wanted = std::sqrt(std::max(j.one_f0("reflectance is one number"), 0.0) / 0.16);
    const double reflectance =
        fitted(wanted, 0, 1, "reflectance", "reflectance ends at 1, an F0 of 0.16", j.out.changes);
    j.add("reflectance", reflectance);
    if (0.16 * reflectance * reflectance < 0.02)
      j.note("an F0 below 0.02 is taken as shadow: the rim fades with 50 F0");
    else
      j.schlick_edge(grey(0.16 * reflectance * reflectance));
  }
  j.add("roughness", j.roughness());
  if (j.clear()) {
    j.add("transmission", 1);
    j.add("ior", j.index());
    if (j.s.clear->depth_m > 0) j.add("absorption", absorption_of(*j.s.clear), plain_text);
    j.note("the body is clear: the material has to be compiled with refractionMode screenspace or cubemap");
  }
  if (j.s.opacity < 1) {
    j.add("alpha", j.s.opacity);
    j.note("baseColor is to be multiplied by alpha before it is set");
  }
}

}  // namespace

constinit const TargetRow target_filament{{"filament", "Filament"}, write_filament};

}  // namespace etak
