// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractListModel>
#include <QSet>
#include <QSortFilterProxyModel>
#include <memory>
#include <vector>

#include "app/document/thumbnails.h"
#include "core/material/library.h"

namespace etak::editor {

/// The materials of the library, with those of the project's own spectra.
class LibraryModel : public QAbstractListModel {
  Q_OBJECT

 public:
  enum Role { id_role = Qt::UserRole, class_role, keys_role, names_role };

  LibraryModel(Thumbnails& thumbnails, QObject* parent = nullptr);

  void set_library(std::shared_ptr<const MaterialLibrary> library);
  void set_shape(Shape shape);
  void set_side(int side, double ratio);
  /// The classes of these materials, in the order of material_classes.
  QStringList classes() const;

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  QMimeData* mimeData(const QModelIndexList& indexes) const override;
  QStringList mimeTypes() const override;

 private:
  struct Row {
    QString id, name, material_class, keys;
    QStringList names;    // search keys of id, name and aliases
    bool marked = false;  // the data are computed, sparse or doubtful: the picture gets a dot
  };
  void take_rows(std::vector<Row> next);
  QString about(const Row& row) const;  // name, class, id, and in sentences what the data are worth

  std::shared_ptr<const MaterialLibrary> library_;
  std::vector<Row> rows_;
  Thumbnails& thumbnails_;
  Shape shape_ = Shape::sphere;
  int side_ = 64;
  double ratio_ = 1;
};

/// The rows that match a search and a class. Every word of the search must occur in id, name, aliases, group
/// or class. Materials whose id, name or alias equals the search come first, then those where it begins so,
/// then those where a later word begins so.
class LibraryFilter : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  explicit LibraryFilter(QObject* parent = nullptr);
  ///   near   ids of materials, nearest first, that are shown in place of what matches; none: what matches is
  void set_search(const QString& text, const QStringList& near = {});
  void set_class(const QString& material_class);  // empty: all
  ///   only   no others are shown
  void set_favourites(const QSet<QString>& favourites, bool only);

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

 private:
  int rank(const QModelIndex& row) const;  // 0 is the best match

  QStringList words_, near_;
  QString class_;
  QSet<QString> favourites_;
  bool only_favourites_ = false;
};

/// The form of a text that a search compares: lower case, without diacritical marks, blanks for '_' and '-'.
QString search_key(const QString& text);

}  // namespace etak::editor
