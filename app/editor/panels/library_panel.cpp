// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/library_panel.h"

#include <QButtonGroup>
#include <QLabel>
#include <QLineEdit>
#include <QListView>

#include "app/editor/panels/inspector/sections.h"
#include "app/fields/add_button.h"
#include "app/fields/flow_layout.h"
#include "app/viewport/qt_text.h"
#include "core/material/embedded/unmeasured.h"

namespace etak::editor {
namespace {

constexpr int sphere_side = 72;

}  // namespace

// A list that tells whether it is getting the focus: QListView then makes its first row the current one,
// which is no choice of the user.
class LibraryList : public QListView {
 public:
  using QListView::QListView;
  bool is_entered() const { return entered_; }

 protected:
  void focusInEvent(QFocusEvent* event) override {
    entered_ = true;
    QListView::focusInEvent(event);
    entered_ = false;
  }

 private:
  bool entered_ = false;
};

QListView& LibraryPanel::list() {
  return *list_;
}

LibraryPanel::LibraryPanel(Thumbnails& thumbnails, QWidget* parent)
    : QWidget(parent),
      model_(thumbnails),
      search_(new QLineEdit(this)),
      list_(new LibraryList(this)),
      chips_(new QWidget(this)),
      chip_row_(new FlowLayout(3, chips_)),
      chip_group_(new QButtonGroup(this)),
      answer_(quiet_label(tr("Why nothing is found"), this)),
      count_(new QLabel(this)) {
  setAccessibleName(tr("Library"));
  auto* column = panel_column(this, 4);
  search_->setPlaceholderText(tr("Search (Ctrl+F)"));
  search_->setClearButtonEnabled(true);
  search_->setAccessibleName(tr("Search the library"));
  auto* top = new QHBoxLayout;
  column->addLayout(top);
  top->addWidget(search_, 1);
  make_favourites(*top);
  chips_->setAccessibleName(tr("Classes"));
  column->addWidget(chips_);

  model_.set_side(sphere_side, devicePixelRatioF());
  filter_.setSourceModel(&model_);
  list_->setModel(&filter_);
  list_->setViewMode(QListView::IconMode);
  list_->setIconSize({sphere_side, sphere_side});
  list_->setGridSize({sphere_side + 14, sphere_side + 6 + 2 * fontMetrics().height()});
  list_->setResizeMode(QListView::Adjust);
  list_->setMovement(QListView::Static);
  list_->setWordWrap(true);
  list_->setTextElideMode(Qt::ElideRight);
  list_->setDragEnabled(true);
  list_->setSelectionMode(QAbstractItemView::SingleSelection);
  list_->setAccessibleName(tr("Materials of the library"));
  answer_->hide();
  column->addWidget(answer_);
  column->addWidget(list_, 1);

  auto* foot = new QHBoxLayout;
  column->addLayout(foot);
  count_->setProperty("quiet", true);
  count_->setAccessibleName(tr("Number of materials shown"));
  count_->setWordWrap(true);
  foot->addWidget(count_, 1);
  auto* flat = add_button(*foot, tr("Flat"), tr("Flat pictures in place of spheres"), tr("Flat pictures"));
  flat->setCheckable(true);
  auto* add = add_button(*foot, tr("Add to project"),
                         tr("Add the selected material to the project (Return or double click)"),
                         tr("Add to project"));

  chip_group_->setExclusive(false);
  connect(add, &QToolButton::clicked, this, [this] {
    if (!selected().isEmpty()) emit wanted(selected());
  });
  connect(flat, &QToolButton::toggled, this,
          [this](bool on) { model_.set_shape(on ? Shape::quad : Shape::sphere); });
  connect_list();
}

// A window that is moved to a screen of another scale has pictures of that scale.
bool LibraryPanel::event(QEvent* event) {
  if (event->type() == QEvent::ScreenChangeInternal) model_.set_side(sphere_side, devicePixelRatioF());
  return QWidget::event(event);
}

void LibraryPanel::connect_list() {
  connect(search_, &QLineEdit::textChanged, this,
          [this](const QString& text) { narrow([&] { search_for(text); }); });
  connect(search_, &QLineEdit::returnPressed, this, [this] {
    if (filter_.rowCount() == 0) return;
    // Return selects the best match, whichever row was selected before.
    list_->setFocus();
    list_->setCurrentIndex(filter_.index(0, 0));
    emit looked_at(selected());
  });
  connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this, [this] {
    if (!narrowing_ && !list_->is_entered() && !selected().isEmpty()) emit looked_at(selected());
  });
  connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this, &LibraryPanel::show_star);
  // A click on the current row does not change it, but must start the preview as well.
  connect(list_, &QListView::clicked, this, [this] {
    if (!selected().isEmpty()) emit looked_at(selected());
  });
  connect(list_, &QListView::activated, this, [this] {
    if (!selected().isEmpty()) emit wanted(selected());
  });
}

