// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/editor/curves/plot_widget.h"

namespace etak::editor {

/// Lines over an axis; see LinePlot.
class LinePlotWidget : public PlotWidget {
  Q_OBJECT

 public:
  using PlotWidget::PlotWidget;

  /// `unit` stands behind the cursor's place in the readout: "nm".
  void set_plot(LinePlot plot, QString unit);
  const LinePlot& plot() const { return plot_; }

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
  std::pair<double, double> range() const override { return {plot_.x.least, plot_.x.most}; }

 private:
  QPointF point(double x, double y, const PlotAxis& axis) const;
  const PlotAxis& axis_of(const PlotCurve& curve) const;
  void draw_axes(QPainter& painter, const QRectF& area);
  void draw_curve(QPainter& painter, const PlotCurve& curve) const;

  LinePlot plot_;
  QString unit_;
  QRectF frame_;  // of the last painting
};

}  // namespace etak::editor
