// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

#include "app/document/dropped_pictures.h"

class QCheckBox;
class QDialogButtonBox;
class QLabel;
class QTableWidget;

namespace etak::editor {

/// What goes where of dropped pictures, before anything is taken: for each quantity of a file what it is read as, the
/// channel that it goes to or that it is skipped, and its colour space (of a normal map which way its green points).
class DropTable : public QDialog {
  Q_OBJECT

 public:
  ///   onto   name of the material that a single set goes onto, unless a new one is wanted; empty: new ones are made
  DropTable(DroppedPictures dropped, const QString& onto, QWidget* parent);
  /// The rows as the user has chosen them.
  const DroppedPictures& dropped() const { return dropped_; }
  bool makes_new() const;

 private:
  void fill();
  void add_channels(int row);
  void add_space(int row);
  void check();

  DroppedPictures dropped_;
  QTableWidget* table_;
  QCheckBox* fresh_;
  QLabel* note_;
  QDialogButtonBox* buttons_;
};

}  // namespace etak::editor
