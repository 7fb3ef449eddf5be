// SPDX-License-Identifier: Apache-2.0
#include "app/curves/line_plot_widget.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/viewport/qt_text.h"
#include "core/base/number.h"

namespace etak::editor {
namespace {

constexpr double tick = 4, gap = 4;

double widest(const PlotAxis& axis, const QFontMetricsF& metrics) {
  double out = 0;
  for (const double at : axis.ticks)
    out = std::max(out, metrics.horizontalAdvance(qt_text(tick_text(axis, at))));
  return out;
}

}  // namespace

void LinePlotWidget::set_plot(LinePlot plot, QString unit) {
  plot_ = std::move(plot);
  unit_ = std::move(unit);
  plot_changed();
}

const PlotAxis& LinePlotWidget::axis_of(const PlotCurve& curve) const {
  return curve.on_right && plot_.right ? *plot_.right : plot_.left;
}

QPointF LinePlotWidget::point(double x, double y, const PlotAxis& axis) const {
  return {frame_.left() + (x - plot_.x.least) / (plot_.x.most - plot_.x.least) * frame_.width(),
          frame_.bottom() - (y - axis.least) / (axis.most - axis.least) * frame_.height()};
}

void LinePlotWidget::draw(QPainter& painter, const QRectF& area) {
  const QFontMetricsF metrics(painter.font());
  const double label = metrics.height() + 2;
  frame_ = area.adjusted(widest(plot_.left, metrics) + tick + gap + 8, label + metrics.height() / 2,
                         -(plot_.right ? widest(*plot_.right, metrics) + tick + gap + 8
                                       : metrics.horizontalAdvance("800") / 2 + 8),
                         -(2 * label + tick + gap));
  draw_axes(painter, area);
  painter.save();
  painter.setClipRect(frame_.adjusted(-3, -3, 3, 3));
  draw_curves(painter);
  painter.restore();
}

void LinePlotWidget::draw_axes(QPainter& painter, const QRectF& area) {
  const QFontMetricsF metrics(painter.font());
  const double half = metrics.height() / 2 - metrics.descent();
  const auto centred = [&](double x, double y, const QString& text) {
    painter.drawText(QPointF(x - metrics.horizontalAdvance(text) / 2, y), text);
  };
  painter.setPen(QPen(line(), 1));
  for (const double at : plot_.left.ticks) {
    const double y = point(0, at, plot_.left).y();
    painter.drawLine(QPointF(frame_.left(), y), QPointF(frame_.right(), y));
  }
  for (const double at : plot_.x.ticks) {
    const double x = point(at, 0, plot_.left).x();
    painter.drawLine(QPointF(x, frame_.top()), QPointF(x, frame_.bottom()));
  }
  painter.setPen(ink_soft());
  int shade = 0;
  for (const PlotZone& zone : plot_.zones) {
    const QRectF part(point(zone.first, plot_.left.most, plot_.left),
                      point(zone.last, plot_.left.least, plot_.left));
    painter.fillRect(part, QColor(128, 128, 128, shade));
    centred(part.center().x(), area.top() + metrics.ascent() + 2, qt_text(zone.text));
    shade += 30;
  }
  // Numbers that would overlap the one before are left out.
  const double room = metrics.height() * 0.9;
  double free_below = frame_.bottom() + 2 * room;
  for (const double at : plot_.left.ticks) {
    if (point(0, at, plot_.left).y() > free_below - room) continue;
    free_below = point(0, at, plot_.left).y();
    const QString text = qt_text(tick_text(plot_.left, at));
    painter.drawText(QPointF(frame_.left() - tick - gap - metrics.horizontalAdvance(text),
                             point(0, at, plot_.left).y() + half),
                     text);
  }
  for (const double at : plot_.x.ticks)
    centred(point(at, 0, plot_.left).x(), frame_.bottom() + gap + metrics.ascent(),
            qt_text(tick_text(plot_.x, at)));
  free_below = frame_.bottom() + 2 * room;
  if (plot_.right)
    for (const double at : plot_.right->ticks) {
      const double y = point(0, at, *plot_.right).y();
      if (y > free_below - room) continue;
      free_below = y;
      painter.drawLine(QPointF(frame_.right(), y), QPointF(frame_.right() + tick, y));
      painter.drawText(QPointF(frame_.right() + tick + gap, y + half), qt_text(tick_text(*plot_.right, at)));
    }
  painter.drawLine(frame_.topLeft(), frame_.bottomLeft());
  painter.drawLine(frame_.bottomLeft(), frame_.bottomRight());
  painter.setPen(ink());
  centred(frame_.center().x(), frame_.bottom() + 2 * gap + metrics.height() + metrics.ascent(),
          qt_text(plot_.x.label));
  const double top = area.top() + metrics.ascent() + 2;
  painter.drawText(QPointF(8, top), qt_text(plot_.left.label));
  if (plot_.right) {
    const QString text = qt_text(plot_.right->label);
    painter.drawText(QPointF(area.right() - 8 - metrics.horizontalAdvance(text), top), text);
  }
}

std::optional<double> LinePlotWidget::place_at(QPointF at) const {
  if (!frame_.contains(at)) return std::nullopt;
  return plot_.x.least + (at.x() - frame_.left()) / frame_.width() * (plot_.x.most - plot_.x.least);
}

QPointF LinePlotWidget::place_of(const PlotCurve& curve, double x, double y) const {
  return point(x, y, axis_of(curve));
}

QString LinePlotWidget::place_text(double at) const {
  return qt_text(number(at, 4)) + unit_;
}

QLineF LinePlotWidget::cursor_line(double at) const {
  const double x = point(at, 0, plot_.left).x();
  return {x, frame_.top(), x, frame_.bottom()};
}

}  // namespace etak::editor
