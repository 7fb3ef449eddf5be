// SPDX-License-Identifier: Apache-2.0
#include "app/curves/polar_plot_widget.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/viewport/qt_text.h"
#include "core/base/number.h"

namespace etak::editor {
void PolarPlotWidget::set_plot(PolarPlot plot) {
  plot_ = std::move(plot);
  plot_changed();
}

QPointF PolarPlotWidget::on_rim(double angle_deg, double share) const {
  const double radian = qDegreesToRadians(angle_deg);
  return centre_ + rim_ * share * QPointF(std::sin(radian), -std::cos(radian));
}

void PolarPlotWidget::draw(QPainter& painter, const QRectF& area) {
  const QFontMetricsF metrics(painter.font());
  const double below = 2 * metrics.height() + 12, above = metrics.height() + 6;
  const double beside = metrics.horizontalAdvance("90°") + 14;
  rim_ = std::max(20.0, std::min(area.height() - below - above, area.width() / 2 - beside));
  centre_ = {area.center().x(),
             area.top() + above + std::max(rim_, (area.height() - below - above + rim_) / 2)};
  draw_grid(painter);
  draw_curves(painter);
}

void PolarPlotWidget::draw_grid(QPainter& painter) const {
  const QFontMetricsF metrics(painter.font());
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(line(), 1));
  const auto centred = [&](QPointF at, const QString& text) {
    painter.drawText(at - QPointF(metrics.horizontalAdvance(text) / 2, 0), text);
  };
  for (const double tick : plot_.radial.ticks) {
    const double r = rim_ * polar_radius(plot_, tick);
    // Qt wants angles in sixteenths of a degree, counted from the right: this is the upper half of the
    // circle.
    if (r > 0) painter.drawArc(QRectF(centre_ - QPointF(r, r), QSizeF(2 * r, 2 * r)), 0, 180 * 16);
  }
  for (int angle = -60; angle <= 60; angle += 30) painter.drawLine(centre_, on_rim(angle, 1));
  painter.setPen(QPen(ink_soft(), 1));
  painter.drawLine(on_rim(-90, 1), on_rim(90, 1));
  for (int angle = -90; angle <= 90; angle += 30) {
    const QString text = QString::number(std::abs(angle)) + "°";
    const double wide = metrics.horizontalAdvance(text);
    const QPointF at = on_rim(angle, 1) + 6 * (on_rim(angle, 1) - centre_) / rim_;
    painter.drawText(at + QPointF(angle < 0   ? -wide
                                  : angle > 0 ? 0
                                              : -wide / 2,
                                  angle % 90 == 0 && angle != 0 ? 4 : 0),
                     text);
  }
  // Numbers that would overlap the one before are left out.
  double free_from = centre_.x();
  const double y = centre_.y() + metrics.ascent() + 4;
  for (const double tick : plot_.radial.ticks) {
    const QString text = qt_text(radial_text(plot_, tick));
    const double x = centre_.x() + rim_ * polar_radius(plot_, tick), wide = metrics.horizontalAdvance(text);
    if (&tick != plot_.radial.ticks.data() && x - wide / 2 < free_from) continue;
    centred({x, y}, text);
    free_from = x + wide / 2 + 6;
  }
  painter.setPen(ink());
  centred({centre_.x(), y + metrics.height() + 2}, qt_text(plot_.radial.label));
  // An arrow towards the centre shows the light.
  painter.setPen(QPen(ink(), 2));
  const QPointF from = on_rim(plot_.light_deg, 1), to = on_rim(plot_.light_deg, 0.82);
  painter.drawLine(from, to);
  const QPointF back = 0.35 * (from - to), aside(-0.5 * back.y(), 0.5 * back.x());
  painter.drawLine(to, to + back + aside);
  painter.drawLine(to, to + back - aside);
}

std::optional<double> PolarPlotWidget::place_at(QPointF at) const {
  const QPointF from = at - centre_;
  if (from.y() > 0 || std::hypot(from.x(), from.y()) > 1.1 * rim_) return std::nullopt;
  return qRadiansToDegrees(std::atan2(from.x(), -from.y()));
}

QPointF PolarPlotWidget::place_of(const PlotCurve& /*curve*/, double x, double y) const {
  return on_rim(x, polar_radius(plot_, y));
}

QString PolarPlotWidget::place_text(double at) const {
  return qt_text(number(std::abs(at), 3)) + "°" + (at < 0 ? tr(" on the light's side") : QString());
}

QLineF PolarPlotWidget::cursor_line(double at) const {
  return {centre_, on_rim(at, 1)};
}

}  // namespace etak::editor
