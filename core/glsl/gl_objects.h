// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/glsl/glsl_text.h"
#include "core/image/image.h"

// Objects of the current OpenGL context, for gl_runner.cpp.

namespace etak::gl {

// The driver's messages, each with the line of the shader that it names ("0:12(5): error" or "0(12) : error")
// below it, so that a message can be understood without the shader.
inline std::string with_lines(const std::string& log, const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  std::string out;
  std::istringstream messages(log);
  for (std::string message; std::getline(messages, message);) {
    out += (out.empty() ? "" : "\n") + message;
    const std::size_t digits = message.find_first_of("0123456789", message.find_first_of(":(") + 1);
    if (message.find_first_of(":(") == std::string::npos || digits == std::string::npos) continue;
    const std::size_t number = std::strtoul(message.c_str() + digits, nullptr, 10);
    if (number >= 1 && number <= lines.size()) out += "\n  " + lines[number - 1];
  }
  return out;
}

// A linked program. The constructor throws Error with the driver's message.
class Program {
 public:
  Program(const std::string& vertex, const std::string& fragment) : id_(glCreateProgram()) {
    try {
      attach(GL_VERTEX_SHADER, vertex);
      attach(GL_FRAGMENT_SHADER, fragment);
      glLinkProgram(id_);
      GLint linked = 0, length = 0;
      glGetProgramiv(id_, GL_LINK_STATUS, &linked);
      if (linked) return;
      glGetProgramiv(id_, GL_INFO_LOG_LENGTH, &length);
      std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
      glGetProgramInfoLog(id_, length, nullptr, log.data());
      throw Error::at("shader", log.c_str());
    } catch (...) {
      glDeleteProgram(id_);
      throw;
    }
  }
  ~Program() { glDeleteProgram(id_); }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  GLuint id() const { return id_; }

  void set(const GlslUniform& uniform) const {
    const GLint at = glGetUniformLocation(id_, uniform.name.c_str());
    if (at < 0) return;  // the driver has removed it, because nothing uses it
    const float* values = uniform.values.data();
    switch (uniform.width) {
      case 1:
        glUniform1fv(at, uniform.count, values);
        break;
      case 2:
        glUniform2fv(at, uniform.count, values);
        break;
      default:
        glUniform3fv(at, uniform.count, values);
        break;
    }
  }
  void set_sampler(const char* name, GLint unit) const { glUniform1i(glGetUniformLocation(id_, name), unit); }

 private:
  void attach(GLenum kind, const std::string& text) const {
    const GLuint shader = glCreateShader(kind);
    const char* source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint compiled = 0, length = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    if (!compiled) glGetShaderInfoLog(shader, length, nullptr, log.data());
    glAttachShader(id_, shader);
    glDeleteShader(shader);
    if (!compiled) throw Error::at("shader", with_lines(log.c_str(), text));
  }

  GLuint id_;
};

// A framebuffer with one texture, which is bound while the value lives.
class Target {
 public:
  Target(GLenum format, int width, int height) {
    glGenFramebuffers(1, &frame_);
    glGenTextures(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
    glBindFramebuffer(GL_FRAMEBUFFER, frame_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
      remove();
      throw Error::at("OpenGL", "cannot draw into a target of " + std::to_string(width) + " x " +
                                    std::to_string(height) + " pixels");
    }
    glViewport(0, 0, width, height);
  }
  ~Target() { remove(); }
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;

 private:
  void remove() {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &frame_);
    glDeleteTextures(1, &texture_);
  }
  GLuint frame_ = 0, texture_ = 0;
};

// Texels in memory, as OpenGL is told of them.
struct TexelArray {
  int width, height;
  GLenum channels, type;
  const void* data;
};

// A texture on texture unit `unit`, without filtering.
class Texture {
 public:
  ///   inside   how OpenGL keeps the texels
  Texture(int unit, GLint inside, const TexelArray& texels) {
    glGenTextures(1, &id_);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, id_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, inside, texels.width, texels.height, 0, texels.channels, texels.type,
                 texels.data);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }
  ~Texture() { glDeleteTextures(1, &id_); }
  Texture(const Texture&) = delete;
  Texture& operator=(const Texture&) = delete;

 private:
  GLuint id_ = 0;
};

// Floats: a picture is filtered bilinearly; an array of numbers is read texel by texel.
class FloatTexture : public Texture {
 public:
  //   round   the first column follows the last; else the edges are repeated on all sides
  FloatTexture(int unit, const Image& map, bool round)
      : FloatTexture(unit, map.width, map.height, map.values, map.channels == 4 ? GL_RGBA : GL_RGB) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, round ? GL_REPEAT : GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
  // Drivers read texels of four floats faster than those of three.
  FloatTexture(int unit, int width, int height, const std::vector<float>& rgb, GLenum channels = GL_RGB)
      : Texture(unit, GL_RGBA32F, {width, height, channels, GL_FLOAT, rgb.data()}) {}
};

// 8-bit codes in four channels; the colours are sRGB-encoded.
class CodeTexture : public Texture {
 public:
  CodeTexture(int unit, const Image8& rgba, bool srgb = true)
      : Texture(unit, srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8,
                {rgba.width, rgba.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.values.data()}) {}
};

// Measures the time of drawing between start() and stop() by OpenGL's own clock, where it has one.
class GpuClock {
 public:
  GpuClock() {
    GLint bits = 0;
    glGetQueryiv(GL_TIME_ELAPSED, GL_QUERY_COUNTER_BITS, &bits);
    if (bits > 0) glGenQueries(1, &query_);
  }
  ~GpuClock() {
    if (query_ != 0) glDeleteQueries(1, &query_);
  }
  GpuClock(const GpuClock&) = delete;
  GpuClock& operator=(const GpuClock&) = delete;

  void start() const {
    if (query_ != 0) glBeginQuery(GL_TIME_ELAPSED, query_);
  }
  void stop() const {
    if (query_ != 0) glEndQuery(GL_TIME_ELAPSED);
  }
  /// The time between the last start() and stop(). Waits until OpenGL has finished drawing.
  std::optional<double> milliseconds() const {
    if (query_ == 0) return std::nullopt;
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(query_, GL_QUERY_RESULT, &nanoseconds);
    return static_cast<double>(nanoseconds) * 1e-6;
  }

 private:
  GLuint query_ = 0;
};

}  // namespace etak::gl
