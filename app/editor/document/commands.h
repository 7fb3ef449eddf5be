// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QUndoCommand>

#include "app/editor/document/document.h"

namespace etak::editor {

/// A change of one material. Edits of the same press id and text are merged into one.
class EditMaterial : public QUndoCommand {
 public:
  EditMaterial(Document& document, int index, ProjectMaterial to, const QString& what, int press_id);
  void undo() override;
  void redo() override;
  int id() const override { return 1; }
  bool mergeWith(const QUndoCommand* other) override;

 private:
  Document& document_;
  int index_;
  ProjectMaterial before_, after_;
  int press_id_;
};

/// A change of light, exposure, display or comparison, which apply to all materials.
class EditView : public QUndoCommand {
 public:
  EditView(Document& document, ProjectView to, const QString& what, int press_id);
  void undo() override;
  void redo() override;
  int id() const override { return 2; }
  bool mergeWith(const QUndoCommand* other) override;

 private:
  Document& document_;
  ProjectView before_, after_;
  int press_id_;
};

class AddMaterials : public QUndoCommand {
 public:
  AddMaterials(Document& document, std::vector<ProjectMaterial> materials, std::vector<Material> spectra,
               const QString& what);
  void undo() override;
  void redo() override;

 private:
  Document& document_;
  std::vector<ProjectMaterial> materials_;
  std::vector<Material> before_, after_;
  int index_, current_;
};

class RemoveMaterial : public QUndoCommand {
 public:
  RemoveMaterial(Document& document, int index, const QString& what);
  void undo() override;
  void redo() override;

 private:
  Document& document_;
  int index_;
  ProjectMaterial material_;
};

}  // namespace etak::editor
