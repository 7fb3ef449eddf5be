// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/findings_panel.h"

#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QInputDialog>
#include <QLabel>
#include <QPalette>
#include <QStyledItemDelegate>
#include <QTreeView>
#include <algorithm>
#include <tuple>

#include "app/editor/panels/inspector/sections.h"
#include "app/fields/add_button.h"
#include "app/viewport/qt_text.h"
#include "core/judge/rules.h"
#include "core/validate/config.h"
#include "core/validate/repairs/repair.h"

namespace etak::editor {
namespace {

// The place of a finding in the list: those of a rule stand together, and in it those of a material.
auto place_of(const Finding& finding) {
  return std::tie(finding.rule, finding.material, finding.file, finding.pointer, finding.tile);
}

// Makes each row as high as its whole message needs.
class WholeMessage : public QStyledItemDelegate {
 public:
  explicit WholeMessage(QTreeView& view) : QStyledItemDelegate(&view), view_(view) {}
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    constexpr int beside = 8;
    QSize out = QStyledItemDelegate::sizeHint(option, index);
    if (index.column() != FindingsModel::message_column) return out;
    const QRect room(0, 0, view_.columnWidth(index.column()) - beside, 10000);
    const QString message = index.data().toString();
    out.setHeight(std::max(out.height(),
                           option.fontMetrics.boundingRect(room, Qt::TextWordWrap, message).height() + 2));
    return out;
  }

 private:
  QTreeView& view_;
};

}  // namespace

void FindingsModel::set_findings(const std::map<std::string, std::vector<Finding>>& findings) {
  std::vector<Finding> next;
  for (const auto& [name, list] : findings) next.insert(next.end(), list.begin(), list.end());
  const auto before = [](const Finding& a, const Finding& b) { return place_of(a) < place_of(b); };
  std::ranges::stable_sort(next, before);
  // Both lists are in one order, so that one pass tells which rows went, came or stayed.
  std::size_t at = 0;
  for (const Finding& each : next) {
    while (at < rows_.size() && before(rows_[at], each)) remove_row(at);
    const int row = static_cast<int>(at);
    if (at == rows_.size() || before(each, rows_[at])) {
      beginInsertRows({}, row, row);
      rows_.insert(rows_.begin() + row, each);
      endInsertRows();
    } else if (rows_[at] != each) {
      rows_[at] = each;
      emit dataChanged(index(row, 0), index(row, column_count - 1));
    }
    ++at;
  }
  while (at < rows_.size()) remove_row(at);
}

void FindingsModel::remove_row(std::size_t at) {
  const int row = static_cast<int>(at);
  beginRemoveRows({}, row, row);
  rows_.erase(rows_.begin() + row);
  endRemoveRows();
}

const Finding* FindingsModel::at(int row) const {
  return row >= 0 && row < rowCount() ? &rows_[static_cast<std::size_t>(row)] : nullptr;
}

std::array<std::size_t, 4> FindingsModel::counts() const {
  std::array<std::size_t, 4> out{};
  for (const Finding& each : rows_)
    ++out[each.suppressed                      ? 3
          : each.severity == Severity::error   ? 0
          : each.severity == Severity::warning ? 1
                                               : 2];
  return out;
}

int FindingsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int FindingsModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : column_count;
}

QVariant FindingsModel::data(const QModelIndex& index, int role) const {
  const Finding* finding = at(index.row());
  if (finding == nullptr) return {};
  if (role == Qt::ToolTipRole)
    return qt_text((finding->suppressed ? "muted: " + finding->suppression + "\n" : "") + finding->message +
                   (finding->cause.empty() ? "" : "\n" + finding->cause) +
                   (finding->fix.empty() ? "" : "\n" + finding->fix) + "\n" + finding->source);
  // Muted ones stand below all others.
  if (role == Qt::UserRole && index.column() == severity_column)
    return finding->suppressed ? -1 : static_cast<int>(finding->severity);
  if (role == Qt::ForegroundRole && finding->suppressed)
    return QGuiApplication::palette().brush(QPalette::Disabled, QPalette::Text);
  if (role != Qt::DisplayRole && role != Qt::UserRole) return {};
  switch (index.column()) {
    case severity_column:
      return finding->suppressed ? tr("muted") : qt_text(name(finding->severity));
    case rule_column:
      return qt_text(finding->rule);
    case material_column:
      return qt_text(finding->material);
    default:
      return sentence_of(*finding);
  }
}

QVariant FindingsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  const std::array<QString, column_count> titles{tr("Severity"), tr("Rule"), tr("Material"), tr("Finding")};
  return titles[static_cast<std::size_t>(section)];
}

