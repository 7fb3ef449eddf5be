// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QImage>
#include <QSize>
#include <memory>
#include <string>
#include <vector>

#include "app/viewport/gl_textures.h"
#include "core/render/view_state.h"

namespace etak {

struct ViewDisplay;

/// Draws the scenes of a view with the current OpenGL context. The same context must be current when an
/// object is made, used and destroyed.
class GlPainter {
 public:
  /// Throws Error where the context is older than OpenGL 3.3.
  ///   waits   for the end of each drawing, so that times are those of the GPU too. The thread of the user interface must
  ///           not; its times are those of the calls
  explicit GlPainter(bool waits);
  ~GlPainter();
  GlPainter(const GlPainter&) = delete;
  GlPainter& operator=(const GlPainter&) = delete;

  /// Draws the tiles into `target`. Programs are kept by their text, so
  /// that only a change that switches parts of a shader on or off compiles. Throws Error with the message of
  /// the driver.
  ///   environment, display   their textures are kept as long as they stay the same
  struct Drawn {
    double frame_ms = 0;    // without compiling
    double compile_ms = 0;  // for the first tile's program and its first drawing, now or in an earlier frame
    QColor background;
    bool context_lost = false;
  };
  /// Rows of the target from below; the background is drawn with the first ones.
  struct Rows {
    int first = 0, count = 1 << 20;
  };
  Drawn draw(const std::vector<ViewTile>& tiles, const std::shared_ptr<const Environment>& environment,
             const ViewDisplay& display, const GlTarget& target, const Rows& rows);

  /// Copies `small` to the whole of `target`, and returns the milliseconds that it took.
  double enlarge(const GlTarget& small, const GlTarget& target);

  /// Draws the tiles and returns them as a picture of `size` pixels. Throws Error as draw() does.
  QImage picture(const std::vector<ViewTile>& tiles, const std::shared_ptr<const Environment>& environment,
                 const ViewDisplay& display, const QSize& size);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace etak
