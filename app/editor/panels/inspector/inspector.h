// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>

#include "app/document/document.h"
#include "app/editor/panels/inspector/fields_of.h"
#include "app/viewport/background.h"

class QLineEdit;

namespace etak {
struct Identified;
}

namespace etak::editor {

class ModelSection;
class LayersSection;
class SourceSection;
class TextureSection;
class Validator;

/// The fields of the current material.
class Inspector : public PanelScroll {
  Q_OBJECT

 public:
  explicit Inspector(Document& document, QWidget* parent = nullptr);

  ColorField& specular() { return *specular_; }
  ColorField& diffuse() { return *diffuse_; }
  NumberField& gloss() { return *gloss_; }
  NumberField& roughness() { return *roughness_; }
  NumberField& alpha() { return *alpha_; }
  SourceSection& source() { return *source_; }
  ModelSection& model() { return *model_; }
  TextureSection& textures() { return *textures_; }
  /// Scrolls to what a rule is about, and gives it the focus: the measured record, the file of a texture, the
  /// shading model, or the number of a channel that has no texture.
  void go_to(const std::string& rule);
  /// Marks the fields that findings are about, with their sentences as tooltips.
  void follow(const Validator& validator);
  /// Shows a material of the library in fields that cannot be edited; none: shows the current material again.
  void show_preview(const std::optional<ProjectMaterial>& material);

 signals:
  void told(const QString& message);

 private:
  void show_material();
  void make_numbers();
  void make_rest();
  void show_badges();
  void mark_textured(Section& section, QWidget& field, Channel channel);
  void edit(const QString& what, int press, const std::function<void(ProjectMaterial&)>& change);
  Gloss standard_gloss() const;
  void ask_what_it_is();
  void show_candidates(const Identified& answer);
  void reset_gloss(const QString& what);
  void reset_color(ColorField& field, LinearRgb ProjectMaterial::*member, const QString& what);

  Document& document_;
  const Validator* validator_ = nullptr;
  std::vector<std::pair<Channel, QLabel*>> badges_;
  std::optional<ProjectMaterial> preview_;
  FieldsOf<ProjectMaterial> fields_;
  QLabel* empty_;
  QLineEdit* name_;
  SourceSection* source_;
  LayersSection* layers_;
  ColorField *specular_ = nullptr, *diffuse_ = nullptr;
  NumberField *gloss_ = nullptr, *roughness_ = nullptr, *alpha_ = nullptr;
  Section *numbers_ = nullptr, *rest_ = nullptr;
  ModelSection* model_;
  TextureSection* textures_;
  Worker pool_;
};

}  // namespace etak::editor
