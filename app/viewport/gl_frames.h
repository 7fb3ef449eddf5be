// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QImage>
#include <QSize>
#include <array>
#include <memory>

#include "app/viewport/display.h"
#include "app/viewport/gl_painter.h"

namespace etak {

/// What a frame is drawn from.
struct GlJob {
  ViewState state;
  ViewDisplay display;
  QSize size;
  bool half = false;  // drawn at half the size, then enlarged
};

/// A frame in a texture, or why there is none.
struct GlFrame {
  unsigned texture = 0;  // 0: nothing was drawn
  QSize size;
  QColor background;
  bool half = false;
  double frame_ms = 0;
  double compile_ms = 0;  // of the first tile's program and its first drawing, whenever that was
  bool context_lost = false;
  QString refused;  // the state cannot be drawn: the texture is grey
  QString failed;   // this context draws nothing
};

/// Draws frames into textures with the context that is current; made, used and destroyed with it. The texture
/// of a frame stays as it is until the frame after the next.
class GlFrames {
 public:
  /// Throws Error where the context is older than OpenGL 3.3.
  GlFrames();
  ~GlFrames();

  GlFrame draw(const GlJob& job);

  /// Throws Error.
  QImage picture(const GlJob& job);

 private:
  GlTarget& of_size(std::unique_ptr<GlTarget>& kept, const QSize& size);

  GlPainter painter_;
  std::array<std::unique_ptr<GlTarget>, 2> targets_;
  std::unique_ptr<GlTarget> small_;
  std::size_t next_ = 0;
};

}  // namespace etak
