// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/targets/target.h"

namespace etak {
namespace {

void write_glsl(const TargetJob& j) {
  j.add("f0", j.s.f0, glsl_text);
  if (j.s.f82) j.add("f82", *j.s.f82, glsl_text);
  if (!j.black_body()) j.add("diffuse", j.s.diffuse, glsl_text);
  for (const auto& [field, value] :
       {std::pair<const char*, double>{"gloss", j.s.gloss}, {"alpha", j.s.gloss.alpha()}})
    j.add(field, {value}, real_text(value));
  if (j.s.gloss.held())
    note_change(j.out.changes, "roughness", {j.roughness()}, {roughness_of_gloss(j.s.gloss)}, "clamp",
                "Schueler's gloss ends there; alpha has the roughness that was given");
  j.note_no_transmission("is the shader's to draw");
  j.note_absorption("the shader's to apply");
  if (j.s.opacity < 1) j.add("opacity", {j.s.opacity}, real_text(j.s.opacity));
}

}  // namespace

constinit const TargetRow target_glsl{{"glsl", "GLSL"}, write_glsl};

}  // namespace etak