FindingsPanel::FindingsPanel(Validator& validator, QWidget* parent)
    : QWidget(parent),
      table_(new QTreeView(this)),
      sums_(new QLabel(this)),
      advice_(quiet_label(tr("Advice"), this)) {
  setAccessibleName(tr("Findings"));
  auto* column = panel_column(this, 3);
  sums_->setAccessibleName(tr("Number of findings"));
  auto* row = new QHBoxLayout;
  column->addLayout(row);
  sums_->setWordWrap(true);
  row->addWidget(sums_, 1);
  fix_ = add_button(*row, tr("Fix"),
                    tr("Repair what the marked finding is about, as etak validate --fix does"), tr("Fix"));
  mute_ = add_button(*row, tr("Mute\u2026"),
                     tr("Accept the marked finding with a reason, in the etak.toml beside the project"),
                     tr("Mute"));
  sorted_.setSourceModel(&model_);
  sorted_.setSortRole(Qt::UserRole);
  table_->setModel(&sorted_);
  table_->setRootIsDecorated(false);
  table_->setWordWrap(true);
  auto* whole = new WholeMessage(*table_);
  table_->setItemDelegate(whole);
  connect(table_->header(), &QHeaderView::sectionResized, whole, [whole](int section) {
    if (section == FindingsModel::message_column) emit whole->sizeHintChanged({});
  });
  table_->setAlternatingRowColors(true);
  table_->setSortingEnabled(true);
  table_->sortByColumn(FindingsModel::severity_column, Qt::DescendingOrder);
  table_->setAccessibleName(tr("List of findings"));
  table_->header()->setAccessibleName(tr("Columns of the findings"));
  const QFontMetrics metrics = fontMetrics();
  // Titles need room for the arrow of the sorting beside the word. The message column gets the remaining
  // width.
  table_->setColumnWidth(FindingsModel::severity_column, metrics.horizontalAdvance("Severity") + 28);
  table_->setColumnWidth(FindingsModel::rule_column, metrics.horizontalAdvance("ETK000") + 16);
  table_->setColumnWidth(FindingsModel::material_column, metrics.horizontalAdvance("m") * 8);
  column->addWidget(table_, 1);
  column->addWidget(advice_);
  connect(fix_, &QToolButton::clicked, this, [this] {
    if (const Finding* finding = marked()) emit fix_asked(*finding);
  });
  connect(mute_, &QToolButton::clicked, this, &FindingsPanel::ask_reason);
  const auto show = [this, &validator] {
    model_.set_findings(validator.findings());
    const auto [errors, warnings, infos, muted] = model_.counts();
    QString sums = counted(errors, tr("error"), tr("errors")) + ", " +
                   counted(warnings, tr("warning"), tr("warnings")) + ", " +
                   counted(infos, tr("info"), tr("infos"));
    if (muted > 0) sums += tr(", %1 muted").arg(muted);
    if (!validator.config_failure().isEmpty())
      sums += tr("; not by etak.toml: %1").arg(validator.config_failure());
    // What was found before stands there while the check runs, but nothing is called clean before it has.
    const bool any = model_.rowCount() != 0;
    sums_->setText(validator.is_idle() ? (any ? sums : tr("No findings"))
                                       : (any ? tr("%1; checking\u2026").arg(sums) : tr("checking\u2026")));
    show_advice();
  };
  connect(&validator, &Validator::findings_changed, this, show);
  connect(&validator, &Validator::work_changed, this, show);
  connect(table_->selectionModel(), &QItemSelectionModel::currentChanged, this, &FindingsPanel::show_advice);
  connect(table_, &QTreeView::activated, this, [this](const QModelIndex& now) {
    // A copy: what is shown then may change the list.
    if (const Finding* finding = model_.at(sorted_.mapToSource(now).row())) emit go_to(Finding(*finding));
  });
  show();
}

const Finding* FindingsPanel::marked() const {
  return model_.at(sorted_.mapToSource(table_->currentIndex()).row());
}

void FindingsPanel::ask_reason() {
  const Finding* finding = marked();
  if (finding == nullptr) return;
  auto* dialog = new QInputDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Mute %1 of %2").arg(qt_text(finding->rule), qt_text(finding->material)));
  dialog->setLabelText(tr("Why it is right as it is (written into the etak.toml of the project):"));
  connect(dialog, &QInputDialog::textValueSelected, this, [this, muted = *finding](const QString& reason) {
    if (!reason.trimmed().isEmpty()) emit mute_asked(muted, reason.trimmed());
  });
  dialog->open();
}

void FindingsPanel::show_advice() {
  const Finding* finding = marked();
  const bool open = finding != nullptr && !finding->suppressed;
  fix_->setEnabled(open && find_repair(finding->rule) != nullptr);
  const Rule* rule = open ? find_rule(finding->rule) : nullptr;
  mute_->setEnabled(rule != nullptr && can_be_turned_off(*rule));
  advice_->setText(
      finding == nullptr ? QString()
      : finding->suppressed
          ? tr("muted: %1").arg(qt_text(finding->suppression))
          : qt_text(finding->cause.empty() ? finding->fix : finding->cause + ".\n" + finding->fix));
}

}  // namespace etak::editor
