// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QOpenGLFramebufferObject>
#include <QOpenGLTexture>
#include <memory>

#include "core/color/ocio.h"
#include "core/image/image.h"

namespace etak {

using GlTexture = QOpenGLTexture;
/// A frame buffer with a texture of 8-bit codes. Contexts that share can use the texture, but not the frame
/// buffer.
using GlTarget = QOpenGLFramebufferObject;

/// A texture of floats for the current context, filtered linearly.
///   round   the first column follows the last; rows are clamped
std::unique_ptr<GlTexture> gl_texture(const Image& map, bool round);
std::unique_ptr<GlTexture> gl_texture(const OcioShader::Table& table);

/// Throws Error where the driver cannot draw into a picture of this size.
std::unique_ptr<GlTarget> gl_target(const QSize& size);

}  // namespace etak
