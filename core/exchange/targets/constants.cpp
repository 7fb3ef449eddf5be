// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/targets/target.h"

namespace etak {
namespace {

// Constants of a language, which writes colours by `text`.
void write_constants(const TargetJob& j, std::string (*text)(const LinearRgb&)) {
  j.add("f0", j.s.f0, text);
  if (j.s.f82) j.add("f82", *j.s.f82, text);
  if (!j.black_body()) j.add("diffuse", j.s.diffuse, text);
  if (j.s.emission != LinearRgb{}) j.add("emission", j.s.emission, text);
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

// Each field as a declaration, of which `color` and `number` begin and `end` ends with the value.
std::string declarations(const EngineValues& values, const char* color, const char* color_end,
                         const char* number, const char* end) {
  std::string out;
  for (const EngineField& field : values.fields) {
    const bool three = field.values.size() == 3;
    out += (three ? color : number) + field.name + (three ? color_end : "") + " = " + field.text +
           (three ? "" : end) + ";\n";
  }
  return out;
}

void write_glsl(const TargetJob& j) {
  write_constants(j, glsl_text);
}
std::string glsl_body(const ExportSurface&, const EngineValues& values) {
  return declarations(values, "const vec3 ", "", "const float ", "");
}
void write_hlsl(const TargetJob& j) {
  write_constants(j, hlsl_text);
}
std::string hlsl_body(const ExportSurface&, const EngineValues& values) {
  return declarations(values, "static const float3 ", "", "static const float ", "");
}
void write_c(const TargetJob& j) {
  write_constants(j, c_text);
}
std::string c_body(const ExportSurface&, const EngineValues& values) {
  return declarations(values, "static const float ", "[3]", "static const float ", "f");
}

}  // namespace

constinit const TargetRow target_glsl{
    {.id = "glsl", .title = "GLSL", .version = "3.30", .unstated = own_formula, .comment = "// "},
    write_glsl,
    glsl_body};
constinit const TargetRow target_hlsl{
    {.id = "hlsl", .title = "HLSL", .version = "5.0", .unstated = own_formula, .comment = "// "},
    write_hlsl,
    hlsl_body};
constinit const TargetRow target_c{
    {.id = "c", .title = "C", .version = "C89", .unstated = own_formula, .comment = "// "}, write_c, c_body};

}  // namespace etak
