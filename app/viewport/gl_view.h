// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <QTimer>
#include <memory>

#include "app/viewport/frame_share.h"
#include "app/viewport/gl_frames.h"

namespace etak {

class GlThread;

/// The reason why there can be no OpenGL view, for the user; empty where there can. Makes a context to find
/// out.
QString why_no_gl();

/// Shows a state as OpenGL draws it. Where contexts can share, it is drawn in a thread of its own: the last
/// picture stays on the screen until the next is drawn, so that the user does not wait for a shader to be
/// compiled. Where they cannot, the thread of the user interface tells the GPU what to draw and looks from time to time
/// whether it is done. While nothing moves, the frame is refined, band by band.
class GlView : public QOpenGLWidget {
  Q_OBJECT

 public:
  ///   threaded   false: drawn by the user-interface thread, as where contexts cannot share
  explicit GlView(QWidget* parent, bool threaded = true);
  ~GlView() override;

  ///   hurry   the user drags: fewer pixels are drawn where whole frames take longer than fluid_ms
  void show_state(const ViewState& state, const ViewDisplay& display, bool hurry);

  /// The picture of a state, `size` in pixels. Waits for it and for the frame in work. Throws Error.
  QImage picture(const ViewState& state, const ViewDisplay& display, const QSize& size);
  QSize picture_size() const { return size() * devicePixelRatioF(); }

  QString gl_name() const { return gl_name_; }
  double compile_ms() const { return frame_.compile_ms; }
  double share() const { return frame_.share; }  // of width and height that the last frame was drawn with
  bool is_drawing() const { return drawing_ && (wanted_ || !refining_); }
  bool is_refining() const { return wants_more() || drawing_; }  // or will be, behind the frame in work
  bool is_threaded() const { return thread_ != nullptr; }

 signals:
  void drawn(double frame_ms);
  void refused(const QString& message);  // the state cannot be drawn
  void failed(const QString& why);       // this view cannot draw any more
  void lost();                           // the context is lost; a new view may work

 protected:
  void initializeGL() override;
  void paintGL() override;

 private:
  bool wants_more() const { return wanted_ || band_ >= 0; }
  GlJob next_job();
  void begin();  // begins the next frame, if one is wanted and none is in work
  void draw_here();
  void look_for_end();  // of the frame that draw_here() began
  void take(const GlFrame& frame);
  void tell_loss();
  void show_frame();
  void forget_read();
  void drop();

  ViewState state_;
  ViewDisplay display_;
  std::unique_ptr<GlThread> thread_;  // either thread_ or frames_ is there
  std::unique_ptr<GlFrames> frames_;
  GlFrame frame_;          // the last frame
  QSize whole_;            // size of the view when the last frame was begun
  bool refining_ = false;  // the frame in work is a band of a refined one
  int band_ = -1;          // of the refined frame, that is drawn next; -1: none
  unsigned reader_ = 0;
  GlSync read_ = nullptr;  // signalled when the frame was read for the screen last
  GlFrame pending_;        // what draw_here() began, its fence, and the time since then
  GlSync end_ = nullptr;
  QElapsedTimer since_;
  QTimer poll_;
  QString gl_name_;
  bool hurry_ = false, threaded_, wanted_ = true, drawing_ = false, fresh_ = false, lost_ = false;
  FrameShare shares_;
};

}  // namespace etak
