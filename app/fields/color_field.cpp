// SPDX-License-Identifier: Apache-2.0
#include "app/fields/color_field.h"

#include <QColorDialog>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>

#include "app/fields/add_button.h"
#include "app/fields/eyedropper.h"
#include "app/fields/field_menu.h"
#include "app/fields/number_field.h"
#include "app/viewport/qt_picture.h"
#include "core/base/error.h"
#include "core/base/number.h"
#include "core/color/gamut.h"
#include "core/color/srgb.h"
#include "core/exchange/export_surface.h"

namespace etak::editor {
namespace {

const std::array<QString, 3>& channel_words() {
  static const std::array<QString, 3> words{QObject::tr("red"), QObject::tr("green"), QObject::tr("blue")};
  return words;
}

double& part(LinearRgb& color, std::size_t c) {
  return c == 0 ? color.r : c == 1 ? color.g : color.b;
}

LinearRgb linear_of(const QColor& color) {
  return srgb_decode(Srgb8{static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()),
                           static_cast<std::uint8_t>(color.blue())});
}

}  // namespace

ColorField::ColorField(const QString& name, const LinearRgb& standard, QWidget* parent)
    : QWidget(parent), name_(name), color_(standard), standard_(standard) {
  setAccessibleName(tr("%1, colour").arg(name));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(4);
  grid->setVerticalSpacing(2);

  swatch_ = new QToolButton(this);
  swatch_->setIconSize({34, 34});
  swatch_->setToolTip(tr("%1: choose in a dialog").arg(name));
  swatch_->setAccessibleName(tr("%1, choose").arg(name));
  grid->addWidget(swatch_, 0, 0, 2, 1);
  for (int row = 0; row < 2; ++row) {
    auto* label = new QLabel(row == 0 ? tr("lin") : tr("8 bit"), this);
    label->setProperty("quiet", true);
    grid->addWidget(label, row, 1);
  }
  // The boxes are made line by line, because the Tab key goes through them in the order in which they are made.
  for (std::size_t c = 0; c < 3; ++c) {
    linear_[c] = add_number(grid, 0, c, tr("linear"), [](double value) { return value; });
    linear_[c]->setRange(0, 1000);
    linear_[c]->setToolTip(
        tr("%1, linear; in the field the wheel edits, Ctrl coarse, Shift fine").arg(channel_words()[c]));
  }
  for (std::size_t c = 0; c < 3; ++c) {
    // An edit of a code sets one channel; the others keep their values, which 8 bits would round.
    codes_[c] = add_number(grid, 1, c, tr("sRGB 8 bit"), [](double code) { return srgb_decode(code / 255); });
    codes_[c]->setToolTip(tr("%1 as a code of 8-bit sRGB").arg(channel_words()[c]));
    codes_[c]->setDecimals(0);
    codes_[c]->setSingleStep(1);
    codes_[c]->setRange(0, 255);
  }
  auto* line = buttons_ = new QHBoxLayout;
  grid->addLayout(line, 2, 1, 1, 4);
  line->setSpacing(4);
  hex_ = new QLineEdit(this);
  hex_->setMaxLength(9);
  hex_->setAccessibleName(tr("%1, hexadecimal").arg(name));
  hex_->setToolTip(tr("%1 as a code of 8-bit sRGB: #RRGGBB").arg(name));
  hex_->setFixedWidth(fontMetrics().horizontalAdvance("#wwwwww") + 16);
  line->addWidget(hex_);
  dropper_ = add_button(*line, tr("Pick"), tr("Take a colour from anywhere on the screen (Esc: none)"),
                        tr("%1, eyedropper").arg(name));
  reset_ = add_button(*line, "\u21ba", tr("Reset %1").arg(name));
  reset_->setAutoRaise(true);
  line->addStretch(1);
  make_badge();
  grid->addWidget(outside_, 3, 0, 1, 5);
  for (int c = 2; c < 5; ++c) grid->setColumnStretch(c, 1);

  connect_parts();
  QList<QWidget*> parts{swatch_, hex_};
  for (std::size_t c = 0; c < 3; ++c) parts << linear_[c] << codes_[c];
  add_field_menu(*this, parts,
                 {{tr("Copy &linear value"),
                   [this] {
                     return QString::fromStdString(number(color_.r, 9) + ", " + number(color_.g, 9) + ", " +
                                                   number(color_.b, 9));
                   }},
                  {tr("Copy as he&xadecimal"), [this] { return hex_->text(); }}},
                 *reset_);
  show_all();
}

void ColorField::offer_question(const QString& tip) {
  auto* ask = new QToolButton(this);
  ask->setText("?");
  ask->setToolTip(tip);
  ask->setAccessibleName(tip);
  buttons_->insertWidget(buttons_->indexOf(reset_), ask);
  connect(ask, &QToolButton::clicked, this, &ColorField::asked);
}

