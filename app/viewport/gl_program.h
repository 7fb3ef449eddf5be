// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLShaderProgram>
#include <map>
#include <string>

#include "core/glsl/glsl_text.h"

namespace etak {

using Gl = QOpenGLFunctions_3_3_Core;

/// The functions of the current context. Throws Error where the context is older than OpenGL 3.3.
Gl& current_gl();
/// Names of the renderer and of the OpenGL version, as the driver gives them.
std::string renderer_name(Gl& gl);

/// A linked pair of shaders.
class GlProgram {
 public:
  /// Throws Error with the driver's message.
  explicit GlProgram(const GlslText& text);

  void use() { program_.bind(); }
  void set(const GlslUniform& uniform);
  void set_sampler(const std::string& name, int unit);

  double compile_ms = 0;  // time of compiling, linking and the first drawing
  bool drawn = false;

 private:
  int place(const std::string& name);

  QOpenGLShaderProgram program_;
  std::map<std::string, int> places_;
};

}  // namespace etak
