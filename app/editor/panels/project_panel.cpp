// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/project_panel.h"

#include <QIcon>
#include <QItemSelectionModel>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPainter>
#include <QSignalBlocker>
#include <algorithm>
#include <functional>

#include "app/editor/panels/inspector/sections.h"
#include "app/fields/add_button.h"
#include "app/viewport/qt_picture.h"
#include "core/color/srgb.h"

namespace etak::editor {
namespace {

constexpr int row_side = 32;

// A text that is equal for materials that look the same. It identifies the picture on disk.
std::string look_text(const ProjectMaterial& m) {
  Project one;
  one.materials = {m};
  one.materials.front().name = "m";
  return format_project(one, "");
}

// A dot at the lower right, red for errors and yellow for warnings.
QPixmap badged(QPixmap picture, const OpenFindings& found) {
  if (found.errors + found.warnings == 0) return picture;
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  const QSizeF size = picture.deviceIndependentSize();
  const double side = size.width() / 2.6;
  painter.setPen(QPen(Qt::black, 1));
  painter.setBrush(found.errors > 0 ? QColor(220, 50, 40) : QColor(235, 180, 30));
  const QRectF dot(size.width() - side - 0.5, size.height() - side - 0.5, side, side);
  painter.drawEllipse(dot);
  QFont font = painter.font();
  font.setPixelSize(static_cast<int>(side * 0.8));
  font.setBold(true);
  painter.setFont(font);
  painter.setPen(found.errors > 0 ? Qt::white : Qt::black);
  painter.drawText(dot, Qt::AlignCenter, QStringLiteral("!"));
  return picture;
}

}  // namespace

ProjectModel::ProjectModel(Document& document, Thumbnails& thumbnails, Validator& validator, QObject* parent)
    : QAbstractListModel(parent), document_(document), thumbnails_(thumbnails), validator_(validator) {
  connect(&validator, &Validator::findings_changed, this, [this] {
    if (rowCount() > 0) emit dataChanged(index(0), index(rowCount() - 1));
  });
  connect(&document, &Document::replaced, this, [this] {
    beginResetModel();
    endResetModel();
  });
  connect(&document, &Document::material_changed, this,
          [this](int row) { emit dataChanged(index(row), index(row)); });
  connect(&document, &Document::materials_added, this, [this](int first, int count) {
    beginInsertRows({}, first, first + count - 1);
    endInsertRows();
  });
  connect(&document, &Document::materials_removed, this, [this](int first, int count) {
    beginRemoveRows({}, first, first + count - 1);
    endRemoveRows();
  });
  connect(&thumbnails, &Thumbnails::ready, this, [this](const QString& key) {
    if (key.startsWith("project|") && rowCount() > 0)
      emit dataChanged(index(0), index(rowCount() - 1), {Qt::DecorationRole});
  });
}

int ProjectModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(document_.project().materials.size());
}

QPixmap ProjectModel::picture(int row) const {
  const ProjectMaterial& m = document_.project().materials[static_cast<std::size_t>(row)];
  // Materials that look the same share a picture. A hash keeps the key short.
  std::size_t seed = 0;
  const auto mix = [&](std::size_t value) {
    seed ^= value + 0x9e3779b97f4a7c15u + (seed << 6) + (seed >> 2);
  };
  for (const double v : {m.diffuse.r, m.diffuse.g, m.diffuse.b, m.specular.r, m.specular.g, m.specular.b,
                         m.gloss.alpha(), m.alpha, m.emission.r, m.emission.g, m.emission.b, m.occlusion})
    mix(std::hash<double>()(v));
  if (m.measured) {
    mix(std::hash<std::string>()(m.measured->material));
    mix(std::hash<std::string>()(m.measured->dataset + '|' + m.measured->outside));
  }
  const QString key = QStringLiteral("project|%1").arg(seed, 0, 16);
  return thumbnails_.get(key, Shape::sphere, row_side, 2, [&] {
    return Thumbnails::Subject{[m] { return look_text(m); },
                               [m, library = document_.library()] { return surface_of(m, *library); }};
  });
}

QVariant ProjectModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const ProjectMaterial& m = document_.project().materials[static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      return QString::fromStdString(m.name);
    case Qt::ToolTipRole: {
      const QString found = open_findings(validator_, m.name).text();
      return tr("%1: F0 %2, %3")
                 .arg(QString::fromStdString(m.name), QString::fromStdString(hex(srgb_u8(m.specular))),
                      QString::fromStdString(roughness_text(m.gloss))) +
             (found.isEmpty() ? found : QLatin1Char('\n') + found);
    }
    case Qt::AccessibleTextRole: {
      const QString found = open_findings(validator_, m.name).text();
      return QString::fromStdString(m.name) + (found.isEmpty() ? found : QStringLiteral(", ") + found);
    }
    case Qt::DecorationRole: {
      const QPixmap pixmap = picture(index.row());
      if (!pixmap.isNull()) return untinted_icon(badged(pixmap, open_findings(validator_, m.name)));
      QPixmap empty(row_side, row_side);
      empty.fill(qt_color(srgb_u8(m.specular)));
      return empty;
    }
    default:
      return {};
  }
}

bool ProjectModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const std::string wanted = value.toString().trimmed().toStdString();
  if (role != Qt::EditRole || wanted.empty()) return false;
  if (document_.project().materials[static_cast<std::size_t>(index.row())].name != wanted)
    document_.rename(index.row(), wanted);
  return true;
}

