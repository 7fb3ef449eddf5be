// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/exchange/targets/target.h"
#include "core/math/functions.h"

namespace etak {
namespace {

// Of Beer and Lambert, in 1/m: what turns white light into `color` over `depth_m`.
LinearRgb absorption_of(const ClearBody& body) {
  // Against the infinity of a channel that nothing passes, or that is out of gamut.
  constexpr double darkest = 1e-6;
  const auto channel = [&](double c) {
    return std::max(0.0, -math::log(std::max(c, darkest)) / body.depth_m);
  };
  return {channel(body.color.r), channel(body.color.g), channel(body.color.b)};
}

// Filament's fit of what an F0 in air becomes under a coat of index 1.5, for f0ClearCoatToSurface() of its shaders, which
// clamp it to [0, 1] and take every base under clearCoat through it.
double filament_under_coat(double f0) {
  return f0 * (f0 * (0.941892 - 0.263008 * f0) + 0.346479) - 0.0285998;
}

// The F0 in air that it turns into `under`, in [0, 1]. The fit rises there all the way.
double filament_in_air(double under) {
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (filament_under_coat(middle) < under ? low : high) = middle;
  }
  return high;
}

// A metal's F0, and the one to be given for it under a coat.
void write_metal(const TargetJob& j, bool coated) {
  LinearRgb base = j.fit_f0("baseColor", "baseColor ends at 1");
  if (coated) {
    base = fitted(base, {j.fit, filament_under_coat(1), j.s.space}, "baseColor",
                  "no F0 in air has more under Filament's coat", j.out.changes);
    j.add("baseColor", to_rgb({filament_in_air(base.r), filament_in_air(base.g), filament_in_air(base.b)}),
          plain_text);
  } else {
    j.add("baseColor", base, plain_text);
  }
  j.add("metallic", 1);
  j.note("reflectance has no effect on a metal");
  j.schlick_edge(base);
  j.shows_schlick(base, faded_f90(base));
}

void write_dielectric(const TargetJob& j, bool coated) {
  j.add("baseColor", j.clear() ? grey(1) : j.s.diffuse, plain_text);
  j.add("metallic", 0);
  const double f0 = std::max(j.one_f0("reflectance is one number"), 0.0);
  const double wanted = std::sqrt((coated ? filament_in_air(f0) : f0) / 0.16);
  const double reflectance =
      fitted(wanted, 0, 1, "reflectance", "reflectance ends at 1, an F0 of 0.16", j.out.changes);
  j.add("reflectance", reflectance);
  const double given = 0.16 * reflectance * reflectance;
  const double seen = coated ? std::max(filament_under_coat(given), 0.0) : given;
  if (seen < 0.02)
    j.note("an F0 below 0.02 is taken as shadow: the rim fades with 50 F0");
  else
    j.schlick_edge(grey(seen));
  j.shows_schlick(grey(seen), faded_f90(grey(seen)));
}

void write_filament(const TargetJob& job) {
  const bool coated = job.s.coat.has_value();
  const ExportSurface base = under_coat(job.s, {});
  const TargetJob j{base, job.fit, job.out, job.below({}).coat};
  j.metal() ? write_metal(j, coated) : write_dielectric(j, coated);
  j.add("roughness", j.roughness());
  if (coated) {
    j.add("clearCoat", 1);
    j.add("clearCoatRoughness", 0);
    j.note("clearCoatIorChange has to be true, as it is where nothing is said");
    note_fixed_coat(*job.s.coat, j.out.changes);
  }
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

constinit const TargetRow target_filament{
    {.id = "filament",
     .title = "Filament",
     .version = "1.50",
     .formula = "fresnel() of surface_brdf.fs: F90 = saturate(50 F0); clearCoatLobe()",
     .has_coat = true},
    write_filament};

}  // namespace etak
