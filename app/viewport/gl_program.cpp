// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/gl_program.h"

#include <QOpenGLContext>
#include <QOpenGLVersionFunctionsFactory>

#include "core/base/error.h"

namespace etak {

Gl& current_gl() {
  QOpenGLContext* context = QOpenGLContext::currentContext();
  Gl* gl = context == nullptr ? nullptr : QOpenGLVersionFunctionsFactory::get<Gl>(context);
  if (gl == nullptr || !gl->initializeOpenGLFunctions())
    throw Error::at("OpenGL", "the driver has no OpenGL 3.3 core", "one that has");
  return *gl;
}

std::string renderer_name(Gl& gl) {
  const auto text = [&](GLenum which) {
    const GLubyte* found = gl.glGetString(which);
    return found == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(found));
  };
  return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

GlProgram::GlProgram(const GlslText& text) {
  using Part = QOpenGLShader;
  if (!program_.addShaderFromSourceCode(Part::Vertex, text.vertex.c_str()) ||
      !program_.addShaderFromSourceCode(Part::Fragment, text.fragment.c_str()) || !program_.link())
    throw Error::at("shader", program_.log().toStdString());
}

int GlProgram::place(const std::string& name) {
  const auto [found, is_new] = places_.try_emplace(name, -1);
  if (is_new) found->second = program_.uniformLocation(name.c_str());
  return found->second;
}

void GlProgram::set(const GlslUniform& uniform) {
  // The driver removes uniforms that the program does not use.
  if (const int at = place(uniform.name); at >= 0)
    program_.setUniformValueArray(at, uniform.values.data(), uniform.count, uniform.width);
}

void GlProgram::set_sampler(const std::string& name, int unit) {
  if (const int at = place(name); at >= 0) program_.setUniformValue(at, unit);
}

}  // namespace etak
