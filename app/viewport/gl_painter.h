// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QSize>
#include <memory>
#include <string>
#include <vector>

#include "core/render/view_state.h"

namespace etak {

struct ViewDisplay;

/// Draws the scenes of a view with the OpenGL context that is current; made, used and destroyed with it.
class GlPainter {
 public:
  /// Throws Error where the context is older than OpenGL 3.3.
  GlPainter();
  ~GlPainter();
  GlPainter(const GlPainter&) = delete;
  GlPainter& operator=(const GlPainter&) = delete;

  std::string name() const;  // the driver's renderer and version

  /// Into framebuffer `target`; waits until it is drawn. Programs are kept by their text, so that only what
  /// switches parts on or off compiles. Throws Error with the driver's message.
  ///   environment, display   kept while they are the same
  struct Drawn {
    double frame_ms = 0, compile_ms = 0;  // the second: of programs that this frame was the first to need
    bool context_lost = false;
  };
  Drawn draw(const std::vector<ViewTile>& tiles, const std::shared_ptr<const Environment>& environment,
             const ViewDisplay& display, const QSize& size, unsigned target);

  /// The same at a share of the size, enlarged into `target`.
  Drawn draw_small(const std::vector<ViewTile>& tiles, const std::shared_ptr<const Environment>& environment,
                   const ViewDisplay& display, const QSize& small, const QSize& size, unsigned target);

  /// The same as a picture.
  QImage picture(const std::vector<ViewTile>& tiles, const std::shared_ptr<const Environment>& environment,
                 const ViewDisplay& display, const QSize& size);

  /// Milliseconds that compiling the last frame's first program took, when it was compiled.
  double compile_ms() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace etak
