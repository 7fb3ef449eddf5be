// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

class QMainWindow;

namespace etak::editor {

/// Every key and mouse gesture of the editor: those of the menus as they are, and those of viewport and
/// fields.
class ShortcutsDialog : public QDialog {
  Q_OBJECT

 public:
  explicit ShortcutsDialog(const QMainWindow& window, QWidget* parent = nullptr);
};

}  // namespace etak::editor
