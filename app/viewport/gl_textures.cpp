// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/gl_textures.h"

#include "core/base/error.h"

namespace etak {

GlTexture::GlTexture(Gl& gl, const Image& map, bool round) : gl_(gl), kind_(GL_TEXTURE_2D) {
  gl_.glGenTextures(1, &id_);
  bind(0);
  const bool four = map.channels == 4;
  gl_.glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  // Drivers read texels of four floats faster than those of three.
  gl_.glTexImage2D(kind_, 0, GL_RGBA32F, map.width, map.height, 0, four ? GL_RGBA : GL_RGB, GL_FLOAT,
                   map.values.data());
  filter(GL_LINEAR);
  clamp(GL_TEXTURE_WRAP_T);
  if (round)
    gl_.glTexParameteri(kind_, GL_TEXTURE_WRAP_S, GL_REPEAT);
  else
    clamp(GL_TEXTURE_WRAP_S);
}

GlTexture::GlTexture(Gl& gl, const OcioShader::Table& table)
    : gl_(gl),
      kind_(table.depth > 0    ? GL_TEXTURE_3D
            : table.height > 0 ? GL_TEXTURE_2D
                               : GL_TEXTURE_1D) {
  gl_.glGenTextures(1, &id_);
  bind(0);
  const GLint inside = table.channels == 1 ? GL_R32F : GL_RGB32F;
  const GLenum format = table.channels == 1 ? GL_RED : GL_RGB;
  const float* values = table.values.data();
  gl_.glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  if (kind_ == GL_TEXTURE_3D)
    gl_.glTexImage3D(kind_, 0, inside, table.width, table.height, table.depth, 0, format, GL_FLOAT, values);
  else if (kind_ == GL_TEXTURE_2D)
    gl_.glTexImage2D(kind_, 0, inside, table.width, table.height, 0, format, GL_FLOAT, values);
  else
    gl_.glTexImage1D(kind_, 0, inside, table.width, 0, format, GL_FLOAT, values);
  filter(table.nearest ? GL_NEAREST : GL_LINEAR);
  for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) clamp(axis);
}

GlTexture::~GlTexture() {
  gl_.glDeleteTextures(1, &id_);
}

void GlTexture::bind(int unit) {
  gl_.glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl_.glBindTexture(kind_, id_);
}

void GlTexture::filter(GLint how) {
  gl_.glTexParameteri(kind_, GL_TEXTURE_MIN_FILTER, how);
  gl_.glTexParameteri(kind_, GL_TEXTURE_MAG_FILTER, how);
}

void GlTexture::clamp(GLenum axis) {
  gl_.glTexParameteri(kind_, axis, GL_CLAMP_TO_EDGE);
}

GlTarget::GlTarget(Gl& gl, const QSize& size) : gl_(gl), size_(size) {
  gl_.glGenTextures(1, &texture_);
  gl_.glBindTexture(GL_TEXTURE_2D, texture_);
  gl_.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.width(), size.height(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                   nullptr);
  gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  gl_.glGenFramebuffers(1, &frame_);
  gl_.glBindFramebuffer(GL_FRAMEBUFFER, frame_);
  gl_.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
  if (gl_.glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return;
  remove();
  throw Error::at("OpenGL", "cannot draw a picture of " + std::to_string(size.width()) + " x " +
                                std::to_string(size.height()) + " pixels");
}

GlTarget::~GlTarget() {
  remove();
}

void GlTarget::remove() {
  gl_.glDeleteFramebuffers(1, &frame_);
  gl_.glDeleteTextures(1, &texture_);
}

}  // namespace etak
