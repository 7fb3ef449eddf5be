// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/inspector/model_section.h"

#include <algorithm>

#include "app/document/press_id.h"
#include "app/editor/panels/inspector/model_list.h"
#include "app/fields/number_field.h"
#include "app/viewport/qt_text.h"
#include "core/base/error.h"
#include "core/render/ambient/accuracy.h"

namespace etak::editor {
namespace {

// Whether the inspector has another field for a parameter of this role.
bool has_own_field(Role role) {
  return role == Role::diffuse || role == Role::f0 || role == Role::gloss || role == Role::curve;
}

// The end of a parameter's slider, which covers the usual range. Typed values may use the whole range of the
// model.
double most_of(const Parameter& p) {
  return p.role == Role::n ? 5 : p.role == Role::k ? 10 : p.role == Role::exponent ? 4096 : p.max;
}

double least_of(const Parameter& p) {
  return p.role == Role::n ? 0.05 : p.role == Role::exponent ? 1 : p.min;
}

}  // namespace

ModelSection::ModelSection(Document& document, QWidget* parent)
    : Section(tr("Shading model"), parent),
      document_(document),
      specular_(new QuietComboBox(tr("Specular model"), this)),
      diffuse_(new QuietComboBox(tr("Diffuse model"), this)),
      about_(quiet_label(tr("About the model"), this)),
      sliders_(new QWidget(this)),
      slider_rows_(new QFormLayout(sliders_)) {
  slider_rows_->setContentsMargins(0, 0, 0, 0);
  slider_rows_->setVerticalSpacing(4);
  sliders_->setAccessibleName(tr("Parameters of the models"));
  specular_->addItem(tr("none"), QString());
  diffuse_->addItem(tr("none"), QString());
  add_models(*specular_, [](const Model& each) { return each.kind != ModelKind::diffuse; });
  add_models(*diffuse_, [](const Model& each) { return each.kind == ModelKind::diffuse; });
  add(tr("Specular"), specular_, tr("The formula of the surface's reflection"));
  add(tr("Diffuse"), diffuse_, tr("The formula of the body's reflection"));
  add(sliders_);
  add(about_);  // of another height for each model
  const auto take = [this](QuietComboBox* box, std::string ProjectMaterial::*member) {
    connect(box, &QComboBox::activated, this, [this, box, member] {
      document_.change_material(tr("shading model"), next_press_id(), [&](ProjectMaterial& m) {
        m.*member = box->currentData().toString().toStdString();
        // Values that were set for the parameters of another model are dropped.
        m.parameters.clear();
      });
    });
  };
  take(specular_, &ProjectMaterial::specular_model);
  take(diffuse_, &ProjectMaterial::diffuse_model);
}

void ModelSection::rebuild() {
  while (slider_rows_->rowCount() > 0) slider_rows_->removeRow(0);
  rows_.clear();
  const auto add_model = [this](const Model* model, bool diffuse) {
    if (model == nullptr) return;
    std::size_t at = 0;
    for (const Parameter& p : model->parameters) {
      if (!has_own_field(p.role)) {
        auto* field =
            new NumberField(qt_text(p.name), {least_of(p), most_of(p), p.initial, p.min, p.max}, sliders_);
        field->setToolTip(p.color ? tr("%1 (all three channels)").arg(qt_text(p.meaning))
                                  : qt_text(p.meaning));
        field->leave_reset_to_owner();
        const std::string parameter(p.name);
        // "alpha" alone would be understood as opacity.
        auto* label = new QLabel(
            p.role == Role::alpha ? tr("%1 (roughness)").arg(qt_text(p.name)) : qt_text(p.name), sliders_);
        label->setToolTip(field->toolTip());
        slider_rows_->addRow(label, field);
        connect(field, &NumberField::edited, this,
                [this, parameter](double value, int press) { set(parameter, value, press); });
        connect(field, &NumberField::reset_asked, this,
                [this, parameter] { set(parameter, std::nullopt, next_press_id()); });
        rows_.push_back({parameter, at, diffuse, field});
      }
      at += p.color ? 3 : 1;
    }
  };
  add_model(shown_specular_, false);
  add_model(shown_diffuse_, true);
  sliders_->setVisible(!rows_.empty());
}

void ModelSection::set(const std::string& parameter, std::optional<double> value, int press_id) {
  document_.change_material(qt_text(parameter), press_id, [&](ProjectMaterial& m) {
    std::erase_if(m.parameters, [&](const auto& each) {
      return each.first == parameter || each.first.starts_with(parameter + ".");
    });
    if (value) m.parameters.emplace_back(parameter, *value);
  });
}

void ModelSection::show_material(const ProjectMaterial* m) {
  const Model* specular = m == nullptr ? nullptr : find_model(m->specular_model);
  const Model* diffuse = m == nullptr ? nullptr : find_model(m->diffuse_model);
  specular_->setCurrentIndex(std::max(0, m == nullptr ? 0 : specular_->findData(qt_text(m->specular_model))));
  diffuse_->setCurrentIndex(std::max(0, m == nullptr ? 0 : diffuse_->findData(qt_text(m->diffuse_model))));
  SurfaceValues surface;
  if (m != nullptr) surface = document_.surface_of(*m);
  specular = drawn_model(specular, surface);
  const bool combined = specular != nullptr && specular->kind == ModelKind::combined;
  diffuse_->setEnabled(!combined);
  diffuse_->setToolTip(combined ? tr("The specular model has a diffuse part of its own")
                                : tr("The formula of the body's reflection"));
  if (combined) diffuse = nullptr;
  if (!built_ || specular != shown_specular_ || diffuse != shown_diffuse_) {
    built_ = true;
    shown_specular_ = specular;
    shown_diffuse_ = diffuse;
    rebuild();
    QString& about = told_;
    about.clear();
    if (specular != nullptr) {
      about = tr("%1. %2. In files and on the command line: %3")
                  .arg(qt_text(specular->title), qt_text(specular->source), qt_text(specular->id));
      if (!specular->claims.reciprocal) about += tr(". Not reciprocal");
      if (!specular->claims.conserves_energy) about += tr(". May give off more light than it takes");
    }
  }
  about_->setText(told_);
  if (m == nullptr) return;
  try {
    const FittedModels fitted = fit_models(specular, diffuse, m->parameters, surface);
    for (const Row& row : rows_)
      row.field->show_value((row.diffuse ? fitted.diffuse_values : fitted.specular_values)[row.at]);
    if (specular == nullptr) return;
    const std::string moving = ambient_accuracy_text(specular->id, surface.gloss, false);
    about_->setText(told_ + tr(". Light of an environment: ") +
                    (moving.empty() ? tr("its error was not measured for this model")
                                    : tr("%1 while it moves; %2 at rest")
                                          .arg(qt_text(moving), qt_text(ambient_accuracy_text(
                                                                    specular->id, surface.gloss, true)))));
  } catch (const Error& error) {
    about_->setText(QString::fromUtf8(error.what()));
  }
}

}  // namespace etak::editor
