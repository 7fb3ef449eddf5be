// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <optional>
#include <string>
#include <vector>

#include "core/plot/plot_file.h"

class QPainter;

namespace etak::editor {

/// The base of all plots: colours of the palette, a legend, a cursor that the pointer or the arrow keys move,
/// a readout of the values under the cursor, and copies as CSV (Ctrl+C) and SVG (Ctrl+Shift+C), also in the
/// context menu.
class PlotWidget : public QWidget {
  Q_OBJECT

 public:
  explicit PlotWidget(QWidget* parent = nullptr);

  void copy_csv() const;
  void copy_svg() const;
  QString csv_text() const;
  QString svg_text() const;

  /// "45: exact 0.912, Schlick 0.898"; empty without a cursor.
  QString readout() const;
  /// Puts the cursor at a place of the axis along which it moves, as the pointer would; none hides the
  /// cursor.
  void set_cursor(std::optional<double> at);

  QSize sizeHint() const override { return {520, 300}; }
  QSize minimumSizeHint() const override { return {240, 140}; }

 signals:
  void readout_changed(const QString& text);

 protected:
  // The functions that a kind of plot must define.
  virtual std::string csv_of() const = 0;
  virtual std::string svg_of(bool dark) const = 0;
  virtual const std::vector<PlotKey>& keys() const = 0;
  virtual std::string title() const = 0;
  virtual std::string description() const = 0;
  virtual const std::vector<PlotCurve>& curves() const = 0;
  /// The place in the widget of a value of a curve.
  virtual QPointF place_of(const PlotCurve& curve, double x, double y) const = 0;
  /// Draws axes and curves inside `area`, which lies below the legend.
  virtual void draw(QPainter& painter, const QRectF& area) = 0;
  /// The place of the cursor for a point in the widget; none outside of the plot.
  virtual std::optional<double> place_at(QPointF point) const = 0;
  /// The place of the cursor as text: "450 nm".
  virtual QString place_text(double at) const = 0;
  /// The line that shows the cursor at a place, in the widget.
  virtual QLineF cursor_line(double at) const = 0;
  /// The smallest and the largest place of the cursor.
  virtual std::pair<double, double> range() const = 0;

  /// Must be called when the plot has changed.
  void plot_changed();
  /// Draws all curves. Lines are interrupted where a curve has no value; dots are not joined.
  void draw_curves(QPainter& painter) const;
  bool empty() const { return curves().empty(); }

  const PlotColors& colors() const;
  QPen pen_of(std::string_view css_class) const;
  QColor ink() const;
  QColor ink_soft() const;
  QColor line() const;

  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  // A name and its value at the cursor.
  struct Reading {
    QString name;
    double value = 0;
    QColor color;
    QPointF place;  // of the value, in the widget
  };
  bool dark() const;
  std::vector<Reading> readings(double at) const;
  /// Draws the legend, unless `painter` is null, and returns its height.
  ///   brief   with the short texts of the keys
  double legend(QPainter* painter, bool brief) const;
  void draw_cursor(QPainter& painter) const;

  std::optional<double> cursor_;
};

/// A plot of core in a widget.
template <class Plot>
class PlotOf : public PlotWidget {
 public:
  using PlotWidget::PlotWidget;
  const Plot& plot() const { return plot_; }

 protected:
  std::string csv_of() const override { return csv(plot_); }
  std::string svg_of(bool dark) const override { return svg_file(plot_, dark); }
  const std::vector<PlotKey>& keys() const override { return plot_.keys; }
  std::string title() const override { return plot_.title; }
  std::string description() const override { return plot_.description; }
  const std::vector<PlotCurve>& curves() const override { return plot_.curves; }

  Plot plot_;
};

}  // namespace etak::editor
