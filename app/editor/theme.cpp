// SPDX-License-Identifier: Apache-2.0
#include "app/editor/theme.h"

#include <QApplication>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleOption>

namespace etak::editor {
namespace {

// Fusion with an outline around check boxes, because it draws an empty box in a colour that can hardly be
// seen on a dark window.
class OutlinedBoxes : public QProxyStyle {
 public:
  OutlinedBoxes() : QProxyStyle("Fusion") {}
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    if (element != PE_IndicatorCheckBox) return;
    painter->save();
    painter->setBrush(Qt::NoBrush);
    painter->setPen(option->palette.color(QPalette::PlaceholderText));
    painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
    painter->restore();
  }
};

QPalette palette_of(Theme theme) {
  const bool dark = theme == Theme::dark;
  const auto grey = [](int code) { return QColor(code, code, code); };
  const QColor text = dark ? grey(226) : grey(24), window = dark ? grey(50) : grey(236);
  const QColor accent = dark ? QColor(92, 147, 214) : QColor(34, 94, 168);
  QPalette out;
  out.setColor(QPalette::Window, window);
  out.setColor(QPalette::WindowText, text);
  out.setColor(QPalette::Base, dark ? grey(28) : grey(252));
  out.setColor(QPalette::AlternateBase, dark ? grey(35) : grey(244));
  out.setColor(QPalette::Text, text);
  out.setColor(QPalette::Button, dark ? grey(60) : grey(228));
  out.setColor(QPalette::ButtonText, text);
  out.setColor(QPalette::BrightText, QColor(255, 120, 100));
  out.setColor(QPalette::ToolTipBase, dark ? grey(66) : grey(255));
  out.setColor(QPalette::ToolTipText, text);
  out.setColor(QPalette::PlaceholderText, dark ? grey(150) : grey(110));
  out.setColor(QPalette::Link, dark ? QColor(125, 178, 240) : QColor(20, 80, 160));
  out.setColor(QPalette::Highlight, accent);
  out.setColor(QPalette::HighlightedText, dark ? grey(10) : grey(255));
  out.setColor(QPalette::Light, dark ? grey(78) : grey(255));
  out.setColor(QPalette::Midlight, dark ? grey(66) : grey(246));
  out.setColor(QPalette::Mid, dark ? grey(38) : grey(190));
  out.setColor(QPalette::Dark, dark ? grey(28) : grey(160));
  out.setColor(QPalette::Shadow, dark ? grey(12) : grey(100));
  for (const auto role : {QPalette::Text, QPalette::ButtonText, QPalette::WindowText})
    out.setColor(QPalette::Disabled, role, dark ? grey(124) : grey(140));
  out.setColor(QPalette::Disabled, QPalette::Highlight, dark ? grey(80) : grey(180));
  return out;
}

}  // namespace

Theme desktop_theme() {
  const QPalette own = QApplication::palette();
  QApplication::setPalette(QPalette());
  const Theme out = is_dark(QApplication::palette()) ? Theme::dark : Theme::light;
  QApplication::setPalette(own);
  return out;
}

void apply_theme(QApplication& application, Theme theme) {
  QApplication::setStyle(new OutlinedBoxes);
  QApplication::setPalette(palette_of(theme));
  // No role of the palette has enough contrast to the window in both themes.
  const QString border = theme == Theme::dark ? "#707070" : "#a8a8a8";
  application.setStyleSheet(
      QStringLiteral(
          "QToolTip { border: 1px solid palette(mid); padding: 3px; }QToolButton[chip=\"true\"] { border: 1px solid %1; border-radius: 9px; padding: 1px 8px; }QToolButton[chip=\"true\"]:checked { background: palette(highlight); color: "
          "palette(highlighted-text); }QToolButton[chip=\"true\"]:focus { border: 1px solid palette(link); }QLabel[badge=\"true\"] { border-radius: 4px; padding: 1px 5px; background: #a8560f; color: white; }"
          "QLabel[quiet=\"true\"] { color: palette(placeholder-text); }")
          .arg(border));
}

bool is_dark(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < 128;
}

QString name(Theme theme) {
  return theme == Theme::dark ? "dark" : "light";
}

Theme theme_named(const QString& name) {
  return name == "light" ? Theme::light : name == "dark" ? Theme::dark : desktop_theme();
}

}  // namespace etak::editor
