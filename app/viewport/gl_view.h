// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QOpenGLWidget>
#include <memory>

#include "app/viewport/display.h"
#include "app/viewport/gl_painter.h"

namespace etak {

/// Why there can be no OpenGL view here; empty where there can. Makes a context to find out.
QString why_no_gl();

/// The picture of a state by OpenGL.
class GlView : public QOpenGLWidget {
  Q_OBJECT

 public:
  explicit GlView(QWidget* parent);
  ~GlView() override;

  /// `hurry`: while something is dragged; at half the size where a whole frame takes longer than a screen's
  /// two.
  void show_state(const ViewState& state, const ViewDisplay& display, bool hurry);

  /// Throws Error.
  QImage picture(const QSize& size);
  QSize picture_size() const { return size() * devicePixelRatioF(); }

  QString gl_name() const { return gl_name_; }
  double compile_ms() const { return compile_ms_; }
  double whole_frame_ms() const { return whole_ms_; }

 signals:
  void drawn(double frame_ms);
  void refused(const QString& message);  // the state cannot be drawn
  void failed(const QString& why);       // this view cannot go on
  void lost();                           // the context is gone: another view may work

 protected:
  void initializeGL() override;
  void paintGL() override;

 private:
  void drop_painter();

  ViewState state_;
  ViewDisplay display_;
  std::unique_ptr<GlPainter> painter_;
  QString gl_name_;
  bool hurry_ = false;
  double compile_ms_ = 0, whole_ms_ = 0;
};

}  // namespace etak
