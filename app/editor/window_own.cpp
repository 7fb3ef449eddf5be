// SPDX-License-Identifier: Apache-2.0
#include <QApplication>
#include <QClipboard>
#include <QListView>
#include <QMenu>
#include <QMimeData>

#include "app/document/files.h"
#include "app/document/own_materials.h"
#include "app/editor/panels/library_panel.h"
#include "app/editor/panels/project_panel.h"
#include "app/editor/window.h"
#include "app/viewport/background.h"
#include "app/viewport/qt_text.h"

namespace etak::editor {

QString Window::own_folder() const {
  return options_.data_folder.isEmpty() ? data_folder() : options_.data_folder;
}

void Window::make_own_menu(QMenu* menu) {
  // The keys work in the project's list alone, because text fields need them wherever they have the focus.
  const auto in_list = [this](QAction* action) {
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    project_panel_->list().addAction(action);
  };
  in_list(action(menu, tr("Cop&y materials"), QKeySequence::Copy, [this] { copy_materials(); }));
  in_list(action(menu, tr("Past&e materials"), QKeySequence::Paste, [this] { paste_materials(); }));
  action(menu, tr("&Keep as my materials"), {}, [this] { keep_as_own(); });
  QMenu* own = submenu(menu, tr("Add one &of mine"));
  connect(own, &QMenu::aboutToShow, this, [this, own] {
    own->clear();
    for (const QString& name : own_materials(own_folder()))
      own->addAction(QString(name).replace('&', "&&"), this,
                     [this, name] { import({own_material_file(own_folder(), name)}); });
    if (own->isEmpty()) own->addAction(tr("None yet: Keep as my materials"))->setEnabled(false);
  });
}

void Window::copy_materials() {
  const std::vector<int> rows = project_panel_->in_hand();
  if (rows.empty()) return;
  QApplication::clipboard()->setText(qt_text(text_of_materials(document_.project(), rows)));
  tell(rows.size() == 1 ? tr("Copied 1 material") : tr("Copied %1 materials").arg(rows.size()));
}

void Window::paste_materials() {
  const std::string text = QApplication::clipboard()->text().toStdString();
  if (!is_project(text)) return tell(tr("The clipboard holds no materials"));
  QString failure = failure_of([&] {
    Project pasted = parse_project(text, "clipboard");
    const std::vector<std::string> lost = resolve(pasted, *document_.library());
    document_.add(pasted.materials, pasted.spectra, tr("paste"));
    if (!lost.empty()) tell(qt_text(lost.front()));
  });
  if (!failure.isEmpty()) show_problems(tr("Nothing was pasted"), {failure});
}

void Window::keep_as_own() {
  const std::vector<int> rows = project_panel_->in_hand();
  if (rows.empty()) return;
  const QString failure = failure_of([&] { keep_materials(own_folder(), document_.project(), rows); });
  if (!failure.isEmpty()) return show_problems(tr("Nothing was kept"), {failure});
  tell(rows.size() == 1 ? tr("Kept: Edit, Add one of mine")
                        : tr("Kept %1: Edit, Add one of mine").arg(rows.size()));
}

void Window::connect_favourites() {
  library_panel_->show_favourites(read_favourites(own_folder()));
  connect(library_panel_, &LibraryPanel::favourites_changed, this, [this](const QSet<QString>& now) {
    const QString failure = failure_of([&] { write_favourites(own_folder(), now); });
    if (!failure.isEmpty()) tell(failure);
  });
}

}  // namespace etak::editor
