// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>
#include <QString>
#include <functional>
#include <utility>
#include <vector>

class QAbstractButton;
class QWidget;

namespace etak::editor {

/// Gives the parts of a field a menu under the right button and the menu key: what a line of text has, the field's value for
/// the clipboard, and its reset.
///   copies   title and text of each form of the value
///   reset    the field's button, whose tooltip the menu says
void add_field_menu(QWidget& field, const QList<QWidget*>& parts,
                    const std::vector<std::pair<QString, std::function<QString()>>>& copies,
                    QAbstractButton& reset);

}  // namespace etak::editor
