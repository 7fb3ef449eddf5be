// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLineEdit>

namespace etak::editor {

/// A line for a path. While the line has no focus, an ellipsis replaces the middle of a path that is too
/// long, so that its end, the name of the file, is visible.
class PathEdit : public QLineEdit {
  Q_OBJECT

 public:
  using QLineEdit::QLineEdit;
  /// The text that is visible while the line has no focus.
  QString shown_text() const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QRect text_place() const;
};

/// A path for messages and menus. Where it has more than 60 characters, an ellipsis replaces its middle.
QString short_path(const QString& path);

}  // namespace etak::editor
