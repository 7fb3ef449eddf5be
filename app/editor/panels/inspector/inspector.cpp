// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/inspector/inspector.h"

#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <algorithm>
#include <cmath>
#include <memory>

#include "app/document/files.h"
#include "app/document/validator.h"
#include "app/editor/panels/inspector/layers_section.h"
#include "app/editor/panels/inspector/model_section.h"
#include "app/editor/panels/inspector/source_section.h"
#include "app/editor/panels/inspector/texture_section.h"
#include "app/viewport/background.h"
#include "app/viewport/qt_text.h"
#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/certainty/identify.h"
#include "core/color/gloss.h"
#include "core/color/srgb.h"
#include "core/material/limits.h"
#include "core/validate/files/project_check.h"

namespace etak::editor {
namespace {

// Whether the record measures the diffuse colour. Records of class "surface" do, all others measure F0.
bool measures_diffuse(const std::optional<MeasuredF0>& measured, const MaterialLibrary& library) {
  if (!measured) return false;
  const auto found = record_named(library, measured->material);
  return found && !gives_f0(found->material_class);
}

// For the fields of numbers that a texture replaces.
auto has_no_texture(Channel channel) {
  return [channel](const ProjectMaterial& m) { return !gives(m, channel); };
}

QString lobe_text(const Gloss& gloss) {
  const QString exponent = std::isfinite(gloss.exponent()) ? qt_text(number(gloss.exponent(), 4)) : "\u221e";
  return QObject::tr("exponent %1   alpha roughness %2").arg(exponent, qt_text(number(gloss.alpha(), 3))) +
         (gloss.held() ? '\n' + qt_text(held_text(gloss)) : QString());
}

}  // namespace

Inspector::Inspector(Document& document, QWidget* parent)
    : PanelScroll(tr("Inspector"), tr("Material"), parent),
      document_(document),
      fields_(std::bind_front(&Inspector::edit, this)),
      empty_(
          new QLabel(tr("No material. Add one from the library, or make a new one (Ctrl+Shift+N)."), this)),
      name_(new QLineEdit(this)),
      source_(new SourceSection(document, this)),
      layers_(new LayersSection(document, this)),
      model_(new ModelSection(document, this)),
      textures_(new TextureSection(document, this)) {
  empty_->setWordWrap(true);
  empty_->setAccessibleName(tr("No material"));
  name_->setAccessibleName(tr("Name of the material"));
  column().addWidget(empty_);
  column().addWidget(name_);
  make_numbers();
  // Its texts have another height for each material: what is edited most stands above them.
  column().addWidget(source_);
  column().addWidget(layers_);
  make_rest();
  mark_textured(*numbers_, *specular_, Channel::specular);
  mark_textured(*numbers_, *diffuse_, Channel::diffuse);
  for (NumberField* each : {gloss_, roughness_}) mark_textured(*numbers_, *each, Channel::gloss);
  mark_textured(*rest_, *alpha_, Channel::alpha);
  badges_ = {{Channel::specular, numbers_->add_badge(*specular_)},
             {Channel::diffuse, numbers_->add_badge(*diffuse_)},
             {Channel::gloss, numbers_->add_badge(*gloss_)},
             {Channel::gloss, numbers_->add_badge(*roughness_)},
             {Channel::alpha, rest_->add_badge(*alpha_)}};
  column().addWidget(model_);
  column().addWidget(textures_);
  column().addStretch(1);

  name_->setToolTip(tr("What the material is called in the project and in what is exported"));
  name_->setMaxLength(static_cast<int>(most_name_bytes));
  connect(name_, &QLineEdit::editingFinished, this, [this] {
    const ProjectMaterial* m = document_.material();
    const std::string wanted = name_->text().trimmed().toStdString();
    if (m == nullptr || preview_ || wanted.empty() || name_->text().toStdString() == m->name ||
        wanted == m->name)
      return show_material();
    document_.rename(document_.current(), wanted);
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
  connect(layers_, &LayersSection::told, this, &Inspector::told);
  show_material();
}

void Inspector::make_numbers() {
  numbers_ = &add_section(tr("Surface"));
  fields_.in(*numbers_);
  specular_ = fields_.color({tr("Specular"), tr("Specular (F0)"),
                             tr("F0: what the surface reflects at normal incidence"), tr("specular colour")},
                            {0.04, 0.04, 0.04},
                            Computed{std::mem_fn(&ProjectMaterial::specular),
                                     [this](ProjectMaterial& m, const LinearRgb& color) {
                                       // A typed colour replaces the measurement, unless that measures the diffuse colour.
                                       if (!measures_diffuse(m.measured, *document_.library()))
                                         m.measured.reset();
                                       m.specular = color;
                                       // The record measures the total reflectance: the body reflects what the surface does not.
                                       if (m.measured) m = with_measured(std::move(m), *document_.library());
                                     }},
                            has_no_texture(Channel::specular));
  diffuse_ =
      fields_.color({tr("Diffuse"), "", tr("What the body scatters back"), tr("diffuse colour")}, {0, 0, 0},
                    Computed{std::mem_fn(&ProjectMaterial::diffuse),
                             [this](ProjectMaterial& m, const LinearRgb& color) {
                               if (measures_diffuse(m.measured, *document_.library())) m.measured.reset();
                               m.diffuse = color;
                             }},
                    has_no_texture(Channel::diffuse));
  for (ColorField* each : {specular_, diffuse_}) {
    each->leave_reset_to_owner();
    each->keep_place_of_badge();
  }
  specular_->offer_question(tr("What is this? Which measured materials have this F0"));
  connect(specular_, &ColorField::asked, this, &Inspector::ask_what_it_is);
  connect(specular_, &ColorField::reset_asked, this,
          [this] { reset_color(*specular_, &ProjectMaterial::specular, tr("specular colour")); });
  connect(diffuse_, &ColorField::reset_asked, this,
          [this] { reset_color(*diffuse_, &ProjectMaterial::diffuse, tr("diffuse colour")); });
  gloss_ = fields_.number(
      {tr("Gloss"), "",
       tr("Sch\u00fcler's gloss g: exponent 2^(12 g), \u03b1 = \u221a(2 / (exponent + 2)), roughness \u221a\u03b1: 0.904 for gloss 0 to 0.149 for gloss 1")},
      {0, 1, 0.75}, &ProjectMaterial::gloss, has_no_texture(Channel::gloss));
  roughness_ = fields_.number(
      {tr("Roughness"), "",
       tr("Perceptual roughness r, in place of gloss: \u03b1 = r\u00b2, gloss log2(2 / r\u2074 \u2212 2) / 12. Below 0.149 and above 0.904 there is no gloss: what takes one gets the nearest")},
      {0, 1, roughness_of_gloss(0.75)},
      Computed{[](const ProjectMaterial& m) { return m.gloss.roughness(); },
               [](ProjectMaterial& m, double roughness) { m.gloss = Gloss::of_roughness(roughness); }},
      has_no_texture(Channel::gloss));
  for (NumberField* each : {gloss_, roughness_}) {
    each->leave_reset_to_owner();
    const QString what = each == gloss_ ? tr("gloss") : tr("roughness");
    connect(each, &NumberField::reset_asked, this, [this, what] { reset_gloss(what); });
  }
  auto* lobe = quiet_label(tr("Gloss as exponent and alpha roughness"), numbers_);
  lobe->setToolTip(tr("Alpha roughness is the width of the lobe, \u03b1 = roughness\u00b2"));
  numbers_->add(lobe);
  fields_.shows({}, {}, [lobe, last = std::string()](const ProjectMaterial& m) mutable {
    set_steady_text(*lobe, lobe_text(m.gloss), last == m.name);
    last = m.name;
  });
}

void Inspector::make_rest() {
  rest_ = &add_section(tr("Opacity, emission, occlusion"));
  fields_.in(*rest_);
  alpha_ = fields_.number(
      {tr("Alpha opacity"), "",
       tr("How much of what lies behind is covered: 0 nothing, 1 all; only in the modes mask and blend"),
       tr("alpha")},
      {0, 1, 1}, &ProjectMaterial::alpha, [](const ProjectMaterial& m) {
        return m.alpha_mode != AlphaMode::opaque && !m.texture(Channel::alpha);
      });
  fields_.choice(
      {tr("Alpha mode"), "",
       tr("opaque: alpha opacity is not looked at; mask: drawn or not, by the cutoff; blend: mixed with what lies behind")},
      {tr("opaque"), tr("mask"), tr("blend")}, &ProjectMaterial::alpha_mode);
  fields_.number(
      {tr("Alpha cutoff"), "", tr("In the mode mask: what has a lower alpha opacity is not drawn at all")},
      {0, 1, 0.5}, &ProjectMaterial::alpha_cutoff,
      [](const ProjectMaterial& m) { return m.alpha_mode == AlphaMode::mask; });
  fields_.color({tr("Emission"), "", tr("Radiance that the surface sends out by itself, to all sides")},
                {0, 0, 0}, &ProjectMaterial::emission);
  fields_.number(
      {tr("Occlusion"), "", tr("Share of the light of environment and hemispheres that reaches the surface")},
      {0, 1, 1}, &ProjectMaterial::occlusion);
}

// The name of a field whose number a texture replaces says so; the field is off.
void Inspector::mark_textured(Section& section, QWidget& field, Channel channel) {
  QLabel* label = section.label_of(field);
  const QString name = label->text(), tip = label->toolTip();
  fields_.shows({}, {}, [=](const ProjectMaterial& m) {
    QStringList files;
    for (const Channel each : all_channels)
      if (m.texture(each) && gives(m, channel) &&
          (drawn_as(each) == channel || (each == Channel::base_color && channel == Channel::specular)))
        files << qt_text(m.texture(each)->path);
    label->setText(files.isEmpty() ? name : tr("%1: texture").arg(name));
    label->setToolTip(
        files.isEmpty()
            ? tip
            : tr("Each texel of %1 stands in the place of this number").arg(files.join(QLatin1String(", "))));
  });
}

void Inspector::edit(const QString& what, int press, const std::function<void(ProjectMaterial&)>& change) {
  if (document_.material() == nullptr) return;
  const ProjectMaterial before = *document_.material();
  document_.change_material(what, press, change);
  if (before.measured && !document_.material()->measured) emit told(let_go_text(before));
}

// The answer of `etak identify` to the F0 of the field, as a menu of records that can be used.
void Inspector::ask_what_it_is() {
  struct Answer {
    std::shared_ptr<const Identifier> known;  // whose entries the answer names
    Identified what;
    QString failure;
  };
  const LinearRgb f0 = specular_->color();
  in_background(
      pool_, this,
      [f0, library = document_.library()] {
        Answer out;
        out.failure = failure_of([&] {
          const AskedColour asked{f0, {}, srgb_decode(srgb_u8(f0)) == f0};
          check_asked(asked, "F0");
          out.known = std::make_shared<const Identifier>(*library, F0Solver(without_f82()),
                                                         std::vector<std::string>{}, 1);
          out.what = out.known->identify(asked);
        });
        return out;
      },
      [this](const Answer& answer) {
        if (!answer.failure.isEmpty()) return emit told(answer.failure);
        show_candidates(answer.what);
      });
}

void Inspector::show_candidates(const Identified& answer) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->setAccessibleName(tr("What this could be"));
  const auto title = [&] {
    switch (answer.verdict) {
      case ColourVerdict::sure:
        return tr("Most probably:");
      case ColourVerdict::ambiguous:
        return tr("It could be:");
      case ColourVerdict::none:
        break;
    }
    return tr("No measured material has this F0. Near to it:");
  };
  menu->addAction(title())->setEnabled(false);
  constexpr std::size_t most_shown = 8;
  for (std::size_t i = 0; i < std::min(most_shown, answer.candidates.size()); ++i) {
    const PossibleMaterial& each = answer.candidates[i];
    const QString id = qt_text(each.entry->id);
    QString text = tr("%1   %2 %   \u0394E %3")
                       .arg(qt_text(each.entry->name), qt_text(fixed(100 * each.p, 0)),
                            qt_text(number(each.delta_e, 2)));
    QAction* use = menu->addAction(text.replace('&', "&&"), this, [this, id] { source_->use(id); });
    use->setEnabled(!preview_);
    use->setData(id);
  }
  menu->popup(specular_->mapToGlobal(QPoint(0, specular_->height())));
}

// The gloss of the record that the material has or had, which is a convention; that of a new material without one.
Gloss Inspector::standard_gloss() const {
  const ProjectMaterial* m = document_.material();
  const std::optional<MeasuredF0> measured = m->measured ? m->measured : document_.let_go(m->name);
  const auto record = measured ? record_named(*document_.library(), measured->material) : std::nullopt;
  return record ? material_of(*record).gloss : ProjectMaterial{}.gloss;
}

void Inspector::reset_gloss(const QString& what) {
  if (document_.material() == nullptr) return;
  edit(what, next_press_id(), [&](ProjectMaterial& m) { m.gloss = standard_gloss(); });
}

// Sets a colour that is or was measured to the measurement, and any other to the standard of the field.
void Inspector::reset_color(ColorField& field, LinearRgb ProjectMaterial::*member, const QString& what) {
  try {
    edit(what, next_press_id(), [&](ProjectMaterial& next) {
      const std::optional<MeasuredF0> measured = next.measured ? next.measured : document_.let_go(next.name);
      const bool of_diffuse = measures_diffuse(measured, *document_.library());
      if (measured && of_diffuse == (&field == diffuse_))
        next.measured = measured;
      else
        next.*member = field.standard();
      next = with_measured(std::move(next), *document_.library());
    });
  } catch (const Error& error) {
    emit told(QString::fromUtf8(error.what()));
  }
}

void Inspector::follow(const Validator& validator) {
  validator_ = &validator;
  connect(&validator, &Validator::findings_changed, this, &Inspector::show_badges);
  show_badges();
}

void Inspector::show_badges() {
  const ProjectMaterial* m = preview_ ? nullptr : document_.material();
  for (const auto& [channel, badge] : badges_) {
    const OpenFindings found =
        m == nullptr || validator_ == nullptr ? OpenFindings{} : open_findings(*validator_, m->name, channel);
    badge->setText(found.text().isEmpty() ? QString() : QString(QChar(0x26a0)));
    badge->setToolTip(found.errors_and_warnings.join(QLatin1Char('\n')));
    badge->setAccessibleDescription(found.text());
    badge->setStyleSheet(found.errors > 0 ? QStringLiteral("color: #d8402e")
                                          : QStringLiteral("color: #c8901a"));
  }
}

void Inspector::show_preview(const std::optional<ProjectMaterial>& material) {
  if (preview_ == material) return;
  preview_ = material;
  show_material();
}

void Inspector::show_material() {
  const ProjectMaterial* m = preview_ ? &*preview_ : document_.material();
  empty_->setVisible(m == nullptr);
  source_->setVisible(m != nullptr);
  // The fields of a preview cannot be edited.
  for (QWidget* each : std::initializer_list<QWidget*>{name_, numbers_, rest_, model_, textures_}) {
    each->setVisible(m != nullptr);
    each->setEnabled(!preview_);
  }
  source_->show_material(m, !preview_);
  layers_->show_material(m, !preview_);
  model_->show_material(m);
  textures_->show_material(m);
  if (m == nullptr) return;
  const QString name = QString::fromStdString(m->name);
  if (name_->text() != name) name_->setText(name);
  fields_.show(*m);
  show_badges();
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
    return (!channel || drawn_as(each) == *channel) && m->texture(each);
  });
  if (textured != all_channels.end()) return show(textures_, &textures_->line_of(*textured));
  QWidget* field = channel == Channel::diffuse ? static_cast<QWidget*>(diffuse_)
                   : channel == Channel::gloss ? static_cast<QWidget*>(gloss_)
                   : channel == Channel::alpha ? static_cast<QWidget*>(alpha_)
                                               : static_cast<QWidget*>(specular_);
  show(field, field->findChild<FineSpinBox*>());
}

}  // namespace etak::editor
