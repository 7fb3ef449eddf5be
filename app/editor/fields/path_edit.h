// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLineEdit>

namespace etak::editor {

/// A line for a path. While nobody types in it, a path that is too long for it is cut in its middle by an
/// ellipsis, so that its end, the file's name, is seen.
class PathEdit : public QLineEdit {
  Q_OBJECT

 public:
  using QLineEdit::QLineEdit;
  /// What is seen while the line has no focus.
  QString shown_text() const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QRect text_place() const;
};

/// A path for messages and menus, cut in its middle by an ellipsis where it is over 60 characters long.
QString short_path(const QString& path);

}  // namespace etak::editor
