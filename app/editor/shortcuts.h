// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

class QMainWindow;

namespace etak::editor {

/// A list of all keys and mouse gestures of the editor: the shortcuts of the window's actions, and the
/// gestures of viewport, fields and lists.
class ShortcutsDialog : public QDialog {
  Q_OBJECT

 public:
  explicit ShortcutsDialog(const QMainWindow& window, QWidget* parent = nullptr);
};

}  // namespace etak::editor
