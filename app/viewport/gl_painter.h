// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QImage>
#include <QSize>
#include <memory>
#include <string>
#include <vector>

#include "core/render/view_state.h"

namespace etak {

class GlTarget;
struct ViewDisplay;

/// Draws the scenes of a view with the OpenGL context that is current; made, used and destroyed with it.
class GlPainter {
 public:
  /// Throws Error where the context is older than OpenGL 3.3.
  GlPainter();
  ~GlPainter();
  GlPainter(const GlPainter&) = delete;
  GlPainter& operator=(const GlPainter&) = delete;

  std::unique_ptr<GlTarget> target(const QSize& size);

  /// Waits until it is drawn. Programs are kept by their text, so that only what switches parts on or off
  /// compiles. Throws Error with the driver's message.
  ///   environment, display   kept while they are the same
  struct Drawn {
    double frame_ms = 0;    // without compiling
    double compile_ms = 0;  // of the first tile's program and its first drawing, whenever that was
    QColor background;
    bool context_lost = false;
  };
  Drawn draw(const std::vector<ViewTile>& tiles, const std::shared_ptr<const Environment>& environment,
             const ViewDisplay& display, const GlTarget& target);

  void enlarge(const GlTarget& small, const GlTarget& target);

  /// The same as a picture.
  QImage picture(const std::vector<ViewTile>& tiles, const std::shared_ptr<const Environment>& environment,
                 const ViewDisplay& display, const QSize& size);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace etak
