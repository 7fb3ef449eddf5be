// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/library_model.h"

#include <QIcon>
#include <QMimeData>
#include <QPainter>

#include "app/editor/panels/inspector/data_sentences.h"
#include "app/viewport/qt_picture.h"
#include "app/viewport/qt_text.h"
#include "app/viewport/viewport.h"
#include "core/base/error.h"
#include "core/material/appearance.h"
#include "core/material/json.h"
#include "core/material/quality.h"

namespace etak::editor {

QString search_key(const QString& text) {
  QString out;
  for (const QChar c : text.normalized(QString::NormalizationForm_KD).toLower())
    if (c.category() != QChar::Mark_NonSpacing) out += c == '_' || c == '-' ? ' ' : c;
  return out;
}

namespace {

// The picture with a dot, which marks doubtful data; the tooltip of the row explains it.
QPixmap with_dot(QPixmap picture) {
  const double side = picture.width() / picture.devicePixelRatio();
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(QColor(32, 32, 32), side / 64));
  painter.setBrush(QColor(240, 180, 60));
  painter.drawEllipse(QPointF(side * 0.92, side * 0.08), side * 0.05, side * 0.05);
  return picture;
}

// The surface of a picture, with the roughness that the material has where it is added. In a perfect mirror lights
// are points that no pixel hits: it is drawn with the highest gloss.
SurfaceValues shown_surface(const Material& m) {
  const bool clear = clarity(m, m.preferred_dataset()).clear;
  const Vec3 diffuse = clear ? Vec3{0, 0, 0} : Vec3{0.25, 0.25, 0.25};
  SurfaceValues out =
      surface_of(m, m.preferred_dataset(), diffuse, Gloss(double{default_gloss(m, clear).gloss}));
  if (clear) out.opacity = 0;
  return out;
}

}  // namespace

LibraryModel::LibraryModel(Thumbnails& thumbnails, QObject* parent)
    : QAbstractListModel(parent), thumbnails_(thumbnails) {
  connect(&thumbnails_, &Thumbnails::ready, this, [this](const QString& key) {
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (rows_[i].id == key) {
        const QModelIndex at = index(static_cast<int>(i));
        emit dataChanged(at, at, {Qt::DecorationRole});
      }
  });
}

void LibraryModel::set_library(std::shared_ptr<const MaterialLibrary> library) {
  library_ = std::move(library);
  std::vector<Row> next;
  for (std::size_t i = 0; i < library_->ids().size(); ++i) {
    const Material m = library_->at(i);
    Row row{QString::fromStdString(m.id),
            QString::fromStdString(m.name),
            QString::fromStdString(m.material_class),
            {},
            {}};
    row.marked = !quality_flags(m, m.preferred_dataset()).none();
    row.keys = row.id + ' ' + row.name + ' ' + row.material_class;
    row.keys += ' ' + QString::fromStdString(m.group);
    for (const std::string& alias : m.aliases) row.keys += ' ' + QString::fromStdString(alias);
    row.keys = search_key(row.keys);
    row.names = {search_key(row.id), search_key(row.name)};
    for (const std::string& alias : m.aliases) row.names << search_key(QString::fromStdString(alias));
    next.push_back(std::move(row));
  }
  take_rows(std::move(next));
}

// Rows that are there again stay the rows that they are, so that views keep their place and what is marked in them.
void LibraryModel::take_rows(std::vector<Row> next) {
  QSet<QString> before, after;
  for (const Row& row : rows_) before.insert(row.id);
  for (const Row& row : next) after.insert(row.id);
  for (std::size_t i = rows_.size(); i-- > 0;) {
    if (after.contains(rows_[i].id)) continue;
    beginRemoveRows({}, static_cast<int>(i), static_cast<int>(i));
    rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(i));
    endRemoveRows();
  }
  for (std::size_t i = 0; i < next.size(); ++i) {
    const bool known = before.contains(next[i].id);
    if (known && i < rows_.size() && rows_[i].id == next[i].id) continue;
    if (known) {  // in another order: no change of a library gives one
      beginResetModel();
      rows_ = std::move(next);
      return endResetModel();
    }
    beginInsertRows({}, static_cast<int>(i), static_cast<int>(i));
    rows_.insert(rows_.begin() + static_cast<std::ptrdiff_t>(i), next[i]);
    endInsertRows();
  }
  rows_ = std::move(next);
  if (!rows_.empty()) emit dataChanged(index(0), index(rowCount() - 1));
}

void LibraryModel::set_shape(Shape shape) {
  shape_ = shape;
  emit dataChanged(index(0), index(rowCount() - 1), {Qt::DecorationRole});
}

