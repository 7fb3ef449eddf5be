// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/editor/curves/plot_widget.h"
#include "core/report/polar_plot.h"

namespace etak::editor {

/// A lobe over a surface; see PolarPlot. The cursor moves over the angle.
class PolarPlotWidget : public PlotWidget {
  Q_OBJECT

 public:
  using PlotWidget::PlotWidget;

  void set_plot(PolarPlot plot);
  const PolarPlot& plot() const { return plot_; }

 protected:
  std::string csv_of() const override { return csv(plot_); }
  std::string svg_of(bool dark) const override { return svg_file(plot_, dark); }
  const std::vector<PlotKey>& keys() const override { return plot_.keys; }
  std::string title() const override { return plot_.title; }
  std::string description() const override { return plot_.description; }
  bool empty() const override { return plot_.curves.empty(); }
  void draw(QPainter& painter, const QRectF& area) override;
  std::optional<double> place_at(QPointF point) const override;
  std::vector<Reading> readings(double at) const override;
  QString place_text(double at) const override;
  QLineF cursor_line(double at) const override;
  std::pair<double, double> range() const override { return {-90, 90}; }

 private:
  QPointF on_rim(double angle_deg, double share) const;
  void draw_grid(QPainter& painter) const;

  PolarPlot plot_;
  QPointF centre_;  // of the last painting
  double rim_ = 1;
};

}  // namespace etak::editor
