// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QWidget>
#include <atomic>
#include <memory>

#include "app/viewport/background.h"
#include "app/viewport/display.h"
#include "app/viewport/frame_share.h"

namespace etak {

/// Shows a state as the CPU renderer of core draws it, in a thread of its own. The last picture stays on the
/// screen until the next is drawn. While nothing moves, the picture is refined; that stops when another state is to be
/// shown.
class CpuView : public QWidget {
  Q_OBJECT

 public:
  explicit CpuView(QWidget* parent);
  ~CpuView() override { *stop_ = true; }

  void show_state(const ViewState& state, const ViewDisplay& display, bool hurry);
  QSize picture_size() const { return size() * devicePixelRatioF(); }
  double share() const { return share_; }  // of width and height that the last picture was drawn with
  bool is_drawing() const { return running_ || (wanted_ && refining_); }
  bool is_refining() const { return running_ || refining_; }  // or will be, behind the frame in work

 signals:
  void drawn(double frame_ms);
  void refused(const QString& message);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void start();
  void take(const QImage& picture, const QString& message, double ms, double share);
  void refine();

  ViewState state_;
  ViewDisplay display_;
  QImage picture_;
  bool hurry_ = false, running_ = false, wanted_ = false, refining_ = false;
  std::shared_ptr<std::atomic<bool>> stop_ = std::make_shared<std::atomic<bool>>(false);
  double share_ = 1;
  FrameShare shares_;
  Worker pool_;  // the last member, so that its thread ends before the others are destroyed
};

}  // namespace etak
