// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/targets/target.h"

namespace etak {
namespace {

void unity_alpha(const TargetJob& j) {
  if (!j.clear()) return j.opacity("Alpha");
  j.add("Alpha", j.s.opacity < 1 ? j.s.opacity : 0);
  j.note(
      "the body is clear: Rendering Mode Transparent, which keeps the reflection where Alpha is 0; it does not refract (" +
      j.index_text() + ")");
  j.note_absorption("no field of the material takes it");
}

void write_unity_metallic(const TargetJob& j) {
  constexpr double dielectric = 0.04;
  LinearRgb albedo = j.s.diffuse;
  if (j.metal()) {
    albedo = j.fit_f0("Albedo", "Albedo ends at 1");
    j.schlick_edge(albedo);
    j.shows_schlick(albedo);
  } else {
    note_change(j.out.changes, "F0", list(j.s.f0), list(grey(dielectric)), "fixed",
                "the metallic setup has one F0 for all dielectrics");
    j.shows_schlick(grey(dielectric));
    // What is to come out of a measured total does not depend on the F0 that was wanted.
    const LinearRgb body =
        j.s.total ? LinearRgb{j.s.total->r - dielectric, j.s.total->g - dielectric, j.s.total->b - dielectric}
                  : j.s.diffuse;
    albedo = fitted(scaled(body, 1 / (1 - dielectric)), {j.fit, 1, j.s.space}, "Albedo",
                    "Albedo is 0 to 1; 0.04 of the light is taken off it", j.out.changes);
  }
  j.add("Albedo", albedo, hex_text);
  j.add("Metallic", j.metal() ? 1 : 0);
  j.add("Smoothness", 1 - j.roughness());
  unity_alpha(j);
}

void write_unity_specular(const TargetJob& j) {
  const LinearRgb f0 = j.fit_f0("Specular", "Specular ends at 1");
  const double left = 1 - largest(f0);
  LinearRgb albedo{0, 0, 0};
  if (!j.black_body() && left > 0) albedo = scaled(j.s.diffuse, 1 / left);
  albedo = fitted(albedo, {j.fit, 1, j.s.space}, "Albedo",
                  "Albedo ends at 1; the largest of Specular is taken off it", j.out.changes);
  j.add("Albedo", albedo, hex_text);
  j.add("Specular", f0, hex_text);
  j.add("Smoothness", 1 - j.roughness());
  j.schlick_edge(f0);
  j.shows_schlick(f0);
  unity_alpha(j);
}

}  // namespace

namespace {
constexpr std::string_view standard = "5.0 to 2022.3, Standard of the built-in pipeline";
constexpr std::string_view standard_fresnel = "FresnelTerm of UnityStandardBRDF.cginc";
}  // namespace

constinit const TargetRow target_unity_metallic{{.id = "unity-metallic",
                                                 .title = "Unity, metallic setup",
                                                 .version = standard,
                                                 .formula = standard_fresnel},
                                                write_unity_metallic};
constinit const TargetRow target_unity_specular{{.id = "unity-specular",
                                                 .title = "Unity, specular setup",
                                                 .version = standard,
                                                 .formula = standard_fresnel},
                                                write_unity_specular};

}  // namespace etak
