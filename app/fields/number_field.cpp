// SPDX-License-Identifier: Apache-2.0
#include "app/fields/number_field.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "app/fields/add_button.h"
#include "app/fields/field_menu.h"
#include "core/base/number.h"

namespace etak::editor {
namespace {

constexpr int slider_steps = 1000;

}  // namespace

FineSpinBox::FineSpinBox(QWidget* parent) : QDoubleSpinBox(parent) {
  setDecimals(6);
  setSingleStep(0.01);
  setKeyboardTracking(false);
  setFocusPolicy(Qt::StrongFocus);
  setLocale(QLocale::c());
  connect(this, &QDoubleSpinBox::valueChanged, this, [this] {
    if (!showing_) tell(step_press_ != 0 ? step_press_ : next_press_id());
  });
  // Once the value is taken, the document undoes it. Setting the text clears the undo history of the line.
  connect(this, &QDoubleSpinBox::editingFinished, this, [this] {
    if (lineEdit()->isUndoAvailable()) lineEdit()->setText(lineEdit()->text());
  });
}

QString FineSpinBox::textFromValue(double value) const {
  return QString::fromStdString(number(value, 5));
}

double FineSpinBox::valueFromText(const QString& text) const {
  // The text is rounded and the value is not: a text that was not edited does not change the value.
  return text == textFromValue(value()) ? value() : QDoubleSpinBox::valueFromText(text);
}

QSize FineSpinBox::minimumSizeHint() const {
  QSize size = QDoubleSpinBox::minimumSizeHint();
  size.setWidth(fontMetrics().horizontalAdvance("-0.00000") + (buttonSymbols() == NoButtons ? 10 : 28));
  return size;
}

void FineSpinBox::show_value(double value) {
  if (value == this->value()) return;
  showing_ = true;
  setValue(value);
  showing_ = false;
}

bool FineSpinBox::is_typed_in() const {
  return lineEdit()->text() != textFromValue(value());
}

void FineSpinBox::tell(int press_id) {
  emit edited(value(), press_id);
}

void FineSpinBox::stepBy(int steps) {
  step_press_ = steps_.id();
  QDoubleSpinBox::stepBy(steps);
  step_press_ = 0;
}

void FineSpinBox::wheelEvent(QWheelEvent* event) {
  if (!hasFocus()) return event->ignore();
  // Some desktops report Shift + wheel as horizontal.
  const QPoint turn = event->angleDelta();
  const double notches = (turn.y() != 0 ? turn.y() : turn.x()) / 120.0;
  if (notches == 0) return event->ignore();
  const auto keys = event->modifiers();
  const double factor = keys & Qt::ControlModifier ? 10 : keys & Qt::ShiftModifier ? 0.1 : 1;
  double change = notches * factor * singleStep();
  // Whole numbers change by at least 1.
  if (decimals() == 0 && std::abs(change) < 1) change = change < 0 ? -1 : 1;
  step_press_ = steps_.id();
  setValue(value() + change);
  step_press_ = 0;
  event->accept();
}

FieldSlider::FieldSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
  setFocusPolicy(Qt::StrongFocus);
  connect(this, &QSlider::sliderPressed, this, [this] {
    if (press_ == 0) press_ = next_press_id();
  });
  connect(this, &QSlider::sliderReleased, this, [this] { press_ = 0; });
  connect(this, &QSlider::valueChanged, this,
          [this](int position) { emit edited(position, press_ != 0 ? press_ : next_press_id()); });
}

void FieldSlider::mousePressEvent(QMouseEvent* event) {
  QStyleOptionSlider option;
  initStyleOption(&option);
  const QRect handle = style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this);
  const int x = event->position().toPoint().x();
  if (event->button() == Qt::LeftButton && (x < handle.left() || x > handle.right())) {
    const QRect groove = style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderGroove, this);
    // The handle jumps to the cursor, where a drag may follow: jump and drag have the same press id.
    press_ = next_press_id();
    setValue(QStyle::sliderValueFromPosition(minimum(), maximum(), x - groove.x() - handle.width() / 2,
                                             groove.width() - handle.width(), option.upsideDown));
  }
  QSlider::mousePressEvent(event);
  if (!isSliderDown()) press_ = 0;
}

void FieldSlider::wheelEvent(QWheelEvent* event) {
  if (!hasFocus()) return event->ignore();
  press_ = steps_.id();
  QSlider::wheelEvent(event);
  press_ = 0;
}

void FieldSlider::keyPressEvent(QKeyEvent* event) {
  press_ = steps_.id();
  QSlider::keyPressEvent(event);
  press_ = 0;
}

NumberField::NumberField(const QString& name, const FieldRange& range, QWidget* parent)
    : QWidget(parent),
      range_(range),
      by_ratio_(range.least > 0 && range.most / range.least >= 1000),
      slider_(new FieldSlider(this)),
      box_(new FineSpinBox(this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  row->addWidget(slider_, 1);
  row->addWidget(box_);
  auto* reset = add_button(*row, "\u21ba", tr("Reset %1").arg(name));
  reset->setAutoRaise(true);
  slider_->setRange(0, slider_steps);
  slider_->setMinimumWidth(50);
  slider_->setAccessibleName(tr("%1, slider").arg(name));
  box_->setRange(range.typed_least, range.typed_most);
  box_->setSingleStep(by_ratio_ ? range.standard / 20 : (range.most - range.least) / 100);
  box_->setAccessibleName(name);
  setAccessibleName(tr("%1, field").arg(name));
  connect(slider_, &FieldSlider::edited, this, [this](int position, int press_id) {
    const double value = of_slider(position);
    box_->show_value(value);
    emit edited(value, press_id);
  });
  connect(box_, &FineSpinBox::edited, this, [this](double value, int press_id) {
    const QSignalBlocker quiet(slider_);
    slider_->setValue(to_slider(value));
    emit edited(value, press_id);
  });
  connect(reset, &QToolButton::clicked, this, [this] {
    emit reset_asked();
    if (!own_reset_ || value() == range_.standard) return;
    show_value(range_.standard);
    emit edited(range_.standard, next_press_id());
  });
  add_field_menu(*this, {box_, slider_},
                 {{tr("Copy &value"), [this] { return QString::fromStdString(number(value(), 9)); }}},
                 *reset);
  show_value(range.standard);
}

double NumberField::value() const {
  return box_->value();
}

void NumberField::show_value(double value) {
  box_->show_value(value);
  const QSignalBlocker quiet(slider_);
  slider_->setValue(to_slider(value));
}

double NumberField::of_slider(int position) const {
  const double least = range_.least, most = range_.most;
  const double share = static_cast<double>(position) / slider_steps;
  if (by_ratio_) return least * std::pow(most / least, share);
  // The slider gives three decimals, because the hand is no more precise.
  return std::clamp(std::round((least + share * (most - least)) * 1000) / 1000, least, most);
}

int NumberField::to_slider(double value) const {
  const double least = range_.least, most = range_.most, inside = std::clamp(value, least, most);
  const double share =
      by_ratio_ ? std::log(inside / least) / std::log(most / least) : (inside - least) / (most - least);
  return static_cast<int>(std::lround(share * slider_steps));
}

}  // namespace etak::editor
