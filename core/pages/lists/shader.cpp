// SPDX-License-Identifier: Apache-2.0
#include "core/base/json/json_text.h"
#include "core/base/number.h"
#include "core/glsl/glsl_text.h"
#include "core/glsl/shader_function.h"
#include "core/pages/lists/lists.h"

namespace etak {
namespace {

std::string feature_lines(const GlslText& text, bool in) {
  std::vector<std::string> items;
  for (const GlslFeature& each : text.features)
    if (each.in == in)
      items.push_back(
          json_object({{"name", json(each.name)}, {in ? "what" : "reason", json(each.reason)}}, -1));
  return json_lines(items, 2);
}

std::string uniform_object(const GlslUniform& uniform) {
  std::vector<JsonMember> members{
      {"name", json(uniform.name)},
      {"type", json(uniform.width == 1 ? "float" : "vec" + std::to_string(uniform.width))}};
  if (uniform.array) members.push_back({"count", std::to_string(uniform.count)});
  const auto nine_digits = [](float value) { return number(double{value}, 9); };
  members.push_back({"values", '[' + joined(uniform.values, ", ", nine_digits) + ']'});
  return json_object(members, -1);
}

}  // namespace

std::string annotated_fragment(const GlslText& text) {
  const std::size_t first_line = text.fragment.find('\n') + 1;
  std::string out = text.fragment.substr(0, first_line);
  for (const bool in : {true, false})
    for (const GlslFeature& each : text.features)
      if (each.in == in)
        append(out, in ? "// in:       " : "// left out: ", each.name, ": ", each.reason, '\n');
  return out + text.fragment.substr(first_line);
}

std::string shader_json(const GlslText& text, GlslVersion version, const std::vector<std::string>& remarks) {
  return json_document("etak-shader/1", {{"version", json(name(version))},
                                         {"in", feature_lines(text, true)},
                                         {"left_out", feature_lines(text, false)},
                                         {"remarks", json_array_of(remarks)},
                                         {"uniforms", json_lines_of(text.uniforms, 2, uniform_object)},
                                         {"vertex", json(text.vertex)},
                                         {"fragment", json(text.fragment)}});
}

std::string shader_function_json(const std::string& text, ShaderLanguage language,
                                 const std::vector<std::string>& remarks) {
  return json_document(
      "etak-shader/1",
      {{"version", json(name(language))}, {"remarks", json_array_of(remarks)}, {"function", json(text)}});
}

}  // namespace etak
