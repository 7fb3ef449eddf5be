// SPDX-License-Identifier: Apache-2.0
// Based on:
//   Khronos Group, KHR_materials_clearcoat: fresnel_coat(), with the index 1.5
//   Academy Software Foundation, MaterialX 1.39, the graph of open_pbr_surface; OpenPBR 1.1, "Coat"
//   Blender 4.2, the Principled BSDF of Cycles
#include "core/exchange/export_coat.h"

#include <algorithm>
#include <cmath>

#include "core/exchange/color_parts.h"
#include "core/exchange/engine_values.h"
#include "core/fresnel/fresnel.h"
#include "core/math/functions.h"

namespace etak {
namespace {

// What the base has to reflect so that the whole is seen. Where nothing passes, nothing is seen of a base.
LinearRgb base_part(const LinearRgb& whole, const TargetCoat& coat, double cosine) {
  const Vec3 passes = coat.lets_pass(cosine);
  const double own = coat.reflects(cosine);
  Vec3 out{};
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = (vec(whole)[c] - own) / (std::max(passes[c], 1e-9) * (1 - own));
  return to_rgb(out);
}

ExportSurface without_coat(const ExportSurface& surface, const LinearRgb& f0, const LinearRgb& f82) {
  ExportSurface out = surface;
  out.ior = ior_of_f0(std::clamp(luminance(surface.f0, surface.space), 0.0, largest_dielectric_f0));
  out.f0 = f0;
  out.f82 = f82;
  out.coat.reset();
  out.spectrum.clear();
  return out;
}

}  // namespace

double TargetCoat::reflects(double cosine) const {
  constexpr double f0 = 0.04;
  if (n > 0) return f64::fresnel_exact(n, 0, cosine);
  return curve == nullptr ? f64::f_schlick(f0, cosine) : f0 + (1 - f0) * curve(cosine);
}

Vec3 TargetCoat::lets_pass(double cosine) const {
  if (!longer_aslant) return vec(passes);
  // Of an index below 1 no light goes in at grazing angles.
  const double squared = std::max(1 - (1 - cosine * cosine) / (n * n), 1e-4);
  Vec3 out = vec(passes);
  for (double& channel : out) channel = math::pow(std::max(channel, 0.0), 1 / std::sqrt(squared));
  return out;
}

Vec3 TargetCoat::over(const Vec3& base, double cosine) const {
  Vec3 out = lets_pass(cosine);
  const double own = reflects(cosine);
  for (std::size_t c = 0; c < 3; ++c) out[c] = own + out[c] * (1 - own) * base[c];
  return out;
}

void note_fixed_coat(const CoatedF0& coat, Changes& changes) {
  note_change(changes, "F0 of the coat", {f64::f0(coat.n, 0)}, {TargetCoat{}.reflects(1)}, "fixed",
              "the coat has the index 1.5");
}

ExportSurface under_coat(const ExportSurface& surface, const TargetCoat& target) {
  if (!surface.coat) return surface;
  const F0Result& whole = surface.coat->whole;
  return without_coat(surface, base_part(whole.linear, target, 1),
                      base_part(whole.f82.value(), target, f82_cosine));
}

ExportSurface as_whole(const ExportSurface& surface) {
  if (!surface.coat) return surface;
  return without_coat(surface, surface.coat->whole.linear, surface.coat->whole.f82.value());
}

}  // namespace etak
