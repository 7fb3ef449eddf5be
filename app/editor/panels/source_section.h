// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QThreadPool>

#include "app/editor/document/document.h"
#include "app/editor/panels/sections.h"

namespace etak::editor {

/// "Use measured F0 of ...": material, dataset with the spread of all of them, outside medium, illuminant,
/// observer.
class SourceSection : public Section {
  Q_OBJECT

 public:
  explicit SourceSection(Document& document, QWidget* parent = nullptr);
  ~SourceSection() override;

  void show_material();
  void set_library();

 private:
  void take();
  void tell(const ProjectMaterial& material);
  void fill_datasets(const std::string& material);

  Document& document_;
  QuietComboBox *material_, *dataset_, *outside_, *illuminant_, *observer_;
  QLabel *result_, *body_, *spread_, *citation_;
  QThreadPool pool_;
  std::string datasets_of_;
  bool showing_ = false;
};

}  // namespace etak::editor