void LibraryModel::set_side(int side, double ratio) {
  const bool shown = ratio != ratio_ && !rows_.empty();
  side_ = side;
  ratio_ = ratio;
  if (shown) emit dataChanged(index(0), index(rowCount() - 1), {Qt::DecorationRole});
}

QStringList LibraryModel::classes() const {
  QStringList out;
  for (const std::string_view each : material_classes) {
    const QString name = qt_text(each);
    if (std::any_of(rows_.begin(), rows_.end(), [&](const Row& row) { return row.material_class == name; }))
      out << name;
  }
  return out;
}

int LibraryModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant LibraryModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole:
      return row.name;
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
      return about(row);
    case id_role:
      return row.id;
    case class_role:
      return row.material_class;
    case keys_role:
      return row.keys;
    case names_role:
      return row.names;
    case Qt::DecorationRole: {
      const auto subject = [this, id = row.id.toStdString()] {
        const auto find = [library = library_, id] {
          auto material = library->find(id);
          if (!material) throw Error::at(id, "is not in the library");
          return *material;
        };
        return Thumbnails::Subject{[find] { return format_material(find()); },
                                   [find] { return shown_surface(find()); }};
      };
      const QPixmap picture = thumbnails_.get(row.id, shape_, side_, ratio_, subject);
      if (!picture.isNull()) return untinted_icon(row.marked ? with_dot(picture) : picture);
      QPixmap empty(static_cast<int>(side_ * ratio_), static_cast<int>(side_ * ratio_));
      empty.setDevicePixelRatio(ratio_);
      empty.fill(Qt::transparent);
      return empty;
    }
    default:
      return {};
  }
}

QString LibraryModel::about(const Row& row) const {
  const auto material = library_->find(row.id.toStdString());
  if (!material) return row.name;
  const Dataset& data = material->preferred_dataset();
  return tr("%1, %2 (%3). Its data are %4.")
             .arg(row.name, row.material_class, row.id, qt_text(name(data.origin))) +
         data_sentences(quality_flags(*material, data), doubt(*material, data));
}

Qt::ItemFlags LibraryModel::flags(const QModelIndex& index) const {
  return QAbstractListModel::flags(index) | Qt::ItemIsDragEnabled;
}

QStringList LibraryModel::mimeTypes() const {
  return {QString::fromLatin1(Viewport::material_mime)};
}

QMimeData* LibraryModel::mimeData(const QModelIndexList& indexes) const {
  auto* out = new QMimeData;
  if (!indexes.isEmpty())
    out->setData(QString::fromLatin1(Viewport::material_mime),
                 data(indexes.front(), id_role).toString().toUtf8());
  return out;
}

LibraryFilter::LibraryFilter(QObject* parent) : QSortFilterProxyModel(parent) {
  sort(0);
}

void LibraryFilter::set_search(const QString& text, const QStringList& near) {
  words_ = search_key(text).split(' ', Qt::SkipEmptyParts);
  near_ = near;
  invalidate();  // the order of the rows depends on the search as well
}

int LibraryFilter::rank(const QModelIndex& row) const {
  if (!near_.isEmpty()) return static_cast<int>(near_.indexOf(row.data(LibraryModel::id_role).toString()));
  const QString wanted = words_.join(' ');
  const QStringList names = row.data(LibraryModel::names_role).toStringList();
  if (wanted.isEmpty() || names.contains(wanted)) return 0;
  const auto any = [&](const auto& test) { return std::any_of(names.begin(), names.end(), test); };
  if (any([&](const QString& name) { return name.startsWith(wanted); })) return 1;
  return any([&](const QString& name) { return name.contains(' ' + wanted); }) ? 2 : 3;
}

bool LibraryFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const {
  const int a = rank(left), b = rank(right);
  return a != b ? a < b : left.row() < right.row();
}

void LibraryFilter::set_favourites(const QSet<QString>& favourites, bool only) {
  favourites_ = favourites;
  only_favourites_ = only;
  invalidateFilter();
}

void LibraryFilter::set_class(const QString& material_class) {
  class_ = material_class;
  invalidateFilter();
}

bool LibraryFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
  const QModelIndex at = sourceModel()->index(row, 0, parent);
  if (!near_.isEmpty()) return near_.contains(at.data(LibraryModel::id_role).toString());
  if (only_favourites_ && !favourites_.contains(at.data(LibraryModel::id_role).toString())) return false;
  if (!class_.isEmpty() && at.data(LibraryModel::class_role).toString() != class_) return false;
  const QString keys = at.data(LibraryModel::keys_role).toString();
  return std::all_of(words_.begin(), words_.end(), [&](const QString& word) { return keys.contains(word); });
}

}  // namespace etak::editor
