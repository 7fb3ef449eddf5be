// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <array>

#include "core/color/rgb.h"

class QLabel;
class QLineEdit;
class QSpinBox;
class QToolButton;

namespace etak::editor {

class FineSpinBox;

/// A colour as linear numbers (which may leave 0..1), as 8-bit sRGB and as hexadecimal text, all in step,
/// with a swatch, an eyedropper and a badge where 8 bits cannot hold it.
class ColorField : public QWidget {
  Q_OBJECT

 public:
  ColorField(const QString& name, const LinearRgb& standard, QWidget* parent = nullptr);

  const LinearRgb& color() const { return color_; }
  void show_color(const LinearRgb& color);
  /// Where the colour comes from, when not from here: the numbers are then shown and not typed over.
  void set_locked(bool locked, const QString& why = {});

 signals:
  void edited(const etak::LinearRgb& color, int press_id);

 private:
  void take(const LinearRgb& color, int press_id);
  void show_all();

  QString name_;
  LinearRgb color_, standard_;
  std::array<FineSpinBox*, 3> linear_{};
  std::array<QSpinBox*, 3> codes_{};
  QLineEdit* hex_ = nullptr;
  QToolButton *swatch_ = nullptr, *dropper_ = nullptr, *reset_ = nullptr;
  QLabel* badge_ = nullptr;
  bool showing_ = false;
};

}  // namespace etak::editor
