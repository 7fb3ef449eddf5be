// SPDX-License-Identifier: Apache-2.0
#include "app/document/document.h"

#include <QFileInfo>
#include <algorithm>

#include "app/document/look.h"
#include "app/document/press_id.h"
#include "core/base/error.h"
#include "core/base/text/free_names.h"

namespace etak::editor {
namespace {

// A step of undo that two functions make.
class Step : public QUndoCommand {
 public:
  Step(const QString& what, std::function<void()> redo, std::function<void()> undo)
      : QUndoCommand(what), redo_(std::move(redo)), undo_(std::move(undo)) {}
  void redo() override { redo_(); }
  void undo() override { undo_(); }

 private:
  std::function<void()> redo_, undo_;
};

// A change of one value. Changes of the same value with the same press id and text are merged into one.
template <class Value>
class Edit : public QUndoCommand {
 public:
  ///   place   tells which of several values it is
  Edit(const QString& what, Value before, Value after, std::function<void(const Value&)> put,
       std::pair<int, int> place_and_press)
      : QUndoCommand(what),
        before_(std::move(before)),
        after_(std::move(after)),
        put_(std::move(put)),
        place_and_press_(place_and_press) {}
  void redo() override { put_(after_); }
  void undo() override { put_(before_); }
  int id() const override {
    return std::is_same_v<Value, ProjectView> ? 1 : std::is_same_v<Value, ProjectMaterial> ? 2 : 3;
  }
  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = static_cast<const Edit*>(other);
    if (next->place_and_press_ != place_and_press_ || next->text() != text()) return false;
    after_ = next->after_;
    if (after_ == before_) setObsolete(true);
    return true;
  }

 private:
  Value before_, after_;
  std::function<void(const Value&)> put_;
  std::pair<int, int> place_and_press_;
};

// A view with the lights of another one.
ProjectView with_lights(ProjectView view, const ProjectView& lit) {
  view.lights = lit.lights;
  view.environment_turn_deg = lit.environment_turn_deg;
  return view;
}

}  // namespace

Document::Document(std::shared_ptr<const MaterialLibrary> library, QObject* parent)
    : QObject(parent), builtin_(std::move(library)), all_(builtin_), project_(new_project()) {
  for (QUndoStack* each : {&undo_, &looked_}) {
    each->setUndoLimit(1000);
    connect(each, &QUndoStack::cleanChanged, this, &Document::saved_changed);
  }
}

Document::~Document() {
  // The stack clears itself in its destructor; its signals must not reach objects that ask this document,
  // which is partly destroyed by then.
  undo_.disconnect();
  looked_.disconnect();
}

const ProjectMaterial* Document::material() const {
  return current_ < 0 ? nullptr : &project_.materials[static_cast<std::size_t>(current_)];
}

void Document::set_current(int index) {
  const int inside = std::clamp(index, -1, static_cast<int>(project_.materials.size()) - 1);
  if (inside == current_) return;
  current_ = inside;
  emit current_changed(current_);
}

SurfaceValues Document::surface_of(const ProjectMaterial& material, QString* problem) const {
  const bool same_f0 = solved_measured_ == material.measured && solved_specular_ == material.specular;
  if (!same_f0 || solved_by_ != all_.get()) {
    try {
      solved_ = etak::surface_of(material, *all_);
    } catch (const Error& error) {
      if (problem != nullptr) *problem = QString::fromUtf8(error.what());
      ProjectMaterial plain = material;
      plain.measured.reset();
      return etak::surface_of(plain, *all_);
    }
    solved_measured_ = material.measured;
    solved_specular_ = material.specular;
    solved_by_ = all_.get();
  }
  SurfaceValues out = solved_;
  take_numbers(material, out);
  return out;
}

void Document::edit(int index, const ProjectMaterial& to, const QString& what, int press_id) {
  if (index < 0 || to == project_.materials[static_cast<std::size_t>(index)]) return;
  const auto put_here = [this, index](const ProjectMaterial& material) {
    put(index, material);
    set_current(index);
  };
  const ProjectMaterial& now = project_.materials[static_cast<std::size_t>(index)];
  undo_.push(new Edit<ProjectMaterial>(what, now, to, put_here, {index, press_id}));
}

void Document::edit_view(const ProjectView& to, const QString& what, int press_id) {
  if (to == project_.view) return;
  // Each step puts its own part alone, as the other stack may be at another place then.
  const ProjectView before = project_.view;
  const ProjectView lit = with_lights(before, to), looked = with_lights(to, before);
  if (lit != before)
    undo_.push(new Edit<ProjectView>(
        what, before, lit, [this](const ProjectView& view) { put_view(with_lights(project_.view, view)); },
        {0, press_id}));
  if (looked != before)
    looked_.push(new Edit<ProjectView>(
        what, before, looked, [this](const ProjectView& view) { put_view(with_lights(view, project_.view)); },
        {0, press_id}));
}

void Document::change_material(const QString& what, int press_id,
                               const std::function<void(ProjectMaterial&)>& change) {
  if (material() == nullptr) return;
  using Rows = std::vector<std::pair<int, ProjectMaterial>>;
  Rows before;
  if (std::ranges::find(marked_, current_) != marked_.end())
    for (const int row : marked_)
      if (row < static_cast<int>(project_.materials.size()))
        before.emplace_back(row, project_.materials[static_cast<std::size_t>(row)]);
  if (before.size() < 2) {
    ProjectMaterial next = *material();
    change(next);
    return edit(current_, next, what, press_id);
  }
  Rows after = before;
  for (auto& [row, each] : after) change(each);
  if (after == before) return;
  const auto put_all = [this, at = current_](const Rows& rows) {
    for (const auto& [row, each] : rows) put(row, each);
    set_current(at);
  };
  undo_.push(new Edit<Rows>(what, before, after, put_all, {current_, press_id}));
}

