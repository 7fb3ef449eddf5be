// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/targets/target.h"
#include "core/fresnel/fresnel.h"

namespace etak {
namespace {

void write_blender(const TargetJob& j) {
  if (j.metal()) {
    const LinearRgb f0 = j.fit_f0("Base Color", "Base Color of a metal ends at 1");
    j.add("Base Color", f0, blender_text);
    j.add("Metallic", 1);
    const LinearRgb tint = fitted(tint82(j.s, f0), Fit::clamp, 1, j.s.space, "Specular Tint",
                                  "the edge tint ends at 1", j.out.changes);
    j.add("Specular Tint", tint, blender_text);
  } else {
    const LinearRgb f0 = fitted(j.s.f0, j.fit, largest_dielectric_f0, j.s.space, "F0",
                                "the index of a dielectric has to be finite", j.out.changes);
    const double most = largest(f0);
    j.add("Base Color", j.clear() ? grey(1) : j.layered_body(), blender_text);
    j.add("Metallic", 0);
    j.add("IOR", ior_of_f0(most));
    j.add("IOR Level", 0.5);
    j.add("Specular Tint", most > 0 ? scaled(f0, 1 / most) : grey(1), blender_text);
    if (j.clear() && f0 != grey(most))
      j.note("IOR is that of the channel that reflects most, and Specular Tint lowers the others: " +
             j.index_text() + " by luminance");
  }
  j.add("Roughness", j.roughness());
  if (j.clear()) {
    j.add("Transmission Weight", 1);
    j.note_absorption("a Volume Absorption node beside the shader takes it");
  }
  j.opacity("Alpha");
}

}  // namespace

constinit const TargetRow target_blender{{"blender", "Blender 4 Principled BSDF"}, write_blender};

}  // namespace etak
