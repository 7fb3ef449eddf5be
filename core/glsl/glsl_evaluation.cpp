// SPDX-License-Identifier: Apache-2.0
// Shaders that evaluate a model or an expression on the GPU, to compare it with the CPU.
#include <utility>

#include "core/glsl/glsl_glue.h"
#include "core/glsl/glsl_model.h"
#include "core/glsl/glsl_source.h"
#include "core/glsl/glsl_text.h"

namespace etak {

GlslText glsl_evaluation_text(const Model& model, const std::vector<double>& values, GlslVersion version) {
  GlslGlue glue;
  const std::string call = model_call(glue, {"model", model, values});
  glue.line("uniform sampler2D to_light, to_viewer;\nout vec4 value;\n");
  glue.line("void main() {\n  ivec2 at = ivec2(gl_FragCoord.xy);");
  glue.line("  Angles a = angles(texelFetch(to_light, at, 0).xyz, texelFetch(to_viewer, at, 0).xyz);");
  glue.line("  value = vec4(a.valid <= 0.0 ? vec3(0.0) : " + call + ", 1.0);\n}");
  return std::move(glue).finish(version);
}

GlslText glsl_expression_text(std::string_view expression, GlslVersion version) {
  // Numbers are multiplied by a uniform of value 1, because an expression of constants would be computed by
  // the compiler and not by the GPU.
  std::string code(expression);
  for (std::size_t at = 0; (at = code.find("real(", at)) != code.npos; at += 6) code.replace(at, 4, "given");
  GlslGlue glue;
  glue.uniform("one", 1);
  glue.line("out vec4 value;\nfloat given(float x) {\n  return x * one;\n}");
  glue.line("void main() {\n  value = vec4(" + real_literals(code) + ");\n}");
  return std::move(glue).finish(version);
}

}  // namespace etak
