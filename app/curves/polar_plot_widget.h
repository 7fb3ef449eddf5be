// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/curves/plot_widget.h"
#include "core/plot/polar_plot.h"

namespace etak::editor {

/// A widget that shows a PolarPlot: a lobe over a surface. The cursor moves over the angle.
class PolarPlotWidget : public PlotOf<PolarPlot> {
  Q_OBJECT

 public:
  using PlotOf::PlotOf;

  void set_plot(PolarPlot plot);

 protected:
  void draw(QPainter& painter, const QRectF& area) override;
  std::optional<double> place_at(QPointF point) const override;
  QPointF place_of(const PlotCurve& curve, double x, double y) const override;
  QString place_text(double at) const override;
  QLineF cursor_line(double at) const override;
  std::pair<double, double> range() const override { return {-90, 90}; }

 private:
  QPointF on_rim(double angle_deg, double share) const;
  void draw_grid(QPainter& painter) const;

  QPointF centre_;  // centre of the circle in the last painting
  double rim_ = 1;
};

}  // namespace etak::editor
