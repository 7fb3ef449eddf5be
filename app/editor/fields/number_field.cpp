// SPDX-License-Identifier: Apache-2.0
#include "app/editor/fields/number_field.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

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
}

QString FineSpinBox::textFromValue(double value) const {
  return QString::fromStdString(number(value, 5));
}

QSize FineSpinBox::minimumSizeHint() const {
  QSize size = QDoubleSpinBox::minimumSizeHint();
  size.setWidth(fontMetrics().horizontalAdvance(QStringLiteral("-0.00000")) +
                (buttonSymbols() == NoButtons ? 10 : 28));
  return size;
}

void FineSpinBox::show_value(double value) {
  if (value == this->value()) return;
  showing_ = true;
  setValue(value);
  showing_ = false;
}

void FineSpinBox::tell(int press_id) {
  emit edited(value(), press_id);
}

void FineSpinBox::stepBy(int steps) {
  // Keys and buttons that repeat are one press each; they are few.
  QDoubleSpinBox::stepBy(steps);
}

void FineSpinBox::wheelEvent(QWheelEvent* event) {
  // Some desktops turn Shift + wheel sideways.
  const QPoint turn = event->angleDelta();
  const double notches = (turn.y() != 0 ? turn.y() : turn.x()) / 120.0;
  if (notches == 0) return event->ignore();
  const auto keys = event->modifiers();
  const double factor = keys & Qt::ControlModifier ? 10 : keys & Qt::ShiftModifier ? 0.1 : 1;
  double change = notches * factor * singleStep();
  // Whole numbers have no tenth of a step.
  if (decimals() == 0 && std::abs(change) < 1) change = change < 0 ? -1 : 1;
  step_press_ = wheel_.id();
  setValue(value() + change);
  step_press_ = 0;
  event->accept();
}

NumberField::NumberField(const QString& name, double least, double most, double standard, QWidget* parent)
    : QWidget(parent),
      least_(least),
      most_(most),
      standard_(standard),
      by_ratio_(least > 0 && most / least >= 1000),
      slider_(new QSlider(Qt::Horizontal, this)),
      box_(new FineSpinBox(this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  auto* reset = new QToolButton(this);
  reset->setText(QStringLiteral("\u21ba"));
  reset->setAutoRaise(true);
  reset->setToolTip(tr("Reset %1").arg(name));
  reset->setAccessibleName(tr("Reset %1").arg(name));
  row->addWidget(slider_, 1);
  row->addWidget(box_);
  row->addWidget(reset);
  slider_->setRange(0, slider_steps);
  slider_->setMinimumWidth(50);
  slider_->setAccessibleName(tr("%1, slider").arg(name));
  slider_->setFocusPolicy(Qt::StrongFocus);
  box_->setRange(least, most);
  box_->setSingleStep(by_ratio_ ? standard / 20 : (most - least) / 100);
  box_->setAccessibleName(name);
  setAccessibleName(tr("%1, field").arg(name));
  connect(slider_, &QSlider::sliderPressed, this, [this] { press_ = next_press_id(); });
  connect(slider_, &QSlider::sliderReleased, this, [this] { press_ = 0; });
  connect(slider_, &QSlider::valueChanged, this, [this](int position) {
    const double value = of_slider(position);
    box_->show_value(value);
    emit edited(value, press_ != 0 ? press_ : next_press_id());
  });
  connect(box_, &FineSpinBox::edited, this, [this](double value, int press_id) {
    const QSignalBlocker quiet(slider_);
    slider_->setValue(to_slider(value));
    emit edited(value, press_id);
  });
  connect(reset, &QToolButton::clicked, this, [this] {
    emit reset_asked();
    if (!own_reset_ || value() == standard_) return;
    show_value(standard_);
    emit edited(standard_, next_press_id());
  });
  show_value(standard);
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
  const double share = static_cast<double>(position) / slider_steps;
  const double value =
      by_ratio_ ? least_ * std::pow(most_ / least_, share) : least_ + share * (most_ - least_);
  // Three digits are what a hand can mean.
  const double rounded = std::round(value * 1000) / 1000;
  return by_ratio_ ? value : std::clamp(rounded, least_, most_);
}

int NumberField::to_slider(double value) const {
  const double inside = std::clamp(value, least_, most_);
  const double share =
      by_ratio_ ? std::log(inside / least_) / std::log(most_ / least_) : (inside - least_) / (most_ - least_);
  return static_cast<int>(std::lround(share * slider_steps));
}

}  // namespace etak::editor
