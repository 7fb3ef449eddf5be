// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/document/document.h"
#include "app/editor/panels/inspector/sections.h"

namespace etak::editor {

class NumberField;

/// The models that draw the material, and sliders for their parameters. Parameters that get their value from
/// the surface (n, k, f82, ...) are among them: an edit overrides the value of the surface.
class ModelSection : public Section {
  Q_OBJECT

 public:
  explicit ModelSection(Document& document, QWidget* parent = nullptr);
  void show_material(const ProjectMaterial* material);  // null: none
  QWidget& first_field() { return *specular_; }

 private:
  void rebuild();
  void set(const std::string& parameter, std::optional<double> value, int press_id);

  struct Row {
    std::string name;
    std::size_t at = 0;  // index of the parameter's first number in the values of the model
    bool diffuse = false;
    NumberField* field = nullptr;
  };
  Document& document_;
  QuietComboBox *specular_, *diffuse_;
  QLabel* about_;
  QString told_;  // of the models, without what changes with the gloss
  QWidget* sliders_;
  QFormLayout* slider_rows_;
  std::vector<Row> rows_;
  const Model *shown_specular_ = nullptr, *shown_diffuse_ = nullptr;
  bool built_ = false;
};

}  // namespace etak::editor
