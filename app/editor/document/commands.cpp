// SPDX-License-Identifier: Apache-2.0
#include "app/editor/document/commands.h"

namespace etak::editor {

EditMaterial::EditMaterial(Document& document, int index, ProjectMaterial to, const QString& what,
                           int press_id)
    : QUndoCommand(what),
      document_(document),
      index_(index),
      before_(document.project().materials[static_cast<std::size_t>(index)]),
      after_(std::move(to)),
      press_id_(press_id) {}

void EditMaterial::undo() {
  document_.put(index_, before_);
  document_.set_current(index_);
}

void EditMaterial::redo() {
  document_.put(index_, after_);
  document_.set_current(index_);
}

bool EditMaterial::mergeWith(const QUndoCommand* other) {
  const auto* next = static_cast<const EditMaterial*>(other);
  if (next->index_ != index_ || next->press_id_ != press_id_ || next->text() != text()) return false;
  after_ = next->after_;
  if (after_ == before_) setObsolete(true);
  return true;
}

EditView::EditView(Document& document, ProjectView to, const QString& what, int press_id)
    : QUndoCommand(what),
      document_(document),
      before_(document.project().view),
      after_(std::move(to)),
      press_id_(press_id) {}

void EditView::undo() {
  document_.put_view(before_);
}

void EditView::redo() {
  document_.put_view(after_);
}

bool EditView::mergeWith(const QUndoCommand* other) {
  const auto* next = static_cast<const EditView*>(other);
  if (next->press_id_ != press_id_ || next->text() != text()) return false;
  after_ = next->after_;
  if (after_ == before_) setObsolete(true);
  return true;
}

AddMaterials::AddMaterials(Document& document, std::vector<ProjectMaterial> materials,
                           std::vector<Material> spectra, const QString& what)
    : QUndoCommand(what),
      document_(document),
      materials_(std::move(materials)),
      before_(document.project().spectra),
      after_(std::move(spectra)),
      index_(static_cast<int>(document.project().materials.size())),
      current_(document.current()) {}

void AddMaterials::undo() {
  document_.take_out(index_, static_cast<int>(materials_.size()));
  if (before_ != after_) document_.set_spectra(before_);
  document_.set_current(current_);
}

void AddMaterials::redo() {
  if (before_ != after_) document_.set_spectra(after_);
  document_.insert(index_, materials_);
  document_.set_current(index_);
}

RemoveMaterial::RemoveMaterial(Document& document, int index, const QString& what)
    : QUndoCommand(what),
      document_(document),
      index_(index),
      material_(document.project().materials[static_cast<std::size_t>(index)]) {}

void RemoveMaterial::undo() {
  document_.insert(index_, {material_});
  document_.set_current(index_);
}

void RemoveMaterial::redo() {
  document_.take_out(index_, 1);
}

}  // namespace etak::editor
