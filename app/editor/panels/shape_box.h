// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/document/document.h"
#include "app/editor/panels/inspector/sections.h"

namespace etak::editor {

/// What the material is shown on: sphere, quad, wedge, shader ball or a mesh of one's own.
class ShapeBox : public QuietComboBox {
  Q_OBJECT

 public:
  ///   parent   its own name for the field stands beside the one of the bar
  ShapeBox(Document& document, const QString& name, QWidget* parent = nullptr);

 signals:
  /// The user has chosen a mesh of a file; which one is still to be asked.
  void mesh_asked();

 private:
  void choose(int row);
  void show_view();

  Document& document_;
};

}  // namespace etak::editor
