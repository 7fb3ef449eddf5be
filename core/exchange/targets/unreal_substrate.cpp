// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/targets/target.h"
#include "core/math/functions.h"

namespace etak {
namespace {

// The F90 of each channel, in [0, 1], with which Schlick's curve comes nearest to the known edge.
LinearRgb nearest_f90(const TargetJob& j, const LinearRgb& f0) {
  if (!j.s.f82) return {1, 1, 1};
  const double weight = math::pow(1 - f82_cosine, 5);
  Vec3 f90{}, seen{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double head_on = vec(f0)[c];
    f90[c] = std::clamp(head_on + (vec(*j.s.f82)[c] - head_on) / weight, 0.0, 1.0);
    seen[c] = head_on + (f90[c] - head_on) * weight;
  }
  note_change(j.out.changes, "F82", list(*j.s.f82), {seen[0], seen[1], seen[2]}, "nearest",
              "no F90 from 0 to 1 gives this edge");
  return to_rgb(f90);
}

void write_substrate(const TargetJob& j) {
  const LinearRgb f0 = j.fit_f0("F0", "F0 ends at 1"), f90 = nearest_f90(j, f0);
  j.add("Diffuse Albedo", j.metal() ? LinearRgb{} : j.s.diffuse, unreal_text);
  j.add("F0", f0, unreal_text);
  j.add("F90", f90, unreal_text);
  j.add("Roughness", j.roughness());
  const double mean = (f0.r + f0.g + f0.b) / 3, fade = std::clamp(50 * mean, 0.0, 1.0);
  if (mean < 0.02) j.note("an F0 below 0.02 is taken as shadow: F90 fades with 50 F0");
  j.shows([&](double cosine) {
    Vec3 out = vec(f0);
    for (std::size_t c = 0; c < 3; ++c) out[c] += (fade * vec(f90)[c] - out[c]) * math::pow(1 - cosine, 5);
    return out;
  });
  j.note_no_transmission("SSS MFP and Blend Mode Translucent tell");
  j.note_absorption("SSS MFP in centimetres takes it");
  j.opacity("Coverage Weight");
}

}  // namespace

constinit const TargetRow target_unreal_substrate{
    {.id = "unreal-substrate",
     .title = "Unreal Engine, Substrate Slab",
     .version = "5.5",
     .formula = "Schlick from F0 to F90, which fades below an F0 of 0.02 (Substrate.ush)"},
    write_substrate};

}  // namespace etak
