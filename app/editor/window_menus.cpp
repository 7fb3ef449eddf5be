// SPDX-License-Identifier: Apache-2.0
#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QFileDialog>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QSettings>
#include <QTabWidget>
#include <QTreeView>

#include "app/document/press_id.h"
#include "app/editor/panels/findings_panel.h"
#include "app/editor/panels/library_panel.h"
#include "app/editor/panels/project_panel.h"
#include "app/editor/panels/view_panel.h"
#include "app/editor/shortcuts.h"
#include "app/editor/theme.h"
#include "app/editor/window.h"

namespace etak::editor {

QAction* Window::action(QMenu* menu, const QString& title, const QKeySequence& keys,
                        const std::function<void()>& act) {
  auto* out = new QAction(title, this);
  out->setShortcut(keys);
  connect(out, &QAction::triggered, this, act);
  menu->addAction(out);
  return out;
}

QMenu* Window::submenu(QMenu* menu, const QString& title) {
  QMenu* out = menu->addMenu(title);
  out->setAccessibleName(QString(title).remove('&'));
  return out;
}

void Window::make_menus() {
  menuBar()->setAccessibleName(tr("Menus"));
  make_file_menu();
  make_edit_menu();
  make_view_menu();
  make_context_menus();
  QMenu* help = menuBar()->addMenu(tr("&Help"));
  action(help, tr("&Keys and mouse"), QKeySequence(Qt::Key_F1), [this] {
    auto* dialog = new ShortcutsDialog(*this, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show();
  });
  action(help, tr("&About"), {}, [this] {
    QMessageBox::about(
        this, tr("About the editor"),
        tr("etak editor %1: measured optics into materials a renderer can trust.\nApache-2.0. Drawn with Qt (LGPL).")
            .arg(QStringLiteral(ETAK_VERSION)));
  });
}

void Window::make_file_menu() {
  QMenu* menu = menuBar()->addMenu(tr("&File"));
  action(menu, tr("&New project"), QKeySequence::New, [this] {
    if (may_lose_changes()) document_.replace(fresh_project(), {}, true);
  });
  action(menu, tr("&Open\u2026"), QKeySequence::Open, [this] { choose_and_open(); });
  action(menu, tr("Open &folder of textures\u2026"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O), [this] {
    const QString folder =
        QFileDialog::getExistingDirectory(this, tr("Folder of textures"), beside_project());
    if (!folder.isEmpty()) take_files({folder});
  });
  QMenu* recent = menu->addMenu(tr("Open &recent"));
  recent->setAccessibleName(tr("Recent files"));
  connect(recent, &QMenu::aboutToShow, this, [this, recent] { fill_recent(recent); });
  menu->addSeparator();
  action(menu, tr("&Save"), QKeySequence::Save, [this] { save(); });
  action(menu, tr("Save &as\u2026"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), [this] { save_as(); });
  action(menu, tr("Save &material as\u2026"), {}, [this] { save_material_as(); });
  action(menu, tr("Save pic&ture\u2026"), QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_S),
         [this] { save_picture(); });
  menu->addSeparator();
  action(menu, tr("&Import spectra\u2026"), QKeySequence(Qt::CTRL | Qt::Key_I),
         [this] { choose_and_import(); });
  action(menu, tr("&Pack the atlas\u2026"), QKeySequence(Qt::CTRL | Qt::Key_P),
         [this] { choose_and_pack(); });
  action(menu, tr("Check all a&gain"), QKeySequence(Qt::CTRL | Qt::Key_R),
         [this] { validator_->check_all(); });
  fill_export_menu(submenu(menu, tr("&Export material")), ExportOf::one);
  fill_export_menu(submenu(menu, tr("Export s&elected materials")), ExportOf::selected);
  fill_export_menu(submenu(menu, tr("Export a&ll materials")), ExportOf::all);
  menu->addSeparator();
  action(menu, tr("&Quit"), QKeySequence::Quit, [this] { close(); });
}

void Window::make_edit_menu() {
  QMenu* menu = menuBar()->addMenu(tr("&Edit"));
  undo_ = document_.undo_stack().createUndoAction(this, tr("&Undo"));
  undo_->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Z));
  redo_ = document_.undo_stack().createRedoAction(this, tr("&Redo"));
  redo_->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
  menu->addAction(undo_);
  menu->addAction(redo_);
  menu->addSeparator();
  action(menu, tr("&New material"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_N),
         [this] { emit project_panel_->new_asked(); });
  action(menu, tr("&Duplicate materials"), QKeySequence(Qt::CTRL | Qt::Key_D),
         [this] { emit project_panel_->copy_asked(); });
  action(menu, tr("Materials &by mask\u2026"), QKeySequence(Qt::CTRL | Qt::Key_M), [this] { ask_mask(); });
  // The right button on the project's list shows these actions too; their keys are those of the menu.
  for (QAction* each : menu->actions())
    if (each->shortcut() == QKeySequence(Qt::CTRL | Qt::Key_D)) project_panel_->list().addAction(each);
  // The key Del works in the project panel only, because text fields need it wherever they have the focus.
  auto* remove = action(menu, tr("Re&move materials"), QKeySequence::Delete,
                        [this] { emit project_panel_->remove_asked(); });
  remove->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  project_panel_->addAction(remove);
  make_own_menu(menu);
  menu->addSeparator();
  action(menu, tr("P&references\u2026"), QKeySequence(Qt::CTRL | Qt::Key_Comma),
         [this] { ask_preferences(); });
  fill_copy_menu(submenu(menu, tr("&Copy value as")));
  action(menu, tr("Copy as command &line"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_L),
         [this] { copy_command(); });
  menu->addSeparator();
  action(menu, tr("&Find in the library"), QKeySequence::Find, [this] {
    library_panel_->search().setFocus();
    library_panel_->search().selectAll();
  });
}

