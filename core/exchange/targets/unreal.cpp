// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/targets/target.h"

namespace etak {
namespace {

void write_unreal(const TargetJob& j) {
  const LinearRgb base = j.metal() ? j.fit_f0("Base Color", "Base Color ends at 1") : j.s.diffuse;
  j.add("Base Color", base, unreal_text);
  j.add("Metallic", j.metal() ? 1 : 0);
  if (j.metal()) {
    j.add("Specular", 0.5);
    j.note("Specular has no effect on a metal");
    j.schlick_edge(base);
    j.shows_schlick(base, std::min(50 * base.g, 1.0));
  } else {
    const double wanted = j.one_f0("Specular is one number") / 0.08;
    const double specular =
        fitted(wanted, 0, 1, "Specular", "Specular ends at 1, an F0 of 0.08", j.out.changes);
    j.add("Specular", specular);
    if (specular * 0.08 < 0.02)
      j.note("an F0 below 0.02 is taken as shadow: the rim fades with 50 F0");
    else
      j.schlick_edge(grey(specular * 0.08));
    j.shows_schlick(grey(specular * 0.08), std::min(50 * specular * 0.08, 1.0));
  }
  j.add("Roughness", j.roughness());
  if (j.clear()) {
    j.add("Refraction (Index of Refraction)", j.index());
    j.note(
        "the body is clear: Blend Mode Translucent, Lighting Mode Surface ForwardShading, Refraction Method Index of Refraction; Opacity is left to you, because it fades the reflection too");
    j.note_absorption("no field of the material takes it");
  }
  j.opacity("Opacity");
}

}  // namespace

constinit const TargetRow target_unreal{{.id = "unreal",
                                         .title = "Unreal Engine",
                                         .version = "4.0 to 5.5, Default Lit",
                                         .formula = "F_Schlick of BRDF.ush: F90 = saturate(50 F0.g)"},
                                        write_unreal};

}  // namespace etak
