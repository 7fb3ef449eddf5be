// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "app/document/document.h"

class QAction;

namespace etak::editor {

class FineSpinBox;
class QuietComboBox;
class ShapeBox;

/// The bar above the viewport, with what is switched most often: environment, exposure, tone curve and shape, and buttons
/// of the window's actions. A narrow one has several lines.
class ViewBar : public QWidget {
  Q_OBJECT

 public:
  explicit ViewBar(Document& document, QWidget* parent = nullptr);

  /// A button that does the action.
  void add(QAction* action);
  /// A button that opens a menu of actions.
  void add_menu(const QString& title, const QString& tip, const QList<QAction*>& actions);

 signals:
  void open_environment_asked();
  void mesh_asked();

 private:
  void make_environment();
  void make_picture();
  void show_view();

  Document& document_;
  QuietComboBox *environment_, *tone_;
  ShapeBox* shape_;
  FineSpinBox* exposure_;
};

}  // namespace etak::editor
