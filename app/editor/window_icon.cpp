// SPDX-License-Identifier: Apache-2.0
#include "app/editor/window_icon.h"

#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <QRadialGradient>

namespace etak::editor {
namespace {

constexpr double icon_side = 128;  // units of the drawing

void half_sphere(QPainter& painter, const QRectF& half, const QGradientStops& stops) {
  // The highlight lies at the upper left of the square around the sphere.
  QRadialGradient light(QPointF(20 + 0.36 * 88, 20 + 0.3 * 88), 0.8 * 88);
  light.setStops(stops);
  painter.setClipRect(half);
  painter.setBrush(light);
  painter.drawEllipse(QPointF(64, 64), 44, 44);
  painter.setClipping(false);
}

QPixmap drawn_icon(int pixels) {
  QPixmap out(pixels, pixels);
  out.fill(Qt::transparent);
  QPainter painter(&out);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(pixels / icon_side, pixels / icon_side);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0x30, 0x33, 0x38));
  painter.drawRoundedRect(QRectF(4, 4, 120, 120), 24, 24);
  half_sphere(painter, QRectF(0, 0, 63, icon_side),
              {{0, QColor(0xff, 0xf6, 0xda)},
               {0.28, QColor(0xff, 0xe4, 0x9c)},
               {0.75, QColor(0xa3, 0x75, 0x2a)},
               {1, QColor(0x3b, 0x2a, 0x10)}});
  half_sphere(painter, QRectF(65, 0, 63, icon_side),
              {{0, QColor(0xe8, 0xf1, 0xff)},
               {0.12, QColor(0x53, 0x61, 0x6f)},
               {0.8, QColor(0x20, 0x26, 0x2d)},
               {1, QColor(0x8f, 0xa6, 0xbd)}});
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(0xec, 0xef, 0xf2), 2));
  painter.drawLine(QPointF(64, 14), QPointF(64, 114));
  QPainterPath curve(QPointF(22, 104));
  curve.cubicTo(52, 102, 84, 100, 94, 84);
  curve.cubicTo(104, 68, 104, 40, 106, 24);
  painter.setPen(QPen(QColor(0x5c, 0x93, 0xd6), 4, Qt::SolidLine, Qt::RoundCap));
  painter.drawPath(curve);
  return out;
}

}  // namespace

QIcon window_icon() {
  QIcon out;
  for (const int pixels : {16, 24, 32, 48, 64, 128, 256}) out.addPixmap(drawn_icon(pixels));
  return out;
}

}  // namespace etak::editor
