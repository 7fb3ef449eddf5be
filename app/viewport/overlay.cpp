// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/overlay.h"

#include <QPainter>
#include <QPainterPath>

#include "app/viewport/sides.h"

namespace etak {
namespace {

const QColor ink(255, 255, 255), shade(0, 0, 0, 170);

// Draws text on a dark plate, so that it is legible on any picture.
//   box   the area in which the text is aligned and wrapped
void plate(QPainter& painter, const QRect& box, Qt::Alignment where, const QString& text) {
  if (text.isEmpty() || box.width() < 24) return;
  const int flags = static_cast<int>(where) | Qt::TextWordWrap;
  const QRect inside = box.adjusted(8, 5, -8, -5);
  const QRect taken = painter.boundingRect(inside, flags, text);
  painter.setPen(Qt::NoPen);
  painter.setBrush(shade);
  painter.drawRoundedRect(taken.adjusted(-6, -3, 6, 3), 4, 4);
  painter.setPen(ink);
  painter.drawText(inside, flags, text);
}

}  // namespace

Overlay::Overlay(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::NoFocus);
}

void Overlay::show_content(Content content) {
  if (content == content_) return;  // painting the overlay would paint the picture below it again
  content_ = std::move(content);
  update();
}

void Overlay::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRect all = rect();
  if (content_.separator && !content_.photograph.isNull())
    paint_photograph(painter, content_.photograph, all, *content_.separator);
  if (content_.separator) {
    const double x = *content_.separator;
    painter.setPen(QPen(shade, 3));
    painter.drawLine(QPointF(x, 0), QPointF(x, height()));
    painter.setPen(QPen(ink, 1));
    painter.drawLine(QPointF(x, 0), QPointF(x, height()));
    painter.setBrush(ink);
    painter.setPen(QPen(shade, 1));
    painter.drawEllipse(QPointF(x, height() / 2.0), 6, 6);
    const int middle = static_cast<int>(x);
    plate(painter, QRect(0, 0, middle - 4, height()), Qt::AlignRight | Qt::AlignTop, content_.left_name);
    plate(painter, QRect(middle + 4, 0, width() - middle - 4, height()), Qt::AlignLeft | Qt::AlignTop,
          content_.right_name);
  } else {
    plate(painter, all, Qt::AlignHCenter | Qt::AlignTop, content_.left_name);
  }
  for (const Mark& mark : content_.marks) {
    painter.setPen(QPen(shade, 4));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(mark.at, 9, 9);
    painter.setPen(QPen(mark.held ? QColor(255, 200, 60) : ink, 2));
    painter.drawEllipse(mark.at, 9, 9);
    const QPointF beside = mark.at + QPointF(13, -9);
    plate(painter, QRect(beside.toPoint(), QSize(120, 40)), Qt::AlignLeft | Qt::AlignTop, mark.name);
  }
  // A share of sin^2 of an angle of a ball's pixels shows its surface at less than that angle.
  if (content_.angle_zones)
    plate(painter, all, Qt::AlignLeft | Qt::AlignBottom,
          tr("0 to 45°: 50 % of a ball's pixels\n45 to 75° (blue): 43 %\n75 to 90° (orange): 7 %"));
  plate(painter, all, Qt::AlignHCenter | Qt::AlignBottom, content_.readout);
  plate(painter, QRect(0, height() / 6, width(), height()), Qt::AlignHCenter | Qt::AlignTop,
        content_.message);
}

}  // namespace etak
