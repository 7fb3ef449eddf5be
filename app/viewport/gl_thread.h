// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QOffscreenSurface>
#include <QThread>
#include <functional>
#include <memory>

#include "app/viewport/gl_frames.h"

class QOpenGLContext;

namespace etak {

/// Draws frames in a thread of its own, with a context that shares its textures with another one, so that
/// compiling and drawing keep nobody waiting.
class GlThread : public QObject {
 public:
  /// Null where the system's contexts cannot share, or cannot be used by another thread.
  static std::unique_ptr<GlThread> beside(QOpenGLContext& other);
  ~GlThread() override;  // waits for the frame that is being drawn

  /// `done` is called from the event loop of the thread that made this, unless this is gone by then. One at a
  /// time.
  void draw(const GlJob& job, std::function<void(const GlFrame&)> done);

  /// Waits for it. Throws Error.
  QImage picture(const GlJob& job);

 private:
  GlThread();
  GlFrames& frames();  // of the context, which is current in the thread

  QThread thread_;
  QObject hand_;  // lives in the thread: what is sent to it is done there
  QOffscreenSurface surface_;
  std::unique_ptr<QOpenGLContext> context_;
  std::unique_ptr<GlFrames> frames_;
};

}  // namespace etak
