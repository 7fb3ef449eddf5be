// SPDX-License-Identifier: Apache-2.0
#include "app/fields/field_menu.h"

#include <QAbstractButton>
#include <QApplication>
#include <QClipboard>
#include <QLineEdit>
#include <QMenu>

namespace etak::editor {

void add_field_menu(QWidget& field, const QList<QWidget*>& parts,
                    const std::vector<std::pair<QString, std::function<QString()>>>& copies,
                    QAbstractButton& reset) {
  for (QWidget* part : parts) {
    part->setContextMenuPolicy(Qt::CustomContextMenu);
    QObject::connect(
        part, &QWidget::customContextMenuRequested, &field, [&field, part, copies, &reset](const QPoint& at) {
          auto* line = qobject_cast<QLineEdit*>(part);
          if (line == nullptr) line = part->findChild<QLineEdit*>();
          QMenu* menu = line != nullptr ? line->createStandardContextMenu() : new QMenu(&field);
          menu->setAttribute(Qt::WA_DeleteOnClose);
          menu->setAccessibleName(QObject::tr("Menu of %1").arg(field.accessibleName()));
          if (line != nullptr) menu->addSeparator();
          for (const auto& [title, text] : copies)
            menu->addAction(title, &field, [text = text] { QApplication::clipboard()->setText(text()); });
          QAction* back = menu->addAction(reset.toolTip(), &reset, &QAbstractButton::click);
          back->setEnabled(reset.isEnabled());
          menu->popup(part->mapToGlobal(at));
        });
  }
}

}  // namespace etak::editor
