// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QBoxLayout>
#include <QToolButton>

namespace etak::editor {

/// A new button at the end of a row.
///   name   accessible name; empty: the tip
template <class Button = QToolButton>
Button* add_button(QBoxLayout& row, const QString& text, const QString& tip, const QString& name = {}) {
  auto* out = new Button(row.parentWidget());
  out->setText(text);
  out->setToolTip(tip);
  out->setAccessibleName(name.isEmpty() ? tip : name);
  row.addWidget(out);
  return out;
}

}  // namespace etak::editor
