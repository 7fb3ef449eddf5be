// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "app/editor/panels/library_model.h"

class QButtonGroup;
class QLabel;
class QLineEdit;
class QListView;

namespace etak::editor {

class FlowLayout;

/// The library: search, classes, pictures. A double click, Return or a drag puts a material to use.
class LibraryPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LibraryPanel(Thumbnails& thumbnails, QWidget* parent = nullptr);

  void set_library(std::shared_ptr<const MaterialLibrary> library);
  QLineEdit& search() { return *search_; }
  QListView& list() { return *list_; }
  QString selected() const;  // id; empty: none
  /// Puts the selection on the row after or before; wraps around.
  void step(int rows);

 signals:
  void looked_at(const QString& id);  // selected
  void wanted(const QString& id);     // to be added to the project

 private:
  void connect_list();
  void make_chips();
  void tell_count();

  std::shared_ptr<const MaterialLibrary> library_;
  LibraryModel model_;
  LibraryFilter filter_;
  QLineEdit* search_;
  QListView* list_;
  QWidget* chips_;
  FlowLayout* chip_row_;
  QButtonGroup* chip_group_;
  QLabel* count_;
};

}  // namespace etak::editor
