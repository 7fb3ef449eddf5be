// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/number.h"
#include "core/glsl/glsl_source.h"
#include "core/glsl/glsl_text.h"

namespace etak {

inline std::string glsl_type_name(int width) {
  return width == 1 ? "float" : "vec" + std::to_string(width);
}

inline void append_floats(std::vector<float>& out, const Vec3& v) {
  for (const double x : v) out.push_back(static_cast<float>(x));
}

/// A number as a GLSL literal of type float.
inline std::string glsl_decimal(double value) {
  const std::string text = number(value, 9);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

/// Collects the part of a shader's text that is written for one scene (the glue), with its uniforms and
/// features, and puts the shader together.
class GlslGlue {
 public:
  GlslText text;

  void line(std::string_view code) { (body_ += code) += '\n'; }
  const std::string& code() const { return body_; }

  void use(std::string name, std::string detail) {
    text.features.push_back({std::move(name), true, std::move(detail)});
  }
  void leave_out(std::string name, std::string reason) {
    text.features.push_back({std::move(name), false, std::move(reason)});
  }

  void uniform(const std::string& name, double value) {
    add({name, 1, 1, false, {static_cast<float>(value)}});
  }
  void uniform(const std::string& name, const Vec3& value) { add({name, 3, 1, false, floats(value)}); }
  void uniform(const std::string& name, double x, double y) {
    add({name, 2, 1, false, {static_cast<float>(x), static_cast<float>(y)}});
  }
  // Declares a uniform that the caller sets.
  void declare(const std::string& type, const std::string& name) {
    declarations_ += "uniform " + type + ' ' + name + ";\n";
  }
  // Adds a uniform that the vertex shader declares.
  void vertex_uniform(GlslUniform uniform) { text.uniforms.push_back(std::move(uniform)); }
  void uniforms(const std::string& name, int width, const std::vector<float>& values) {
    add({name, width, static_cast<int>(values.size()) / width, true, values});
  }

  static std::vector<float> floats(const Vec3& v) {
    return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
  }

  void add(GlslUniform uniform) {
    declarations_ += "uniform " + glsl_type_name(uniform.width) + ' ' + uniform.name +
                     (uniform.array ? "[" + std::to_string(uniform.count) + "]" : "") + ";\n";
    text.uniforms.push_back(std::move(uniform));
  }

  // The text without the parts of a shader: what the code uses, the uniforms as constants with their values, the code.
  std::string function() && {
    std::string constants;
    for (const GlslUniform& each : text.uniforms) {
      constants +=
          "const " + glsl_type_name(each.width) + ' ' + each.name + " = " + glsl_type_name(each.width) + '(';
      for (std::size_t i = 0; i < each.values.size(); ++i)
        constants += (i > 0 ? ", " : "") + glsl_decimal(each.values[i]);
      constants += ");\n";
    }
    return glsl_needed_by(body_) + "// ---- this material\n" + constants + '\n' + body_;
  }

  GlslText finish(GlslVersion version) && {
    const std::string glue = declarations_ + '\n' + body_;
    const std::string head =
        "#version " + std::string(name(version)) + '\n' +
        (version == GlslVersion::es_300 ? "precision highp float;\nprecision highp int;\n"
                                          "precision highp sampler2D;\n"
                                        : "");
    if (text.vertex.empty())
      text.vertex = glsl_file(text.ring          ? "shaders/beside_object.vert"
                              : text.corners > 3 ? "shaders/around_object.vert"
                                                 : "shaders/full_screen.vert");
    text.vertex = head + text.vertex.substr(text.vertex.find('\n') + 1);
    text.fragment = head + "#define real float\n\n" + glsl_needed_by(glue) + "// ---- this scene\n" + glue;
    if (version == GlslVersion::vulkan_450)
      for (std::string* each : {&text.vertex, &text.fragment})
        *each = with_bindings(*each, each == &text.vertex);
    return std::move(text);
  }

 private:
  std::string declarations_, body_;
};

}  // namespace etak
