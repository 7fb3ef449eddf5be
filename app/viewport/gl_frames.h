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

using GlSync = struct __GLsync*;

/// A frame that is to be drawn.
///   after   a fence of another context that shares textures with this one: the GPU draws when it is signalled. Null:
///           at once. Who draws the frame deletes it
struct GlJob {
  ViewState state;
  ViewDisplay display;
  QSize size;
  double share = 1;  // of width and height that is drawn; the frame is then enlarged
  int band =
      0;  // of a refined state: which rows are drawn, so that a frame can be given up between two of them
  GlSync after = nullptr;
  static constexpr int band_rows = 32;
  bool is_last_band() const { return (band + 1) * band_rows >= size.height(); }
};

/// A frame in a texture, or the reason why there is none.
struct GlFrame {
  unsigned texture = 0;  // 0: nothing was drawn, or not yet the last band
  QSize size;
  QColor background;
  double share = 1;
  double frame_ms = 0;
  double compile_ms =
      0;  // for the first tile's program and its first drawing, in this frame or an earlier one
  bool context_lost = false, refined = false;
  QString refused;  // why the state cannot be drawn; the texture is then grey
  QString failed;   // why this context cannot draw at all
};

/// Draws frames into textures with the current OpenGL context. The same context must be current when an
/// object is made, used and destroyed. The texture of a frame keeps its content while the next frame is
/// drawn.
class GlFrames {
 public:
  /// Throws Error where the context is older than OpenGL 3.3.
  ///   waits   as in GlPainter
  explicit GlFrames(bool waits);
  ~GlFrames();

  GlFrame draw(const GlJob& job);

  /// Draws the frame and reads it back. Throws Error.
  QImage picture(const GlJob& job);

 private:
  GlTarget& of_size(std::unique_ptr<GlTarget>& kept, const QSize& size);

  GlPainter painter_;
  std::array<std::unique_ptr<GlTarget>, 2> targets_;
  std::unique_ptr<GlTarget> small_;  // what is drawn before it is enlarged
  std::size_t next_ = 0;
};

}  // namespace etak
