// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QOpenGLWidget>
#include <memory>

#include "app/viewport/gl_frames.h"

namespace etak {

class GlThread;

/// Why there can be no OpenGL view here; empty where there can. Makes a context to find out.
QString why_no_gl();

/// The picture of a state by OpenGL. Drawn in a thread of its own where contexts can share: the last picture
/// stays until the next is there, so that nobody waits for a shader to be compiled.
class GlView : public QOpenGLWidget {
  Q_OBJECT

 public:
  /// `threaded` false: as where contexts cannot share.
  explicit GlView(QWidget* parent, bool threaded = true);
  ~GlView() override;

  /// `hurry`: while something is dragged; at half the size where a whole frame takes longer than a screen's
  /// two.
  void show_state(const ViewState& state, const ViewDisplay& display, bool hurry);

  /// Waits for it, and for the frame that is being drawn. Throws Error.
  QImage picture(const ViewState& state, const ViewDisplay& display, const QSize& size);
  QSize picture_size() const { return size() * devicePixelRatioF(); }

  QString gl_name() const { return gl_name_; }
  double compile_ms() const { return frame_.compile_ms; }
  double whole_frame_ms() const { return whole_ms_; }
  bool is_drawing() const { return drawing_; }
  bool is_threaded() const { return thread_ != nullptr; }

 signals:
  void drawn(double frame_ms);
  void refused(const QString& message);  // the state cannot be drawn
  void failed(const QString& why);       // this view cannot go on
  void lost();                           // the context is gone: another view may work

 protected:
  void initializeGL() override;
  void paintGL() override;

 private:
  GlJob next_job();
  void begin();  // the next frame, if one is wanted and none is being drawn
  void take(const GlFrame& frame);
  void tell_loss();
  void show_frame();
  void drop();

  ViewState state_;
  ViewDisplay display_;
  std::unique_ptr<GlThread> thread_;  // one of the two
  std::unique_ptr<GlFrames> frames_;
  GlFrame frame_;  // the last one
  QSize whole_;    // what the view's size was when its drawing began
  unsigned reader_ = 0;
  QString gl_name_;
  bool hurry_ = false, threaded_, wanted_ = true, drawing_ = false, fresh_ = false, lost_ = false;
  double whole_ms_ = 0;
};

}  // namespace etak
