// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <functional>

#include "app/editor/panels/library_model.h"

class QBoxLayout;
class QButtonGroup;
class QLabel;
class QLineEdit;
class QListView;
class QToolButton;

namespace etak::editor {

class FlowLayout;
class LibraryList;

/// The library with a search, classes and pictures. A double click or Return on a material emits wanted(); a
/// material can also be dragged to the viewport or the window.
class LibraryPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LibraryPanel(Thumbnails& thumbnails, QWidget* parent = nullptr);

  void set_library(std::shared_ptr<const MaterialLibrary> library);
  QLineEdit& search() { return *search_; }
  QListView& list();
  QString selected() const;  // id of the selected material; empty: none
  /// The materials that the user has marked with a star, by their ids.
  void show_favourites(const QSet<QString>& favourites);
  /// Moves the selection by so many rows; after the last row comes the first.
  void step(int rows);

 signals:
  void looked_at(const QString& id);  // the user has selected the material: it is to be previewed
  void wanted(const QString& id);     // the material is to be added to the project
  void favourites_changed(const QSet<QString>& favourites);

 protected:
  bool event(QEvent* event) override;

 private:
  void connect_list();
  void make_chips();
  void make_favourites(QBoxLayout& row);
  void show_star();
  void search_for(const QString& text);
  void tell_count();
  void narrow(const std::function<void()>& change);

  std::shared_ptr<const MaterialLibrary> library_;
  LibraryModel model_;
  LibraryFilter filter_;
  QLineEdit* search_;
  LibraryList* list_;
  QWidget* chips_;
  FlowLayout* chip_row_;
  QButtonGroup* chip_group_;
  QLabel *answer_, *count_;
  QSet<QString> favourites_;
  QToolButton *star_ = nullptr, *only_ = nullptr;
  bool narrowing_ = false;
};

}  // namespace etak::editor
