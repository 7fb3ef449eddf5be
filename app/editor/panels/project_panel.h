// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractListModel>
#include <QSortFilterProxyModel>
#include <QWidget>

#include "app/document/document.h"
#include "app/document/thumbnails.h"
#include "app/document/validator.h"

class QBoxLayout;
class QLabel;
class QLineEdit;
class QListView;

namespace etak::editor {

/// The materials of the project as rows. A badge on its picture says that a material has errors or warnings.
class ProjectModel : public QAbstractListModel {
  Q_OBJECT

 public:
  ProjectModel(Document& document, Thumbnails& thumbnails, Validator& validator, QObject* parent = nullptr);
  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 private:
  QPixmap picture(int row) const;
  Document& document_;
  Thumbnails& thumbnails_;
  Validator& validator_;
};

/// The list of the project's materials: the user selects one, renames it (F2), adds one, and copies or removes
/// those that are marked. A search hides the others, and rows can stand in the order of their names; both change nothing of
/// the project.
class ProjectPanel : public QWidget {
  Q_OBJECT

 public:
  ProjectPanel(Document& document, Thumbnails& thumbnails, Validator& validator, QWidget* parent = nullptr);
  QListView& list() { return *list_; }
  QLineEdit& search() { return *search_; }
  // The selected rows of the project in ascending order; a row that the search hides is not selected.
  std::vector<int> selected() const;
  std::vector<int> in_hand() const;  // the selected rows, or the current one where none is selected

 signals:
  void new_asked();
  void copy_asked();
  void remove_asked();
  void picked();  // a row was clicked, which may be the current one already

 private:
  void show_current();
  void show_marked();
  void make_search(QBoxLayout& column);
  void arrange(const std::function<void()>& change);
  QModelIndex shown_row(int row) const;
  Document& document_;
  ProjectModel model_;
  QSortFilterProxyModel shown_;
  QLineEdit* search_;
  QListView* list_;
  QLabel* marked_;  // what is said where several materials are marked
  bool showing_ = false;
};

}  // namespace etak::editor
