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

/// Draws frames in a thread of its own, with a context that shares textures with another one, so that the
/// user interface does not wait for compiling and drawing.
class GlThread : public QObject {
 public:
  /// A thread whose context shares textures with `other`. Null where contexts of the system cannot share or
  /// cannot be used by another thread.
  static std::unique_ptr<GlThread> beside(QOpenGLContext& other);
  ~GlThread() override;  // waits for the frame in work

  /// Draws a frame and calls `done` from the event loop of the thread that made this object, unless the
  /// object has been deleted by then. Frames are drawn one after the other.
  void draw(const GlJob& job, std::function<void(const GlFrame&)> done);

  /// Draws a frame as a picture and waits for it. Throws Error.
  QImage picture(const GlJob& job);

 private:
  GlThread();
  GlFrames& frames();  // made on first use, in the thread, with the context current there

  QThread thread_;
  QObject hand_;  // belongs to the thread, which makes the calls that are posted to it
  QOffscreenSurface surface_;
  std::unique_ptr<QOpenGLContext> context_;
  std::unique_ptr<GlFrames> frames_;
};

}  // namespace etak
