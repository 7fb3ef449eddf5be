// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/editor/document/document.h"
#include "app/editor/panels/sections.h"

namespace etak::editor {

class NumberField;

/// Which models draw the material, and their own parameters as sliders; those that the surface fills are
/// shown too and can be set against it.
class ModelSection : public Section {
  Q_OBJECT

 public:
  explicit ModelSection(Document& document, QWidget* parent = nullptr);
  void show_material(const ProjectMaterial* material);  // null: none

 private:
  void rebuild();
  void set(const std::string& parameter, std::optional<double> value, int press_id);

  struct Row {
    std::string name;
    std::size_t at = 0;  // of the first number in the model's values
    bool diffuse = false;
    NumberField* field = nullptr;
  };
  Document& document_;
  QuietComboBox *specular_, *diffuse_;
  QLabel* about_;
  QWidget* sliders_;
  QFormLayout* slider_rows_;
  std::vector<Row> rows_;
  const Model *shown_specular_ = nullptr, *shown_diffuse_ = nullptr;
  bool built_ = false;
};

}  // namespace etak::editor
