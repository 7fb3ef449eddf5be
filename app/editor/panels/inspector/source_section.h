// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/document/document.h"
#include "app/editor/panels/inspector/sections.h"
#include "app/viewport/background.h"

class QToolButton;

namespace etak::editor {

/// The message that `m`, which has a measurement, is no longer measured.
QString let_go_text(const ProjectMaterial& m);

/// The section "Measured F0": record and dataset in one line, and behind its button (i) the spread of all datasets,
/// outside medium, illuminant, observer and what is to be said of the data.
class SourceSection : public Section {
  Q_OBJECT

 public:
  explicit SourceSection(Document& document, QWidget* parent = nullptr);

  ///   material   the current material or a previewed one; null: none
  ///   editable   false: the fields cannot be edited, as for a preview
  void show_material(const ProjectMaterial* material, bool editable);
  void set_library();
  void unfold(bool on);
  /// Takes a record as a user who types its id.
  void use(const QString& id);
  bool is_unfolded() const;
  QWidget& first_field() { return *dataset_; }

 signals:
  void told(const QString& message);

 private:
  void take();
  void make_rows();
  void show_rows();
  void tell(const ProjectMaterial& material);
  void fill_datasets(const std::string& material);

  Document& document_;
  QuietComboBox *material_, *dataset_, *outside_, *illuminant_, *observer_;
  QLabel *result_, *body_, *spread_, *citation_;
  QToolButton* unfold_ = nullptr;
  QWidget* viewing_ = nullptr;
  Worker pool_;
  std::string datasets_of_;
  std::optional<MeasuredF0> shown_;
  std::pair<std::string, MeasuredF0> told_;  // name and measurement of the material that the notes are of
  bool showing_ = false;
};

}  // namespace etak::editor