void Document::change_view(const QString& what, int press_id,
                           const std::function<void(ProjectView&)>& change) {
  ProjectView next = project_.view;
  change(next);
  edit_view(next, what, press_id);
}

void Document::add(std::vector<ProjectMaterial> materials, const std::vector<Material>& spectra,
                   const QString& what) {
  if (materials.empty()) return;
  // Each name must differ from those of the document and from those that are added with it.
  FreeNames names = names_of(project_);
  for (ProjectMaterial& each : materials) {
    each.name = free_name(names, each.name);
    let_go_.erase(each.name);  // belongs to a removed material of this name
  }
  std::vector<Material> all = project_.spectra;
  for (const Material& each : spectra) {
    const auto same =
        std::find_if(all.begin(), all.end(), [&](const Material& m) { return m.id == each.id; });
    if (same == all.end())
      all.push_back(each);
    else
      *same = each;
  }
  const int first = static_cast<int>(project_.materials.size());
  undo_.push(new Step(
      what,
      [this, first, materials, all] {
        if (project_.spectra != all) set_spectra(all);
        insert(first, materials);
        set_current(first);
      },
      [this, first, count = static_cast<int>(materials.size()), before = project_.spectra, at = current_] {
        take_out(first, count);
        if (project_.spectra != before) set_spectra(before);
        set_current(at);
      }));
}

void Document::remove(const std::vector<int>& rows) {
  if (rows.empty() || rows.front() < 0 || rows.back() >= static_cast<int>(project_.materials.size())) return;
  std::vector<ProjectMaterial> gone;
  for (const int row : rows) gone.push_back(project_.materials[static_cast<std::size_t>(row)]);
  const QString what = rows.size() > 1 ? tr("remove %1 materials").arg(rows.size())
                                       : tr("remove %1").arg(QString::fromStdString(gone.front().name));
  undo_.push(new Step(
      what,
      [this, rows] {
        for (auto row = rows.rbegin(); row != rows.rend(); ++row) take_out(*row, 1);
      },
      [this, rows, gone] {
        for (std::size_t i = 0; i < rows.size(); ++i) insert(rows[i], {gone[i]});
        set_current(rows.front());
      }));
}

void Document::rename(int index, const std::string& name) {
  ProjectMaterial next = project_.materials[static_cast<std::size_t>(index)];
  next.name = free_name(project_, name);
  edit(index, next, tr("rename"), next_press_id());
}

void Document::replace(Project project, const QString& path, bool saved) {
  undo_.clear();
  looked_.clear();
  project_ = std::move(project);
  path_ = path;
  recovered_ = !saved;
  ++generation_;
  let_go_.clear();
  current_ = project_.materials.empty() ? -1 : 0;
  ++revision_;
  set_spectra(project_.spectra);
  emit replaced();
  emit current_changed(current_);
  emit saved_changed();
}

QString Document::title() const {
  return path_.isEmpty() ? tr("Untitled") : QFileInfo(path_).fileName();
}

QString Document::folder() const {
  return path_.isEmpty() ? QString() : QFileInfo(path_).absolutePath();
}

std::optional<MeasuredF0> Document::let_go(const std::string& name) const {
  const auto found = let_go_.find(name);
  return found == let_go_.end() ? std::nullopt : std::optional(found->second);
}

void Document::set_path(const QString& path) {
  path_ = path;
  emit saved_changed();
}

void Document::mark_saved(const QString& path) {
  path_ = path;
  recovered_ = false;
  undo_.setClean();
  looked_.setClean();
  emit saved_changed();
}

void Document::put(int index, const ProjectMaterial& material) {
  ProjectMaterial& now = project_.materials[static_cast<std::size_t>(index)];
  if (now.name != material.name) {
    if (auto kept = let_go_.extract(now.name)) {
      let_go_.erase(material.name);
      kept.key() = material.name;
      let_go_.insert(std::move(kept));
    }
  }
  if (now.measured && !material.measured) let_go_[material.name] = *now.measured;
  now = material;
  ++revision_;
  emit material_changed(index);
}

void Document::put_view(const ProjectView& view) {
  project_.view = view;
  ++revision_;
  emit view_changed();
}

void Document::insert(int index, const std::vector<ProjectMaterial>& materials) {
  project_.materials.insert(project_.materials.begin() + index, materials.begin(), materials.end());
  if (current_ >= index) current_ += static_cast<int>(materials.size());
  ++revision_;
  emit materials_added(index, static_cast<int>(materials.size()));
}

void Document::take_out(int index, int count) {
  const auto first = project_.materials.begin() + index;
  project_.materials.erase(first, first + count);
  ++revision_;
  const int left = static_cast<int>(project_.materials.size());
  const int before = current_;
  if (current_ >= index + count)
    current_ -= count;
  else if (current_ >= index)
    current_ = std::min(index, left - 1);
  emit materials_removed(index, count);
  if (before != current_ || before >= index) emit current_changed(current_);
}

void Document::set_spectra(std::vector<Material> spectra) {
  project_.spectra = std::move(spectra);
  ++revision_;
  if (project_.spectra.empty() && all_ == builtin_) return;
  all_ = project_.spectra.empty() ? builtin_
                                  : std::make_shared<const MaterialLibrary>(library_of(project_, *builtin_));
  emit spectra_changed();
}

std::optional<Material> record_named(const MaterialLibrary& library, const std::string& name) {
  try {
    return library.find(name);
  } catch (const Error&) {
    return std::nullopt;
  }
}

ProjectMaterial with_measured(ProjectMaterial material, const MaterialLibrary& library) {
  if (material.measured) take_measured(material, find_f0(*material.measured, library));
  return material;
}

}  // namespace etak::editor