void LibraryPanel::make_favourites(QBoxLayout& row) {
  star_ = add_button(row, QString(QChar(0x2606)), tr("Mark the selected material as a favourite"),
                     tr("Favourite"));
  star_->setCheckable(true);
  only_ = add_button(row, tr("\u2605 only"), tr("Show the favourites alone"), tr("Favourites only"));
  only_->setCheckable(true);
  connect(star_, &QToolButton::clicked, this, [this](bool on) {
    const QString id = selected();
    if (id.isEmpty()) return show_star();
    if (on)
      favourites_.insert(id);
    else
      favourites_.remove(id);
    show_favourites(favourites_);
    emit favourites_changed(favourites_);
  });
  connect(only_, &QToolButton::toggled, this, [this] { show_favourites(favourites_); });
  show_star();
}

void LibraryPanel::show_favourites(const QSet<QString>& favourites) {
  favourites_ = favourites;
  narrow([&] { filter_.set_favourites(favourites_, only_->isChecked()); });
  show_star();
}

void LibraryPanel::show_star() {
  const bool on = favourites_.contains(selected());
  star_->setEnabled(!selected().isEmpty());
  star_->setChecked(on);
  star_->setText(QString(QChar(on ? 0x2605 : 0x2606)));
}

void LibraryPanel::set_library(std::shared_ptr<const MaterialLibrary> library) {
  library_ = library;
  narrow([&] { model_.set_library(std::move(library)); });
  make_chips();
}

// Makes a change of the rows. The selected material stays selected where it is still among them; otherwise
// nothing is selected, not a neighbour.
void LibraryPanel::narrow(const std::function<void()>& change) {
  narrowing_ = true;
  const QString before = selected();
  change();
  QModelIndex again;
  for (int row = 0; row < filter_.rowCount() && !before.isEmpty(); ++row)
    if (filter_.index(row, 0).data(LibraryModel::id_role).toString() == before) again = filter_.index(row, 0);
  list_->setCurrentIndex(again);
  narrowing_ = false;
  tell_count();
}

QString LibraryPanel::selected() const {
  return list_->currentIndex().data(LibraryModel::id_role).toString();
}

void LibraryPanel::step(int rows) {
  const int count = filter_.rowCount();
  if (count == 0) return;
  const int now = list_->currentIndex().isValid() ? list_->currentIndex().row() : (rows > 0 ? -1 : count);
  list_->setCurrentIndex(filter_.index((now + rows % count + count) % count, 0));
}

void LibraryPanel::make_chips() {
  const QStringList classes = model_.classes();
  if (classes.size() == chip_group_->buttons().size()) return;
  for (QAbstractButton* old : chip_group_->buttons()) delete old;
  for (const QString& each : classes) {
    auto* chip = new QToolButton(chips_);
    chip->setText(each);
    chip->setCheckable(true);
    chip->setProperty("chip", true);
    chip->setFocusPolicy(Qt::StrongFocus);
    chip->setAccessibleName(tr("Only class %1").arg(each));
    chip_row_->addWidget(chip);
    chip_group_->addButton(chip);
    connect(chip, &QToolButton::toggled, this, [this, each, chip](bool on) {
      if (on)
        for (QAbstractButton* other : chip_group_->buttons())
          if (other != chip) other->setChecked(false);
      const QAbstractButton* chosen = nullptr;
      for (const QAbstractButton* button : chip_group_->buttons())
        if (button->isChecked()) chosen = button;
      narrow([&] { filter_.set_class(chosen == nullptr ? QString() : chosen->text()); });
    });
  }
}

// Where nothing matches, the library tells why it has no such material, and what is near stands in the list.
void LibraryPanel::search_for(const QString& text) {
  filter_.set_search(text);
  answer_->clear();
  const std::string word = text.trimmed().toStdString();
  if (filter_.rowCount() == 0 && library_ && !word.empty()) {
    QStringList near;
    if (const Unmeasured* thing = library_->unmeasured(word)) {
      for (const std::string& id : thing->nearest) near << qt_text(id);
      answer_->setText(qt_text(library_->missing(word).found) + (near.isEmpty() ? "" : tr(". Near to it:")));
    } else {
      for (const auto& each : library_->suggest(word)) near << qt_text(each.id);
      if (!near.isEmpty()) answer_->setText(tr("No material of this name. Near to it:"));
    }
    if (!near.isEmpty()) filter_.set_search(text, near);
  }
  answer_->setVisible(!answer_->text().isEmpty());
}

void LibraryPanel::tell_count() {
  const int shown = filter_.rowCount(), all = model_.rowCount();
  count_->setText(shown == all ? tr("%1 materials").arg(all) : tr("%1 of %2").arg(shown).arg(all));
}

}  // namespace etak::editor
