// SPDX-License-Identifier: Apache-2.0
#include "app/editor/shortcuts.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QMainWindow>
#include <QMenu>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace etak::editor {
namespace {

// The title of an action. Where the action is in a submenu, the name of the submenu stands before it: "Export
// material: MaterialX…".
QString title_of(const QAction& action) {
  QString out = action.text();
  for (const QObject* each : action.associatedObjects())
    if (const auto* menu = qobject_cast<const QMenu*>(each))
      if (qobject_cast<const QMenu*>(menu->parent()) != nullptr) out = menu->title() + ": " + out;
  return out.remove('&');
}

}  // namespace

ShortcutsDialog::ShortcutsDialog(const QMainWindow& window, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Keys and mouse"));
  setAccessibleName(tr("Keys and mouse"));
  resize(660, 640);
  auto* column = new QVBoxLayout(this);
  auto* list = new QTreeWidget(this);
  list->setColumnCount(2);
  list->setHeaderLabels({tr("Keys"), tr("What they do")});
  list->header()->setAccessibleName(tr("Columns of the list"));
  list->setAccessibleName(tr("List of keys"));
  list->setAlternatingRowColors(true);
  column->addWidget(list);
  const auto group = [&](const QString& title) {
    auto* out = new QTreeWidgetItem(list, {title});
    out->setFirstColumnSpanned(true);
    out->setExpanded(true);
    return out;
  };
  const auto row = [](QTreeWidgetItem* parent_row, const QString& keys, const QString& what) {
    new QTreeWidgetItem(parent_row, {keys, what});
  };
  auto* menus = group(tr("Menus"));
  for (const QAction* each : window.findChildren<QAction*>())
    if (!each->shortcut().isEmpty())
      row(menus, each->shortcut().toString(QKeySequence::NativeText), title_of(*each));
  auto* view = group(tr("Viewport"));
  row(view, tr("Left drag, Alt + left drag"), tr("orbit"));
  row(view, tr("Middle drag"), tr("move the picture"));
  row(view, tr("Wheel, Alt + right drag"), tr("zoom"));
  row(view, tr("Ctrl + left drag"), tr("turn the environment"));
  row(view, tr("Shift + left drag"), tr("move the nearest light, or the hemispheres' axis"));
  row(view, tr("Drag on the separator"), tr("move the line between A and B"));
  row(view, tr("Space, held"), tr("show B in place of A"));
  row(view, tr("F"), tr("frame the object"));
  row(view, tr("Alt + arrow keys"), tr("orbit"));
  row(view, tr("+, -"), tr("zoom"));
  row(view, tr("Ctrl + left, right"), tr("turn the environment"));
  row(view, tr("L"), tr("choose the next light"));
  row(view, tr("Shift + arrow keys"), tr("move the chosen light, or the hemispheres' axis"));
  row(view, tr("Comma, period"), tr("move the line between A and B"));
  row(view, tr("Double click"), tr("reset the camera"));
  row(view, tr("Arrow keys"), tr("previous and next material of the project"));
  auto* fields = group(tr("Number fields"));
  row(fields, tr("Wheel, in the field with the focus"), tr("a step"));
  row(fields, tr("Ctrl + wheel"), tr("ten steps"));
  row(fields, tr("Shift + wheel"), tr("a tenth of a step"));
  row(fields, tr("Up, Down, Page up, Page down"), tr("one step, ten steps"));
  auto* lists = group(tr("Lists"));
  row(lists, tr("Return, double click"), tr("add a library material; go to a finding's field"));
  row(lists, tr("Ctrl + click, Shift + click"), tr("mark several materials of the project, to export them"));
  row(lists, tr("F2, double click"), tr("rename a material of the project"));
  row(lists, tr("Esc"), tr("end the preview, or the eyedropper without a colour"));
  list->resizeColumnToContents(0);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  buttons->setAccessibleName(tr("Buttons"));
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

}  // namespace etak::editor