void Window::make_view_menu() {
  QMenu* menu = menuBar()->addMenu(tr("&View"));
  action(menu, tr("&Frame the object"), {}, [this] { viewport_->frame_object(); });
  action(menu, tr("&Reset the camera"), QKeySequence(Qt::CTRL | Qt::Key_0),
         [this] { viewport_->reset_camera(); });
  end_preview_ =
      action(menu, tr("E&nd the preview"), QKeySequence(Qt::Key_Escape), [this] { end_preview(); });
  end_preview_->setEnabled(false);
  menu->addAction(perspective_action_);
  menu->addAction(compare_action_);
  action(menu, tr("&Pin as B"), QKeySequence(Qt::CTRL | Qt::Key_B),
         [this] { emit view_panel_->pin_asked(); });
  menu->addAction(look_action_);
  menu->addAction(measure_action_);
  QAction* back = document_.view_stack().createUndoAction(this, tr("&Undo the look:"));
  back->setShortcut(QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_Z));
  QAction* forth = document_.view_stack().createRedoAction(this, tr("Re&do the look:"));
  forth->setShortcut(QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_Y));
  menu->addActions({back, forth});
  menu->addActions(overlays_);
  menu->addSeparator();
  action(menu, tr("View&port only"), QKeySequence(Qt::Key_F11), [this] { show_viewport_only(!alone_); });
  action(menu, tr("F&indings"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_F), [this] {
    tabs_->setCurrentWidget(findings_);
    findings_->table().setFocus();
  });
  QMenu* panels = submenu(menu, tr("P&anels"));
  for (QDockWidget* dock : findChildren<QDockWidget*>()) panels->addAction(dock->toggleViewAction());
  // The layout of a new window, saved before a remembered layout replaces it.
  const QByteArray first = saveState();
  action(menu, tr("Reset the &layout"), {}, [this, first] {
    restoreState(first);
    for (QDockWidget* dock : findChildren<QDockWidget*>()) dock->setVisible(dock->objectName() != "history");
  });
  QMenu* themes = submenu(menu, tr("&Theme"));
  auto* group = new QActionGroup(this);
  const QString now = options_.remember ? QSettings().value("theme", "desktop").toString()
                                        : name(is_dark(palette()) ? Theme::dark : Theme::light);
  follows_desktop_ = now == "desktop" && !options_.theme_given;
  const auto add = [&](const QString& title, const QString& stored) {
    QAction* each = action(themes, title, {}, [this, stored] {
      follows_desktop_ = stored == "desktop";
      apply_theme(*qApp, theme_named(stored));
      if (options_.remember) QSettings().setValue("theme", stored);
    });
    each->setCheckable(true);
    each->setChecked(stored == now);
    group->addAction(each);
  };
  add(tr("&As the desktop"), "desktop");
  add(tr("&Dark"), name(Theme::dark));
  add(tr("&Light"), name(Theme::light));
}

void Window::make_context_menus() {
  auto* list = &project_panel_->list();
  auto* rename = new QAction(tr("&Rename"), list);
  connect(rename, &QAction::triggered, list, [list] { list->edit(list->currentIndex()); });
  list->insertAction(list->actions().value(0), rename);
  list->addActions(project_panel_->actions());  // that of the key Del
  list->setContextMenuPolicy(Qt::ActionsContextMenu);
  viewport_->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(viewport_, &QWidget::customContextMenuRequested, this, [this](const QPoint& at) {
    if (QApplication::keyboardModifiers() & Qt::AltModifier) return;  // Alt and the right button zoom
    auto* menu = new QMenu(viewport_);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setAccessibleName(tr("Menu of the viewport"));
    menu->addAction(tr("&Frame the object"), viewport_, &Viewport::frame_object);
    menu->addAction(tr("&Reset the camera"), viewport_, &Viewport::reset_camera);
    menu->addActions({perspective_action_, compare_action_});
    menu->addAction(tr("&Pin as B"), this, [this] { emit view_panel_->pin_asked(); });
    menu->addSeparator();
    menu->addActions(overlays_);
    menu->addSeparator();
    menu->addAction(tr("Copy as command &line"), this, [this] { copy_command(); });
    menu->addAction(tr("&Save picture\u2026"), this, [this] { save_picture(); });
    menu->popup(viewport_->mapToGlobal(at));
  });
}

}  // namespace etak::editor
