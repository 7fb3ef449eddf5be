// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/inspector.h"

#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>
#include <cmath>

#include "app/editor/fields/color_field.h"
#include "app/editor/fields/number_field.h"
#include "app/editor/fields/press_id.h"
#include "app/editor/panels/model_section.h"
#include "app/editor/panels/source_section.h"
#include "app/editor/panels/texture_section.h"
#include "core/base/error.h"
#include "core/base/number.h"
#include "core/color/gloss.h"
#include "core/material/limits.h"
#include "core/validate/files/project_check.h"

namespace etak::editor {
namespace {

// Whether the record measures the diffuse colour. Records of class "surface" do, all others measure F0.
bool measures_diffuse(const std::optional<MeasuredF0>& measured, const MaterialLibrary& library) {
  if (!measured) return false;
  const auto found = library.find(measured->material);
  return found && !gives_f0(found->material_class);
}

}  // namespace

Inspector::Inspector(Document& document, QWidget* parent)
    : PanelScroll(tr("Inspector"), parent),
      document_(document),
      page_(new QWidget(this)),
      empty_(
          new QLabel(tr("No material. Add one from the library, or make a new one (Ctrl+Shift+N)."), this)),
      name_(new QLineEdit(this)),
      source_(new SourceSection(document, this)),
      model_(new ModelSection(document, this)),
      textures_(new TextureSection(document, this)) {
  auto* column = new QVBoxLayout(page_);
  column->setContentsMargins(4, 4, 4, 4);
  column->setSpacing(6);
  empty_->setWordWrap(true);
  empty_->setAccessibleName(tr("No material"));
  name_->setAccessibleName(tr("Name of the material"));
  page_->setAccessibleName(tr("Material"));
  column->addWidget(empty_);
  column->addWidget(name_);
  column->addWidget(source_);
  column->addWidget(make_numbers());
  column->addWidget(model_);
  column->addWidget(textures_);
  column->addStretch(1);
  setWidget(page_);

  name_->setToolTip(tr("What the material is called in the project and in what is exported"));
  name_->setMaxLength(static_cast<int>(most_name_bytes));
  connect(name_, &QLineEdit::editingFinished, this, [this] {
    const std::string wanted = name_->text().trimmed().toStdString();
    if (document_.material() == nullptr || preview_ || wanted.empty() ||
        name_->text().toStdString() == document_.material()->name || wanted == document_.material()->name)
      return show_material();
    ProjectMaterial next = *document_.material();
    next.name = free_name(document_.project(), wanted);
    document_.edit(document_.current(), next, tr("rename"), next_press_id());
  });
  connect(&document, &Document::current_changed, this, &Inspector::show_material);
  connect(&document, &Document::replaced, this, &Inspector::show_material);
  connect(&document, &Document::material_changed, this, [this](int index) {
    if (index == document_.current()) show_material();
  });
  connect(&document, &Document::spectra_changed, this, [this] {
    source_->set_library();
    show_material();
  });
  connect(source_, &SourceSection::told, this, &Inspector::told);
  show_material();
}

QWidget* Inspector::make_numbers() {
  numbers_ = new Section(tr("Surface"), this);
  specular_ = new ColorField(tr("Specular"), {0.04, 0.04, 0.04}, numbers_);
  diffuse_ = new ColorField(tr("Diffuse"), {0, 0, 0}, numbers_);
  gloss_ = new NumberField(tr("Gloss"), 0, 1, 0.75, numbers_);
  gloss_->setToolTip(
      tr("Sch\u00fcler's gloss g: exponent 2^(12 g), \u03b1 = \u221a(2 / (exponent + 2)), roughness "
         "\u221a\u03b1: "
         "0.904 for gloss 0 to 0.149 for gloss 1"));
  roughness_ = new NumberField(tr("Roughness"), 0, 1, roughness_of_gloss(0.75), numbers_);
  roughness_->setToolTip(tr(
      "Perceptual roughness r, in place of gloss: \u03b1 = r\u00b2, gloss log2(2 / r\u2074 \u2212 2) / 12. "
      "Below 0.149 and above 0.904 there is no gloss: what takes one gets the nearest"));
  alpha_ = new NumberField(tr("Alpha opacity"), 0, 1, 1, numbers_);
  alpha_->setToolTip(
      tr("How much of what lies behind is covered: 0 nothing, 1 all; only in the modes mask and blend"));
  cutoff_ = new NumberField(tr("Alpha cutoff"), 0, 1, 0.5, numbers_);
  cutoff_->setToolTip(tr("In the mode mask: what has a lower alpha opacity is not drawn at all"));
  alpha_mode_ = new QuietComboBox(tr("Alpha mode"), numbers_);
  alpha_mode_->addItems({tr("opaque"), tr("mask"), tr("blend")});
  alpha_mode_->setToolTip(
      tr("opaque: alpha opacity is not looked at; mask: drawn or not, by the cutoff; blend: mixed "
         "with what lies behind"));
  emission_ = new ColorField(tr("Emission"), {0, 0, 0}, numbers_);
  emission_->setToolTip(tr("Radiance that the surface sends out by itself, to all sides"));
  occlusion_ = new NumberField(tr("Occlusion"), 0, 1, 1, numbers_);
  occlusion_->setToolTip(tr("Share of the light of environment and hemispheres that reaches the surface"));
  specular_->setToolTip(tr("F0: what the surface reflects at normal incidence"));
  diffuse_->setToolTip(tr("What the body scatters back"));
  lobe_ = quiet_label(tr("Gloss as exponent and alpha roughness"), numbers_);
  lobe_->setToolTip(tr("Alpha roughness is the width of the lobe, \u03b1 = roughness\u00b2"));
  numbers_->add_below(tr("Specular (F0)"), specular_);
  numbers_->add_below(tr("Diffuse"), diffuse_);
  numbers_->add(tr("Gloss"), gloss_);
  numbers_->add(tr("Roughness"), roughness_);
  numbers_->add(lobe_);
  numbers_->add(tr("Alpha opacity"), alpha_);
  numbers_->add(tr("Alpha mode"), alpha_mode_);
  numbers_->add(tr("Alpha cutoff"), cutoff_);
  numbers_->add_below(tr("Emission"), emission_);
  numbers_->add(tr("Occlusion"), occlusion_);

  connect_colors();
  connect_numbers();
  return numbers_;
}

void Inspector::edit(const QString& what, int press, const std::function<void(ProjectMaterial&)>& change) {
  if (document_.material() == nullptr) return;
  ProjectMaterial next = *document_.material();
  change(next);
  const ProjectMaterial before = *document_.material();
  document_.edit(document_.current(), next, what, press);
  if (before.measured && !next.measured) emit told(let_go_text(before));
}

void Inspector::connect_colors() {
  connect(specular_, &ColorField::edited, this, [this](const LinearRgb& color, int press) {
    edit(tr("specular colour"), press, [&](ProjectMaterial& m) {
      // A typed colour replaces the measurement, unless that measures the diffuse colour.
      if (!measures_diffuse(m.measured, *document_.library())) m.measured.reset();
      m.specular = color;
      // The record measures the total reflectance: the surface reflects its part, and the body the rest.
      if (m.measured) m = with_measured(std::move(m), *document_.library());
    });
  });
  connect(diffuse_, &ColorField::edited, this, [this](const LinearRgb& color, int press) {
    edit(tr("diffuse colour"), press, [&](ProjectMaterial& m) {
      if (measures_diffuse(m.measured, *document_.library())) m.measured.reset();
      m.diffuse = color;
    });
  });
  connect(emission_, &ColorField::edited, this, [this](const LinearRgb& color, int press) {
    edit(tr("emission"), press, [&](ProjectMaterial& m) {
      m.emission = {std::max(0.0, color.r), std::max(0.0, color.g), std::max(0.0, color.b)};
    });
  });
  specular_->leave_reset_to_owner();
  diffuse_->leave_reset_to_owner();
  connect(specular_, &ColorField::reset_asked, this,
          [this] { reset_color(*specular_, &ProjectMaterial::specular, tr("specular colour")); });
  connect(diffuse_, &ColorField::reset_asked, this,
          [this] { reset_color(*diffuse_, &ProjectMaterial::diffuse, tr("diffuse colour")); });
}

// Sets a colour that is or was measured to the measurement, and any other to the standard of the field.
void Inspector::reset_color(ColorField& field, LinearRgb ProjectMaterial::*member, const QString& what) {
  const ProjectMaterial* m = document_.material();
  if (m == nullptr) return;
  const std::optional<MeasuredF0> measured = m->measured ? m->measured : document_.let_go(m->name);
  const bool of_diffuse = measures_diffuse(measured, *document_.library());
  const bool is_measured = measured && of_diffuse == (&field == diffuse_);
  try {
    edit(what, next_press_id(), [&](ProjectMaterial& next) {
      if (is_measured)
        next.measured = measured;
      else
        next.*member = field.standard();
      next = with_measured(std::move(next), *document_.library());
    });
  } catch (const Error& error) {
    emit told(QString::fromUtf8(error.what()));
  }
}

void Inspector::connect_numbers() {
  const auto number = [this](NumberField* field, const QString& what, double ProjectMaterial::*member) {
    connect(field, &NumberField::edited, this, [this, what, member](double value, int press) {
      edit(what, press, [&](ProjectMaterial& m) { m.*member = value; });
    });
  };
  connect(gloss_, &NumberField::edited, this, [this](double value, int press) {
    edit(tr("gloss"), press, [&](ProjectMaterial& m) { m.gloss = value; });
  });
  connect(roughness_, &NumberField::edited, this, [this](double value, int press) {
    edit(tr("roughness"), press, [&](ProjectMaterial& m) { m.gloss = Gloss::of_roughness(value); });
  });
  number(alpha_, tr("alpha"), &ProjectMaterial::alpha);
  number(cutoff_, tr("alpha cutoff"), &ProjectMaterial::alpha_cutoff);
  number(occlusion_, tr("occlusion"), &ProjectMaterial::occlusion);
  connect(alpha_mode_, &QComboBox::activated, this, [this](int row) {
    edit(tr("alpha mode"), next_press_id(),
         [&](ProjectMaterial& m) { m.alpha_mode = static_cast<AlphaMode>(row); });
  });
}

void Inspector::show_preview(const std::optional<ProjectMaterial>& material) {
  if (preview_ == material) return;
  preview_ = material;
  show_material();
}

void Inspector::show_material() {
  const ProjectMaterial* m = preview_ ? &*preview_ : document_.material();
  empty_->setVisible(m == nullptr);
  for (QWidget* each :
       {static_cast<QWidget*>(name_), static_cast<QWidget*>(source_), static_cast<QWidget*>(numbers_),
        static_cast<QWidget*>(model_), static_cast<QWidget*>(textures_)})
    each->setVisible(m != nullptr);
  // The fields of a preview cannot be edited.
  for (QWidget* each : {static_cast<QWidget*>(name_), static_cast<QWidget*>(numbers_),
                        static_cast<QWidget*>(model_), static_cast<QWidget*>(textures_)})
    each->setEnabled(!preview_);
  source_->show_material(m, !preview_);
  model_->show_material(m);
  textures_->show_material(m);
  if (m == nullptr) return;
  const QString name = QString::fromStdString(m->name);
  if (name_->text() != name) name_->setText(name);
  specular_->show_color(m->specular);
  diffuse_->show_color(m->diffuse);
  gloss_->show_value(m->gloss);
  roughness_->show_value(m->gloss.roughness());
  alpha_->show_value(m->alpha);
  cutoff_->show_value(m->alpha_cutoff);
  emission_->show_color(m->emission);
  occlusion_->show_value(m->occlusion);
  alpha_->setEnabled(m->alpha_mode != AlphaMode::opaque);
  cutoff_->setEnabled(m->alpha_mode == AlphaMode::mask);
  alpha_mode_->setCurrentIndex(static_cast<int>(m->alpha_mode));
  QString lobe = tr("exponent %1   alpha roughness %2")
                     .arg(std::isfinite(m->gloss.exponent())
                              ? QString::fromStdString(etak::number(m->gloss.exponent(), 4))
                              : QStringLiteral("\u221e"),
                          QString::fromStdString(etak::number(m->gloss.alpha(), 3)));
  if (m->gloss.held()) lobe += QStringLiteral("\n") + QString::fromStdString(held_text(m->gloss));
  lobe_->setText(lobe);
}

void Inspector::go_to(const std::string& rule) {
  const ProjectMaterial* m = document_.material();
  if (m == nullptr) return;
  const auto show = [this](QWidget* part, QWidget* field) {
    ensureWidgetVisible(part);
    field->setFocus(Qt::OtherFocusReason);
  };
  if (rule.starts_with("ETK6")) return show(source_, &source_->first_field());
  if (rule == "ETK206") return show(model_, &model_->first_field());
  const std::optional<Channel> channel = field_of(rule);
  const auto textured = std::find_if(all_channels.begin(), all_channels.end(), [&](Channel each) {
    return (!channel || each == *channel) && m->texture(each);
  });
  if (textured != all_channels.end()) return show(textures_, &textures_->line_of(*textured));
  QWidget* field = channel == Channel::diffuse ? static_cast<QWidget*>(diffuse_)
                   : channel == Channel::gloss ? static_cast<QWidget*>(gloss_)
                   : channel == Channel::alpha ? static_cast<QWidget*>(alpha_)
                                               : static_cast<QWidget*>(specular_);
  show(field, field->findChild<FineSpinBox*>());
}

}  // namespace etak::editor
