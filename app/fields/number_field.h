// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDoubleSpinBox>
#include <QSlider>
#include <QWidget>

#include "app/document/press_id.h"

namespace etak::editor {

/// A spin box that shows five significant digits. The wheel edits only while the box has the focus: one step,
/// with Ctrl ten steps, with Shift a tenth of a step. The rounded text is never read back as a value. Steps
/// that follow each other closely have the same press id.
class FineSpinBox : public QDoubleSpinBox {
  Q_OBJECT

 public:
  explicit FineSpinBox(QWidget* parent = nullptr);
  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;
  QSize minimumSizeHint() const override;
  QSize sizeHint() const override { return minimumSizeHint(); }

  /// Shows a value without emitting edited().
  void show_value(double value);
  /// Whether the box holds a typed text that is not taken as the value yet.
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

/// A slider that jumps to where its groove is clicked. Without the focus it leaves the wheel to the page
/// around it. All edits of a drag have the same press id; so have steps of wheel or keys that follow each
/// other closely.
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

/// The numbers of a field.
struct FieldRange {
  double least, most, standard;                   // ends of the slider, and what the button resets to
  double typed_least = least, typed_most = most;  // of what can be typed
};

/// A field for one parameter: a slider, a number and a button to reset it.
class NumberField : public QWidget {
  Q_OBJECT

 public:
  /// The slider runs in equal ratios where its least is above 0 and its most at least a thousand times as large,
  /// else in equal steps.
  NumberField(const QString& name, const FieldRange& range, QWidget* parent = nullptr);

  double value() const;
  void show_value(double value);
  /// After this call the reset button only emits reset_asked(), and the owner sets the value. Otherwise the
  /// button sets the standard value of the constructor.
  void leave_reset_to_owner() { own_reset_ = false; }
  FineSpinBox& box() { return *box_; }
  FieldSlider& slider() { return *slider_; }

 signals:
  void edited(double value, int press_id);
  void reset_asked();

 private:
  double of_slider(int position) const;
  int to_slider(double value) const;

  FieldRange range_;
  bool by_ratio_, own_reset_ = true;
  FieldSlider* slider_;
  FineSpinBox* box_;
};

}  // namespace etak::editor
