// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <optional>
#include <string>
#include <vector>

#include "core/plot/plot_file.h"

class QPainter;

namespace etak::editor {

/// What every plot has: colours of the palette, a legend, a cursor moved by the pointer or the arrow keys, a
/// readout of the values under it, and copies as CSV (Ctrl+C) and SVG (Ctrl+Shift+C), also in the context
/// menu.
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
  /// Puts the cursor at a place of the axis along which it moves, as the pointer would; none takes it away.
  void set_cursor(std::optional<double> at);

  QSize sizeHint() const override { return {520, 300}; }
  QSize minimumSizeHint() const override { return {260, 170}; }

 signals:
  void readout_changed(const QString& text);

 protected:
  // What a kind of plot says of itself.
  virtual std::string csv_of() const = 0;
  virtual std::string svg_of(bool dark) const = 0;
  virtual const std::vector<PlotKey>& keys() const = 0;
  virtual std::string title() const = 0;
  virtual std::string description() const = 0;
  virtual const std::vector<PlotCurve>& curves() const = 0;
  /// Where a value of a curve lies in the widget.
  virtual QPointF place_of(const PlotCurve& curve, double x, double y) const = 0;
  /// Axes and curves inside `area`, below the legend.
  virtual void draw(QPainter& painter, const QRectF& area) = 0;
  /// The cursor's place of a point in the widget; none outside of the plot.
  virtual std::optional<double> place_at(QPointF point) const = 0;
  /// "450 nm".
  virtual QString place_text(double at) const = 0;
  /// Both ends of the cursor's line at a place.
  virtual QLineF cursor_line(double at) const = 0;
  /// Where the cursor can be: least and most.
  virtual std::pair<double, double> range() const = 0;

  /// To be called when the plot is another.
  void plot_changed();
  /// Broken where a curve has no value; dots stand alone.
  void draw_curves(QPainter& painter) const;
  bool empty() const { return curves().empty(); }

  const PlotColors& colors() const;
  QPen pen_of(std::string_view css_class) const;
  QColor ink() const;
  QColor ink_soft() const;
  QColor line() const;

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
  /// Draws the legend, or with no painter only finds its height.
  double legend(QPainter* painter, bool brief) const;
  void draw_cursor(QPainter& painter) const;

  std::optional<double> cursor_;
};

/// What a plot of core says of itself.
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
