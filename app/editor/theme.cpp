// SPDX-License-Identifier: Apache-2.0
#include "app/editor/theme.h"

#include <QApplication>
#include <QPalette>
#include <QStyleFactory>

namespace etak::editor {
namespace {

QPalette palette_of(Theme theme) {
  const bool dark = theme == Theme::dark;
  const auto grey = [](int code) { return QColor(code, code, code); };
  const QColor text = dark ? grey(226) : grey(24), window = dark ? grey(48) : grey(236);
  const QColor accent = dark ? QColor(92, 147, 214) : QColor(34, 94, 168);
  QPalette out;
  out.setColor(QPalette::Window, window);
  out.setColor(QPalette::WindowText, text);
  out.setColor(QPalette::Base, dark ? grey(34) : grey(252));
  out.setColor(QPalette::AlternateBase, dark ? grey(40) : grey(244));
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

void apply_theme(QApplication& application, Theme theme) {
  QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  QApplication::setPalette(palette_of(theme));
  application.setStyleSheet(QStringLiteral(
      "QToolTip { border: 1px solid palette(mid); padding: 3px; }"
      "QToolButton[chip=\"true\"] { border: 1px solid palette(mid); border-radius: 9px; padding: 1px 8px; }"
      "QToolButton[chip=\"true\"]:checked { background: palette(highlight); color: "
      "palette(highlighted-text); }"
      "QToolButton[chip=\"true\"]:focus { border: 1px solid palette(link); }"
      "QLabel[badge=\"true\"] { border-radius: 4px; padding: 1px 5px; background: #c7722a; color: white; }"
      "QLabel[quiet=\"true\"] { color: palette(placeholder-text); }"));
}

bool is_dark(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < 128;
}

QString name(Theme theme) {
  return theme == Theme::dark ? QStringLiteral("dark") : QStringLiteral("light");
}

Theme theme_named(const QString& name) {
  return name == QLatin1String("light") ? Theme::light : Theme::dark;
}

}  // namespace etak::editor
