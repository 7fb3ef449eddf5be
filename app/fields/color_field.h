// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <array>

#include "core/color/rgb.h"

class QGridLayout;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QToolButton;

namespace etak::editor {

class FineSpinBox;

/// A field for a colour, shown as linear numbers (which may leave 0..1), as 8-bit sRGB and as hexadecimal
/// text, with a swatch and an eyedropper. Where 8 bits cannot hold the colour, a badge tells by how much, and
/// offers to clip each channel or to bring the colour into range with its hue kept.
class ColorField : public QWidget {
  Q_OBJECT

 public:
  ColorField(const QString& name, const LinearRgb& standard, QWidget* parent = nullptr);

  const LinearRgb& color() const { return color_; }
  void show_color(const LinearRgb& color);
  const LinearRgb& standard() const { return standard_; }
  /// After this call the reset button only emits reset_asked(), and the owner sets the colour. Otherwise the
  /// button sets the standard colour of the constructor.
  void leave_reset_to_owner() { own_reset_ = false; }
  /// Leaves the place of the badge empty while it is hidden, so that the fields below do not move when it comes.
  void keep_place_of_badge();
  /// Adds a button that emits asked().
  void offer_question(const QString& tip);

 signals:
  void edited(const etak::LinearRgb& color, int press_id);
  void reset_asked();
  void asked();

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
  QHBoxLayout* buttons_ = nullptr;
  QWidget* outside_ = nullptr;
  QLabel* badge_ = nullptr;
  bool showing_ = false, own_reset_ = true;
};

}  // namespace etak::editor
