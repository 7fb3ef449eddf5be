// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "core/project/project.h"

namespace etak::editor {

/// The project in work and its current material. Every change goes through this class, is one step of undo
/// and emits a signal. Changes with the same press id and the same text become one step. How the materials are looked at
/// (comparison, exposure, display, backdrop, shape) has steps of its own, so that undoing an edit does not undo a look
/// around; lights are edits as those of materials are.
class Document : public QObject {
  Q_OBJECT

 public:
  explicit Document(std::shared_ptr<const MaterialLibrary> library, QObject* parent = nullptr);
  ~Document() override;

  const Project& project() const { return project_; }
  /// The library with the project's own spectra over it; may be handed to other threads.
  const std::shared_ptr<const MaterialLibrary>& library() const { return all_; }
  QUndoStack& undo_stack() { return undo_; }
  QUndoStack& view_stack() { return looked_; }

  int current() const { return current_; }  // index of the current material; -1: there is none
  const ProjectMaterial* material() const;
  void set_current(int index);

  /// The surface of a material for rendering. Where its measured record cannot be found, the colours that the
  /// material holds are used, and `problem` gets the reason.
  SurfaceValues surface_of(const ProjectMaterial& material, QString* problem = nullptr) const;

  // Changes.
  ///   what   what the step of undo is called
  void edit(int index, const ProjectMaterial& to, const QString& what, int press_id);
  void edit_view(const ProjectView& to, const QString& what, int press_id);
  /// The rows of the materials that are marked in the list of the project.
  void mark(std::vector<int> rows) { marked_ = std::move(rows); }
  /// Changes the current material, where there is one, and the other marked ones where it is marked itself, in
  /// one step of undo; and the view.
  void change_material(const QString& what, int press_id,
                       const std::function<void(ProjectMaterial&)>& change);
  void change_view(const QString& what, int press_id, const std::function<void(ProjectView&)>& change);
  /// Adds materials behind the others, with unique names, and makes the first of them the current material.
  ///   spectra   measured records for the project's own library
  void add(std::vector<ProjectMaterial> materials, const std::vector<Material>& spectra, const QString& what);
  /// Removes the materials of these rows, in ascending order, in one step of undo.
  void remove(const std::vector<int>& rows);
  /// Gives a material a name, with a number where another has it.
  void rename(int index, const std::string& name);

  /// Opens another project and empties the undo stack.
  ///   saved   false: the project was recovered and differs from its file
  void replace(Project project, const QString& path, bool saved);

  /// The measurement that a material had in this run before its colour was replaced by a typed one.
  std::optional<MeasuredF0> let_go(const std::string& name) const;

  const QString& path() const { return path_; }
  QString folder() const;  // folder of the project's file; empty: the project was never saved
  QString title() const;
  bool is_saved() const { return undo_.isClean() && looked_.isClean() && !recovered_; }
  void mark_saved(const QString& path);
  /// Sets the file of a project that was changed while it was written: the file does not hold these changes,
  /// so the project is not marked as saved.
  void set_path(const QString& path);
  /// Counts every change, undo among them. By it the result of a worker is known to be of an older state.
  int revision() const { return revision_; }
  /// Counts the projects that this document has held.
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
  void put(int index, const ProjectMaterial& material);
  void put_view(const ProjectView& view);
  void insert(int index, const std::vector<ProjectMaterial>& materials);
  void take_out(int index, int count);
  void set_spectra(std::vector<Material> spectra);

  std::shared_ptr<const MaterialLibrary> builtin_, all_;
  Project project_;
  QUndoStack undo_, looked_;
  QString path_;
  std::vector<int> marked_;
  int current_ = -1, revision_ = 0, generation_ = 0;
  bool recovered_ = false;
  std::map<std::string, MeasuredF0> let_go_;  // by the name of the material; see let_go()
  // The surface that was solved last, because a drag of a slider asks many times for the same F0.
  mutable std::optional<MeasuredF0> solved_measured_;
  mutable LinearRgb solved_specular_{-1, -1, -1};
  mutable SurfaceValues solved_;
  mutable const MaterialLibrary* solved_by_ = nullptr;
};

/// The record of that name; none where the library has none, and where a layer of a text of layers is not known.
std::optional<Material> record_named(const MaterialLibrary& library, const std::string& name);

/// A material with the colours of its measured record, where `measured` names one. Throws Error.
ProjectMaterial with_measured(ProjectMaterial material, const MaterialLibrary& library);

}  // namespace etak::editor
