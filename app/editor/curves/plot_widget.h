// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <optional>
#include <string>
#include <vector>

#include "core/report/plot_file.h"

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
  /// A name and its value at the cursor.
  struct Reading {
    QString name;
    double value = 0;
    QColor color;
    QPointF place;  // of the value, in the widget
  };

  // What a kind of plot says of itself.
  virtual std::string csv_of() const = 0;
  virtual std::string svg_of(bool dark) const = 0;
  virtual const std::vector<PlotKey>& keys() const = 0;
  virtual std::string title() const = 0;
  virtual std::string description() const = 0;
  virtual bool empty() const = 0;
  /// Axes and curves inside `area`, below the legend.
  virtual void draw(QPainter& painter, const QRectF& area) = 0;
  /// The cursor's place of a point in the widget; none outside of the plot.
  virtual std::optional<double> place_at(QPointF point) const = 0;
  virtual std::vector<Reading> readings(double at) const = 0;
  /// "450 nm".
  virtual QString place_text(double at) const = 0;
  /// Both ends of the cursor's line at a place.
  virtual QLineF cursor_line(double at) const = 0;
  /// Where the cursor can be: least and most.
  virtual std::pair<double, double> range() const = 0;

  /// To be called when the plot is another.
  void plot_changed();

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
  bool dark() const;
  /// Draws the legend, or with no painter only finds its height.
  double legend(QPainter* painter, bool brief) const;
  void draw_cursor(QPainter& painter) const;

  std::optional<double> cursor_;
};

}  // namespace etak::editor
