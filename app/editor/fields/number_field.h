// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDoubleSpinBox>
#include <QSlider>
#include <QSpinBox>
#include <QWidget>

#include "app/editor/fields/press_id.h"

class QLabel;
class QToolButton;

namespace etak::editor {

/// A spin box whose wheel is coarse with Ctrl (10 steps) and fine with Shift (a tenth), and that shows the
/// shortest number that is near enough. The wheel edits only while the box has the focus; the rounded text is
/// never read back as a value; steps that follow each other closely share a press id.
class FineSpinBox : public QDoubleSpinBox {
  Q_OBJECT

 public:
  explicit FineSpinBox(QWidget* parent = nullptr);
  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;
  QSize minimumSizeHint() const override;
  QSize sizeHint() const override { return minimumSizeHint(); }

  /// Shows a value without saying that it was edited.
  void show_value(double value);
  /// Whether there is text that was typed and is not the value yet.
  bool is_typed_in() const;

 signals:
  void edited(double value, int press_id);

 protected:
  void wheelEvent(QWheelEvent* event) override;
  void stepBy(int steps) override;

 private:
  void tell(int press_id);
  RepeatedPress steps_;
  int step_press_ = 0;
  bool showing_ = false;
};

/// A spin box for whole numbers that lets the wheel scroll the page around it, unless it has the focus.
class QuietSpinBox : public QSpinBox {
  Q_OBJECT

 public:
  explicit QuietSpinBox(QWidget* parent = nullptr);

 protected:
  void wheelEvent(QWheelEvent* event) override;
};

/// A slider that goes where its groove is clicked, and leaves the wheel to the page around it unless it has
/// the focus. A drag is one press, and so are steps of wheel or keys that follow each other closely.
class FieldSlider : public QSlider {
  Q_OBJECT

 public:
  explicit FieldSlider(QWidget* parent = nullptr);

 signals:
  void edited(int position, int press_id);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  RepeatedPress steps_;
  int press_ = 0;
};

/// A name, a slider, a number and a way back: one parameter.
class NumberField : public QWidget {
  Q_OBJECT

 public:
  /// The slider runs from `least` to `most`, by ratios where both are above 0 and a thousandfold apart.
  NumberField(const QString& name, double least, double most, double standard, QWidget* parent = nullptr);

  double value() const;
  void show_value(double value);
  /// Whoever answers reset_asked() shows the value to go back to; without this it is the standard of the
  /// constructor.
  void leave_reset_to_owner() { own_reset_ = false; }
  FineSpinBox& box() { return *box_; }
  FieldSlider& slider() { return *slider_; }

 signals:
  void edited(double value, int press_id);
  void reset_asked();

 private:
  double of_slider(int position) const;
  int to_slider(double value) const;

  double least_, most_, standard_;
  bool by_ratio_, own_reset_ = true;
  FieldSlider* slider_;
  FineSpinBox* box_;
};

}  // namespace etak::editor
