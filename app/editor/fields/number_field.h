// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDoubleSpinBox>
#include <QWidget>

#include "app/editor/fields/press_id.h"

class QLabel;
class QSlider;
class QToolButton;

namespace etak::editor {

/// A spin box whose wheel is coarse with Ctrl (10 steps) and fine with Shift (a tenth), and that shows the
/// shortest number that is near enough.
class FineSpinBox : public QDoubleSpinBox {
  Q_OBJECT

 public:
  explicit FineSpinBox(QWidget* parent = nullptr);
  QString textFromValue(double value) const override;
  QSize minimumSizeHint() const override;
  QSize sizeHint() const override { return minimumSizeHint(); }

  /// Shows a value without saying that it was edited.
  void show_value(double value);

 signals:
  void edited(double value, int press_id);

 protected:
  void wheelEvent(QWheelEvent* event) override;
  void stepBy(int steps) override;

 private:
  void tell(int press_id);
  WheelPress wheel_;
  int step_press_ = 0;
  bool showing_ = false;
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
  QSlider& slider() { return *slider_; }

 signals:
  void edited(double value, int press_id);
  void reset_asked();

 private:
  double of_slider(int position) const;
  int to_slider(double value) const;

  double least_, most_, standard_;
  bool by_ratio_, own_reset_ = true;
  int press_ = 0;
  QSlider* slider_;
  FineSpinBox* box_;
};

}  // namespace etak::editor
