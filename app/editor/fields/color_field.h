// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <array>

#include "core/color/rgb.h"

class QGridLayout;
class QLabel;
class QLineEdit;
class QToolButton;

namespace etak::editor {

class FineSpinBox;

/// A colour as linear numbers (which may leave 0..1), as 8-bit sRGB and as hexadecimal text, all in step,
/// with a swatch, an eyedropper and, where 8 bits cannot hold it, a badge that tells by how much and offers
/// both ways in: each channel clipped, or the hue kept.
class ColorField : public QWidget {
  Q_OBJECT

 public:
  ColorField(const QString& name, const LinearRgb& standard, QWidget* parent = nullptr);

  const LinearRgb& color() const { return color_; }
  void show_color(const LinearRgb& color);
  const LinearRgb& standard() const { return standard_; }
  /// Whoever answers reset_asked() shows the colour to go back to; without this it is the standard of the
  /// constructor.
  void leave_reset_to_owner() { own_reset_ = false; }

 signals:
  void edited(const etak::LinearRgb& color, int press_id);
  void reset_asked();

 private:
  void take(const LinearRgb& color, int press_id);
  FineSpinBox* add_number(QGridLayout* grid, int row, std::size_t channel, const QString& what,
                          double (*linear_of_shown)(double));
  void connect_parts();
  void make_badge();
  void show_all();

  QString name_;
  LinearRgb color_, standard_;
  std::array<FineSpinBox*, 3> linear_{}, codes_{};
  QLineEdit* hex_ = nullptr;
  QToolButton *swatch_ = nullptr, *dropper_ = nullptr, *reset_ = nullptr;
  QWidget* outside_ = nullptr;
  QLabel* badge_ = nullptr;
  bool showing_ = false, own_reset_ = true;
};

}  // namespace etak::editor
