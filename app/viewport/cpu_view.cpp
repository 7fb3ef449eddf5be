// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/cpu_view.h"

#include <QElapsedTimer>
#include <QPainter>
#include <algorithm>

#include "app/viewport/background.h"
#include "core/base/error.h"
#include "core/base/parallel.h"

namespace etak {
CpuView::CpuView(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_OpaquePaintEvent);
}

void CpuView::show_state(const ViewState& state, const ViewDisplay& display, bool hurry) {
  state_ = state;
  display_ = display;
  hurry_ = hurry;
  wanted_ = true;
  *stop_ = true;
  if (!running_) start();
}

void CpuView::start() {
  const QSize whole = picture_size();
  if (!wanted_ || refining_ || whole.isEmpty()) return;
  wanted_ = false;
  running_ = true;
  const double share = hurry_ ? shares_.next() : 1;
  const QSize size = FrameShare::size(whole, share);
  struct Drawn {
    QImage picture;
    QString message;
    double ms = 0;
  };
  in_background(
      pool_, this,
      [state = state_, display = display_, size] {
        QElapsedTimer timer;
        timer.start();
        Drawn out;
        out.message = failure_of([&] { out.picture = cpu_picture(state, display, size, thread_count(0)); });
        out.ms = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
        return out;
      },
      [this, share](const Drawn& drawn) { take(drawn.picture, drawn.message, drawn.ms, share); });
}

void CpuView::take(const QImage& picture, const QString& message, double ms, double share) {
  running_ = false;
  share_ = share;
  shares_.took(share, ms);
  picture_ = picture;
  update();
  if (message.isEmpty())
    emit drawn(ms);
  else
    emit refused(message);
  start();
  if (has_refined(state_) && !running_ && !hurry_ && message.isEmpty()) refine();
}

void CpuView::refine() {
  struct Stopped {};
  refining_ = true;
  stop_ = std::make_shared<std::atomic<bool>>(false);
  ViewState refined = state_;
  refined.refined = true;
  in_background(
      pool_, this,
      [state = refined, display = display_, size = picture_size(), stop = stop_] {
        try {
          return cpu_picture(state, display, size, thread_count(0), [&](std::size_t, unsigned) {
            if (*stop) throw Stopped{};
          });
        } catch (const Stopped&) {
          return QImage();
        } catch (const Error&) {
          return QImage();  // the moving picture of the same state has told why
        }
      },
      [this](const QImage& picture) {
        refining_ = false;
        if (!picture.isNull() && !wanted_) {
          picture_ = picture;
          update();
        }
        start();
      });
}

void CpuView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (picture_.isNull()) {
    painter.fillRect(rect(), QColor(51, 51, 51));
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform, picture_.size() != picture_size());
  painter.drawImage(QRectF(rect()), picture_, QRectF(picture_.rect()));
}

void CpuView::resizeEvent(QResizeEvent*) {
  wanted_ = true;
  *stop_ = true;
  if (!running_) start();
}

}  // namespace etak