Qt::ItemFlags ProjectModel::flags(const QModelIndex& index) const {
  return QAbstractListModel::flags(index) | Qt::ItemIsEditable;
}

ProjectPanel::ProjectPanel(Document& document, Thumbnails& thumbnails, Validator& validator, QWidget* parent)
    : QWidget(parent),
      document_(document),
      model_(document, thumbnails, validator),
      search_(new QLineEdit(this)),
      list_(new QListView(this)),
      marked_(quiet_label(tr("Marked materials"), this)) {
  setAccessibleName(tr("Project"));
  auto* column = panel_column(this, 4);
  make_search(*column);
  // While rows go, the list chooses a row by itself; the document knows which one is the current one then.
  // Connected before the list is, so that the list's choice finds the flag.
  connect(&model_, &ProjectModel::rowsAboutToBeRemoved, this, [this] { showing_ = true; });
  connect(&model_, &ProjectModel::rowsRemoved, this, [this] {
    showing_ = false;
    show_marked();
  });
  shown_.setSourceModel(&model_);
  list_->setModel(&shown_);
  list_->setIconSize({row_side, row_side});
  list_->setUniformItemSizes(true);
  list_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
  // Several materials can be marked, to edit, copy, remove or export them together.
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  list_->setAccessibleName(tr("Materials of the project"));
  column->addWidget(list_, 1);
  column->addWidget(marked_);
  auto* row = new QHBoxLayout;
  column->addLayout(row);
  const auto button = [&](const QString& text, const QString& tip, void (ProjectPanel::*signal)()) {
    connect(add_button(*row, text, tip), &QToolButton::clicked, this, signal);
  };
  button(tr("New"), tr("New material (Ctrl+Shift+N)"), &ProjectPanel::new_asked);
  button(tr("Copy"), tr("Duplicate the marked materials (Ctrl+D)"), &ProjectPanel::copy_asked);
  button(tr("Remove"), tr("Remove the marked materials (Del)"), &ProjectPanel::remove_asked);
  row->addStretch(1);
  connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          [this](const QModelIndex& now) {
            if (showing_ || !now.isValid()) return;
            showing_ = true;  // the list decides which rows are marked beside it
            document_.set_current(shown_.mapToSource(now).row());
            showing_ = false;
            show_marked();
          });
  connect(list_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &ProjectPanel::show_marked);
  connect(list_, &QListView::clicked, this, &ProjectPanel::picked);
  connect(&document, &Document::current_changed, this, &ProjectPanel::show_current);
  connect(&document, &Document::replaced, this, &ProjectPanel::show_current);
  connect(&document, &Document::materials_added, this, &ProjectPanel::show_current);
  show_marked();
}

void ProjectPanel::make_search(QBoxLayout& column) {
  auto* row = new QHBoxLayout;
  column.addLayout(row);
  search_->setPlaceholderText(tr("Search"));
  search_->setClearButtonEnabled(true);
  search_->setAccessibleName(tr("Search the project"));
  search_->setProperty("search", true);
  row->addWidget(search_, 1);
  auto* sort =
      add_button(*row, tr("A\u2013Z"), tr("In the order of the names, in place of that of the project"),
                 tr("Sort by name"));
  sort->setCheckable(true);
  shown_.setFilterCaseSensitivity(Qt::CaseInsensitive);
  shown_.setSortCaseSensitivity(Qt::CaseInsensitive);
  connect(search_, &QLineEdit::textChanged, this,
          [this](const QString& text) { arrange([&] { shown_.setFilterFixedString(text.trimmed()); }); });
  connect(sort, &QToolButton::toggled, this, [this](bool on) { arrange([&] { shown_.sort(on ? 0 : -1); }); });
}

// The list chooses another row where its own goes, which is no choice of the user.
void ProjectPanel::arrange(const std::function<void()>& change) {
  showing_ = true;
  change();
  showing_ = false;
  show_current();
}

QModelIndex ProjectPanel::shown_row(int row) const {
  return shown_.mapFromSource(model_.index(row, 0));
}

std::vector<int> ProjectPanel::selected() const {
  std::vector<int> out;
  for (const QModelIndex& each : list_->selectionModel()->selectedIndexes())
    out.push_back(shown_.mapToSource(each).row());
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<int> ProjectPanel::in_hand() const {
  std::vector<int> out = selected();
  if (out.empty() && shown_row(document_.current()).isValid()) out.push_back(document_.current());
  return out;
}

void ProjectPanel::show_current() {
  const QModelIndex now = shown_row(document_.current());
  QItemSelectionModel* selection = list_->selectionModel();
  // Where the row is the current one already, the other selected rows stay selected.
  if (showing_ || (list_->currentIndex() == now && (!now.isValid() || selection->isSelected(now))))
    return show_marked();
  showing_ = true;
  // The view's own setCurrentIndex() would add to the selection while Ctrl or Shift is held.
  selection->setCurrentIndex(now, QItemSelectionModel::ClearAndSelect);
  showing_ = false;
  list_->scrollTo(now);
  show_marked();
}

// Rows that were inserted or removed have changed the numbers of the marked ones, so they are told each time.
void ProjectPanel::show_marked() {
  const std::vector<int> rows = selected();
  document_.mark(rows);
  marked_->setVisible(rows.size() > 1);
  marked_->setText(tr("%1 marked: edits, Copy and Remove act on all of them").arg(rows.size()));
}

}  // namespace etak::editor
