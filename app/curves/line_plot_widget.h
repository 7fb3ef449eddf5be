// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/curves/plot_widget.h"

namespace etak::editor {

/// A widget that shows a LinePlot: curves over an axis.
class LinePlotWidget : public PlotOf<LinePlot> {
  Q_OBJECT

 public:
  using PlotOf::PlotOf;

  ///   unit   stands behind the place of the cursor in the readout: " nm", "°"
  void set_plot(LinePlot plot, QString unit);

 protected:
  void draw(QPainter& painter, const QRectF& area) override;
  std::optional<double> place_at(QPointF point) const override;
  QPointF place_of(const PlotCurve& curve, double x, double y) const override;
  QString place_text(double at) const override;
  QLineF cursor_line(double at) const override;
  std::pair<double, double> range() const override { return {plot_.x.least, plot_.x.most}; }

 private:
  QPointF point(double x, double y, const PlotAxis& axis) const;
  const PlotAxis& axis_of(const PlotCurve& curve) const;
  void draw_axes(QPainter& painter, const QRectF& area);

  QString unit_;
  QRectF frame_;  // area of the curves in the last painting
};

}  // namespace etak::editor
