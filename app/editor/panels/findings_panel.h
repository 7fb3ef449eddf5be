// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>
#include <QWidget>

#include "app/document/validator.h"

class QLabel;
class QToolButton;
class QTreeView;

namespace etak::editor {

/// The findings of the validator as rows, those of a rule together. Rows that are found again stay the rows that
/// they are, so that a view keeps what is marked in it.
class FindingsModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { severity_column, rule_column, material_column, message_column, column_count };
  using QAbstractTableModel::QAbstractTableModel;
  void set_findings(const std::map<std::string, std::vector<Finding>>& findings);
  const Finding* at(int row) const;
  std::array<std::size_t, 4> counts() const;  // errors, warnings, infos, muted

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  void remove_row(std::size_t at);
  std::vector<Finding> rows_;
};

/// The list of findings. A double click or Return on a row emits go_to(), which shows the field of the
/// finding and its texels. Buttons repair what the marked one is about, and mute it with a reason.
class FindingsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit FindingsPanel(Validator& validator, QWidget* parent = nullptr);
  QTreeView& table() { return *table_; }
  const FindingsModel& model() const { return model_; }

 signals:
  void go_to(const Finding& finding);
  void fix_asked(const Finding& finding);
  void mute_asked(const Finding& finding, const QString& reason);

 private:
  const Finding* marked() const;
  void ask_reason();
  void show_advice();
  FindingsModel model_;
  QSortFilterProxyModel sorted_;
  QTreeView* table_;
  QLabel *sums_, *advice_;
  QToolButton *fix_ = nullptr, *mute_ = nullptr;
};

}  // namespace etak::editor