FineSpinBox* ColorField::add_number(QGridLayout* grid, int row, std::size_t channel, const QString& what,
                                    double (*linear_of_shown)(double)) {
  auto* out = new FineSpinBox(this);
  out->setButtonSymbols(QAbstractSpinBox::NoButtons);
  out->setAccessibleName(tr("%1, %2, %3").arg(name_, channel_words()[channel], what));
  grid->addWidget(out, row, 2 + static_cast<int>(channel));
  connect(out, &FineSpinBox::edited, this, [this, channel, linear_of_shown](double value, int press_id) {
    LinearRgb next = color_;
    part(next, channel) = linear_of_shown(value);
    take(next, press_id);
  });
  return out;
}

void ColorField::connect_parts() {
  connect(hex_, &QLineEdit::editingFinished, this, [this] {
    if (showing_) return;
    try {
      const Srgb8 typed = parse_hex(hex_->text().trimmed().toStdString());
      // Codes that equal the shown ones are not read back, because the colour is more precise than they are.
      if (typed != srgb_u8(color_)) return take(srgb_decode(typed), next_press_id());
    } catch (const Error&) {
    }
    show_all();  // the text is no colour, or the present one
  });
  connect(reset_, &QToolButton::clicked, this, [this] {
    if (own_reset_) return take(standard_, next_press_id());
    emit reset_asked();
  });
  connect(dropper_, &QToolButton::clicked, this, [this] {
    new Eyedropper(this, [this](std::optional<QColor> picked) {
      if (picked) take(linear_of(*picked), next_press_id());
    });
  });
  connect(swatch_, &QToolButton::clicked, this, [this] {
    auto* dialog = new QColorDialog(qt_color(srgb_u8(color_)), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setOption(QColorDialog::DontUseNativeDialog);
    dialog->setWindowTitle(name_);
    const int press = next_press_id();
    connect(dialog, &QColorDialog::currentColorChanged, this,
            [this, press](const QColor& c) { take(linear_of(c), press); });
    const LinearRgb before = color_;
    connect(dialog, &QColorDialog::rejected, this, [this, before, press] { take(before, press); });
    dialog->open();
  });
}

void ColorField::make_badge() {
  outside_ = new QWidget(this);
  outside_->setAccessibleName(tr("%1, outside sRGB").arg(name_));
  auto* line = new QHBoxLayout(outside_);
  line->setContentsMargins(0, 2, 0, 0);
  line->setSpacing(4);
  badge_ = new QLabel(outside_);
  badge_->setProperty("badge", true);
  badge_->setAccessibleName(tr("%1, gamut").arg(name_));
  badge_->setWordWrap(true);
  badge_->setToolTip(
      tr("8-bit sRGB holds linear 0 to 1: the codes above are clipped, the linear numbers are not"));
  line->addWidget(badge_, 1);
  const auto way = [&](const QString& text, const QString& what, Fit fit) {
    auto* out =
        add_button(*line, text, tr("%1 (the colour is then a typed one; undo brings it back)").arg(what),
                   tr("%1: %2").arg(name_, what));
    connect(out, &QToolButton::clicked, this, [this, fit] {
      Changes changes;
      take(fitted(color_, {fit, 1, RgbSpace::srgb}, {}, {}, changes), next_press_id());
    });
  };
  way(tr("Clip"), tr("clip each channel to 0..1"), Fit::clamp);
  way(tr("Keep hue"), tr("bring it into 0..1 with the hue kept, darker or greyer"), Fit::preserve_hue);
  outside_->hide();
}

void ColorField::keep_place_of_badge() {
  QSizePolicy policy = outside_->sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  outside_->setSizePolicy(policy);
}

void ColorField::show_color(const LinearRgb& color) {
  if (color == color_) return;
  color_ = color;
  show_all();
}

void ColorField::take(const LinearRgb& color, int press_id) {
  if (color == color_) return show_all();
  color_ = color;
  show_all();
  emit edited(color_, press_id);
}

void ColorField::show_all() {
  showing_ = true;
  const Srgb8 codes = srgb_u8(color_);
  const std::array<int, 3> numbers{codes.r, codes.g, codes.b};
  for (std::size_t c = 0; c < 3; ++c) {
    // A channel below 0 (out of gamut) is shown as it is, but steps from above do not go below 0.
    const QSignalBlocker quiet(linear_[c]);
    linear_[c]->setMinimum(std::min(0.0, part(color_, c)));
    linear_[c]->show_value(part(color_, c));
    codes_[c]->show_value(numbers[c]);
  }
  hex_->setText(QString::fromStdString(hex(codes)));
  QPixmap swatch(swatch_->iconSize() * devicePixelRatioF());
  swatch.setDevicePixelRatio(devicePixelRatioF());
  swatch.fill(qt_color(codes));
  swatch_->setIcon(untinted_icon(swatch));
  const std::string outside = gamut_text(color_);
  outside_->setVisible(!outside.empty());
  if (!outside.empty()) {
    // Blanks that do not break keep a channel and its number on the same line.
    QStringList channels = QString::fromStdString(outside).split(", ");
    channels.replaceInStrings(" ", QString(QChar(QChar::Nbsp)));
    badge_->setText(tr("outside sRGB: %1").arg(channels.join(", ")));
  }
  showing_ = false;
}

}  // namespace etak::editor
