// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/viewport/gl_program.h"
#include "core/color/ocio.h"
#include "core/image/image.h"

namespace etak {

/// A float texture; bound to a unit when asked.
class GlTexture {
 public:
  GlTexture(Gl& gl, const Image& map, bool round);  // round: columns go around; rows never
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

}  // namespace etak
