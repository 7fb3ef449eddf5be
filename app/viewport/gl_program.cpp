// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/gl_program.h"

#include <QOpenGLContext>
#include <QOpenGLVersionFunctionsFactory>
#include <algorithm>

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

GlProgram::GlProgram(Gl& gl, const GlslText& text) : gl_(gl), id_(gl.glCreateProgram()) {
  try {
    attach(GL_VERTEX_SHADER, text.vertex);
    attach(GL_FRAGMENT_SHADER, text.fragment);
    gl_.glLinkProgram(id_);
    GLint linked = 0, length = 0;
    gl_.glGetProgramiv(id_, GL_LINK_STATUS, &linked);
    if (linked != 0) return;
    gl_.glGetProgramiv(id_, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    gl_.glGetProgramInfoLog(id_, length, nullptr, log.data());
    throw Error::at("shader", log.c_str());
  } catch (...) {
    gl_.glDeleteProgram(id_);
    throw;
  }
}

GlProgram::~GlProgram() {
  gl_.glDeleteProgram(id_);
}

void GlProgram::attach(GLenum kind, const std::string& text) {
  const GLuint shader = gl_.glCreateShader(kind);
  const char* source = text.c_str();
  gl_.glShaderSource(shader, 1, &source, nullptr);
  gl_.glCompileShader(shader);
  GLint compiled = 0, length = 0;
  gl_.glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  gl_.glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
  if (compiled == 0) gl_.glGetShaderInfoLog(shader, length, nullptr, log.data());
  gl_.glAttachShader(id_, shader);
  gl_.glDeleteShader(shader);
  if (compiled == 0) throw Error::at("shader", log.c_str());
}

void GlProgram::use() {
  gl_.glUseProgram(id_);
}

GLint GlProgram::place(const std::string& name) {
  const auto [found, is_new] = places_.try_emplace(name, -1);
  if (is_new) found->second = gl_.glGetUniformLocation(id_, name.c_str());
  return found->second;
}

void GlProgram::set(const GlslUniform& uniform) {
  const GLint at = place(uniform.name);
  if (at < 0) return;  // the driver removed the uniform, because the program does not use it
  switch (uniform.width) {
    case 1:
      return gl_.glUniform1fv(at, uniform.count, uniform.values.data());
    case 2:
      return gl_.glUniform2fv(at, uniform.count, uniform.values.data());
    default:
      return gl_.glUniform3fv(at, uniform.count, uniform.values.data());
  }
}

void GlProgram::set_sampler(const std::string& name, int unit) {
  if (const GLint at = place(name); at >= 0) gl_.glUniform1i(at, unit);
}

}  // namespace etak
