// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/export_coat.h"
#include "core/exchange/targets/target.h"
#include "core/fresnel/fresnel.h"

namespace etak {
namespace {

void write_principled(const TargetJob& j) {
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
    const double ior = j.s.ior.value_or(ior_of_f0(most)), reflected = j.s.ior ? f64::f0(ior, 0) : most;
    j.add("IOR", ior);
    j.add("IOR Level", 0.5);
    const LinearRgb tint = reflected > 0 ? scaled(f0, 1 / reflected) : grey(1);
    j.add("Specular Tint",
          fitted(tint, j.fit, 1, j.s.space, "Specular Tint", "Specular Tint ends at 1", j.out.changes),
          blender_text);
    if (j.clear() && !j.s.ior && f0 != grey(most))
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

void write_blender(const TargetJob& j) {
  if (!j.s.coat) return write_principled(j);
  const ExportCoat& coat = *j.s.coat;
  const ExportSurface base = under_coat(j.s, target_coat(coat, true));
  write_principled({base, j.fit, j.out});
  j.add("Coat Weight", 1);
  j.add("Coat Roughness", 0);
  j.add("Coat IOR", coat.n);
  j.add("Coat Tint",
        fitted(coat.passes, j.fit, 1, j.s.space, "Coat Tint", "Coat Tint is 0 to 1", j.out.changes),
        blender_text);
}

}  // namespace

constinit const TargetRow target_blender{{"blender", "Blender 4 Principled BSDF", true}, write_blender};

}  // namespace etak
