// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSize>

#include "app/viewport/gl_program.h"
#include "core/color/ocio.h"
#include "core/image/image.h"

namespace etak {

/// A texture of floats.
class GlTexture {
 public:
  GlTexture(Gl& gl, const Image& map,
            bool round);  // round: the first column follows the last; rows are clamped
  GlTexture(Gl& gl, const OcioShader::Table& table);
  ~GlTexture();
  GlTexture(const GlTexture&) = delete;
  GlTexture& operator=(const GlTexture&) = delete;

  void bind(int unit);

 private:
  void filter(GLint how);
  void clamp(GLenum axis);

  Gl& gl_;
  GLenum kind_;
  GLuint id_ = 0;
};

/// A frame buffer with a texture of 8-bit codes to draw into. Contexts that share can use the texture, but
/// not the frame buffer.
class GlTarget {
 public:
  /// Throws Error where the driver cannot draw into a picture of this size.
  GlTarget(Gl& gl, const QSize& size);
  ~GlTarget();
  GlTarget(const GlTarget&) = delete;
  GlTarget& operator=(const GlTarget&) = delete;

  GLuint frame() const { return frame_; }
  GLuint texture() const { return texture_; }
  const QSize& size() const { return size_; }

 private:
  void remove();

  Gl& gl_;
  QSize size_;
  GLuint frame_ = 0, texture_ = 0;
};

}  // namespace etak
