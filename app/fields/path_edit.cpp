// SPDX-License-Identifier: Apache-2.0
#include "app/fields/path_edit.h"

#include <QPainter>
#include <QStyle>
#include <QStyleOptionFrame>

namespace etak::editor {

QRect PathEdit::text_place() const {
  QStyleOptionFrame option;
  initStyleOption(&option);
  constexpr int beside = 2;  // the margin that QLineEdit has
  return style()->subElementRect(QStyle::SE_LineEditContents, &option, this).adjusted(beside, 0, -beside, 0);
}

QString PathEdit::shown_text() const {
  return fontMetrics().elidedText(text(), Qt::ElideMiddle, text_place().width());
}

void PathEdit::paintEvent(QPaintEvent* event) {
  const QString cut = shown_text();
  if (hasFocus() || cut == text()) return QLineEdit::paintEvent(event);
  QPainter painter(this);
  QStyleOptionFrame option;
  initStyleOption(&option);
  style()->drawPrimitive(QStyle::PE_PanelLineEdit, &option, &painter, this);
  painter.setPen(palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::Text));
  painter.drawText(text_place(), Qt::AlignLeft | Qt::AlignVCenter, cut);
}

QString short_path(const QString& path) {
  constexpr int most = 60;
  if (path.size() <= most) return path;
  // The end of the path gets more characters than its start.
  constexpr int start = 20;
  return path.left(start) + QChar(0x2026) + path.right(most - start - 1);
}

}  // namespace etak::editor
