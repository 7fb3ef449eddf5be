// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/targets/target.h"

namespace etak {
namespace {

void write_hdrp(const TargetJob& j) {
  LinearRgb f0 = j.fit_f0(j.metal() ? "Base Color" : "Specular Color", "colours of a material end at 1");
  if (j.metal()) {
    j.add("Base Color", f0, hex_text);
    j.add("Metallic", 1);
  } else {
    const double left = 1 - largest(f0);
    const LinearRgb body = left > 0 ? scaled(j.s.diffuse, 1 / left) : LinearRgb{};
    j.add("Base Color",
          fitted(body, {j.fit, 1, j.s.space}, "Base Color",
                 "Base Color ends at 1; the largest of Specular Color is taken off it", j.out.changes),
          hex_text);
    j.add("Specular Color", f0, hex_text);
    j.note("Material Type Specular Color, with Energy Conserving Specular");
  }
  j.add("Smoothness", 1 - j.roughness());
  j.schlick_edge(f0);
  // A refractive material keeps an edge of 1.
  j.shows_schlick(f0, j.clear() ? 1 : faded_f90(f0));
  if (j.clear()) {
    j.add("Index Of Refraction", j.index());
    j.note("the body is clear: Surface Type Transparent, Refraction Model Sphere or Box");
    j.note_absorption("Transmittance Color at Transmittance Absorption Distance takes it");
  }
  j.opacity("Alpha");
}

}  // namespace

constinit const TargetRow target_unity_hdrp{{.id = "unity-hdrp",
                                             .title = "Unity HDRP Lit",
                                             .version = "14 to 17",
                                             .formula = "F_Schlick with F90 = saturate(50 F0) (Lit.hlsl)"},
                                            write_hdrp};

}  // namespace etak
