// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <map>
#include <memory>
#include <vector>

#include "core/project/project.h"

namespace etak::editor {

/// The project under work and which of its materials is in hand. Every change goes through here, is one step
/// of undo, and is told by a signal; changes with one press id and one text become one step.
class Document : public QObject {
  Q_OBJECT

 public:
  explicit Document(std::shared_ptr<const MaterialLibrary> library, QObject* parent = nullptr);
  ~Document() override;

  const Project& project() const { return project_; }
  /// The library with the project's own spectra over it; may be handed to other threads.
  const std::shared_ptr<const MaterialLibrary>& library() const { return all_; }
  QUndoStack& undo_stack() { return undo_; }

  int current() const { return current_; }  // -1: there is none
  const ProjectMaterial* material() const;
  void set_current(int index);

  /// Numbers for rendering; as they were before where the measured record cannot be found (the reason is
  /// told).
  SurfaceValues surface_of(const ProjectMaterial& material, QString* problem = nullptr) const;

  // Changes.
  void edit(int index, const ProjectMaterial& to, const QString& what, int press_id);
  void edit_view(const ProjectView& to, const QString& what, int press_id);
  void edit_compare(const Comparison& to, const QString& what);
  void edit_wedge(const Wedge& to, const QString& what, int press_id);
  /// Adds materials (their names made unique) behind the others and takes the first of them in hand.
  void add(std::vector<ProjectMaterial> materials, const std::vector<Material>& spectra, const QString& what);
  void remove(int index);

  /// Another project: empties the undo stack.
  void replace(Project project, const QString& path, bool saved);

  /// The measurement that a material had before its colour was typed over, in this run.
  std::optional<MeasuredF0> let_go(const std::string& name) const;

  const QString& path() const { return path_; }
  QString folder() const;  // of the project; empty: it was never saved
  QString title() const;
  bool is_saved() const { return undo_.isClean() && !recovered_; }
  void mark_saved(const QString& path);
  /// For a project that was written, and changed while it was: it has a file now, and changes that are not in
  /// it.
  void set_path(const QString& path);
  /// Counts every change, undone ones too: tells a worker's answer from an older state.
  int revision() const { return revision_; }
  /// Counts the projects that were here, one after the other.
  int generation() const { return generation_; }

 signals:
  void replaced();  // everything may be different
  void material_changed(int index);
  void materials_added(int first, int count);
  void materials_removed(int first, int count);
  void current_changed(int index);
  void view_changed();
  void spectra_changed();
  void saved_changed();

 private:
  friend class EditMaterial;
  friend class EditView;
  friend class AddMaterials;
  friend class RemoveMaterial;
  void put(int index, const ProjectMaterial& material);
  void put_view(const ProjectView& view);
  void insert(int index, const std::vector<ProjectMaterial>& materials);
  void take_out(int index, int count);
  void set_spectra(std::vector<Material> spectra);

  std::shared_ptr<const MaterialLibrary> builtin_, all_;
  Project project_;
  QUndoStack undo_;
  QString path_;
  int current_ = -1, revision_ = 0, generation_ = 0;
  bool recovered_ = false;
  std::map<std::string, MeasuredF0> let_go_;  // by the material's name
  // The last solved surface: sliders ask for it again and again with the same F0.
  mutable std::optional<MeasuredF0> solved_measured_;
  mutable LinearRgb solved_specular_{-1, -1, -1};
  mutable SurfaceValues solved_;
  mutable const MaterialLibrary* solved_by_ = nullptr;
};

/// The measured colours of a material whose `measured` has just been set. Throws Error.
ProjectMaterial with_measured(ProjectMaterial material, const MaterialLibrary& library);

}  // namespace etak::editor
