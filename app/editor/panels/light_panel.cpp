// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/light_panel.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QImage>
#include <QPixmap>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/editor/fields/color_field.h"
#include "app/editor/fields/number_field.h"
#include "app/editor/fields/press_id.h"
#include "app/editor/panels/sections.h"
#include "app/viewport/qt_text.h"
#include "core/base/error.h"
#include "core/light/studio.h"
#include "core/render/display.h"
#include "core/render/environment.h"

namespace etak::editor {
namespace {

constexpr QSize icon_size(54, 27);

LinearRgb rgb(const Vec3& v) {
  return {v[0], v[1], v[2]};
}

QWidget* three_boxes(const QString& name, const QString& tip, std::array<FineSpinBox*, 3>& boxes,
                     QWidget* parent) {
  auto* out = new QWidget(parent);
  out->setToolTip(tip);
  out->setAccessibleName(name);
  auto* row = new QHBoxLayout(out);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(3);
  for (std::size_t i = 0; i < 3; ++i) {
    boxes[i] = new FineSpinBox(out);
    boxes[i]->setButtonSymbols(QAbstractSpinBox::NoButtons);
    boxes[i]->setRange(-1000, 1000);
    boxes[i]->setSingleStep(0.05);
    boxes[i]->setAccessibleName(name + QLatin1Char(' ') + QLatin1Char("xyz"[i]));
    row->addWidget(boxes[i]);
  }
  return out;
}

// A small lat-long picture of a studio, with pixels enough for twice the scale.
QIcon studio_icon(const Studio& studio) {
  const Image8 codes =
      to_codes(environment_picture(studio, 2 * icon_size.width()), 1, Transfer::srgb, Tone::agx_like);
  QImage out(codes.width, codes.height, QImage::Format_RGB888);
  for (int y = 0; y < codes.height; ++y)
    std::copy_n(codes.at(0, y).data(), std::size_t{3} * static_cast<std::size_t>(codes.width),
                out.scanLine(y));
  return QIcon(QPixmap::fromImage(out));
}

}  // namespace

LightPanel::LightPanel(Document& document, QWidget* parent)
    : PanelScroll(tr("Light"), parent), document_(document) {
  auto* page = new QWidget(this);
  page->setAccessibleName(tr("Light settings"));
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(4, 4, 4, 4);
  column->addWidget(make_light());
  column->addWidget(make_hemispheres());
  column->addWidget(make_environment());
  pi_scaled_ = new QCheckBox(tr("irradiance as E / \u03c0, as in the sources"), page);
  pi_scaled_->setAccessibleName(tr("Irradiance as E over pi"));
  pi_scaled_->setToolTip(
      tr("Lights are given so that a white diffuse surface has their colour, as the articles have it"));
  column->addWidget(pi_scaled_);
  const auto preset = [&](const QString& label, const QString& tip, LightSetup (*setup)()) {
    auto* button = new QPushButton(label, page);
    button->setAccessibleName(label);
    button->setToolTip(tip);
    column->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, label, setup] {
      edit_lights(label, next_press_id(), [setup](LightSetup& l) { l = setup(); });
    });
  };
  preset(tr("Studio light"), tr("The computed studio and two flashes, as in new projects"), studio_lights);
  preset(tr("Lights of the sources"),
         tr("Three directional lights and two hemispheres, as the articles light their pictures"),
         default_lights);
  column->addStretch(1);
  setWidget(page);
  connect(pi_scaled_, &QCheckBox::clicked, this, [this](bool on) {
    edit_lights(tr("light unit"), next_press_id(), [&](LightSetup& l) { l.pi_scaled = on; });
  });
  connect(&document, &Document::view_changed, this, &LightPanel::show_view);
  connect(&document, &Document::replaced, this, &LightPanel::show_view);
  show_view();
}

Section* LightPanel::make_light() {
  auto* out = new Section(tr("Lights"), this);
  auto* row = new QWidget(out);
  row->setAccessibleName(tr("Lights of the scene"));
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(0, 0, 0, 0);
  which_ = new QuietComboBox(tr("Light in hand"), row);
  which_->setToolTip(tr("The light that the fields below are of"));
  line->addWidget(which_, 1);
  const auto button = [&](const QString& label, const QString& tip, auto act) {
    auto* tool_button = new QToolButton(row);
    tool_button->setText(label);
    tool_button->setToolTip(tip);
    tool_button->setAccessibleName(tip);
    line->addWidget(tool_button);
    connect(tool_button, &QToolButton::clicked, this, act);
  };
  button(QStringLiteral("+"), tr("Add a light"), [this] {
    edit_lights(tr("add a light"), next_press_id(), [](LightSetup& l) {
      Light light;
      light.kind = LightKind::point;
      light.position = {2, 2, 2};
      light.intensity = 8;
      l.lights.push_back(light);
    });
    which_->setCurrentIndex(which_->count() - 1);
    show_view();
  });
  button(QStringLiteral("\u2212"), tr("Remove the light"), [this] {
    const int row_now = which_->currentIndex();
    if (row_now < 0) return;
    edit_lights(tr("remove a light"), next_press_id(),
                [&](LightSetup& l) { l.lights.erase(l.lights.begin() + row_now); });
  });
  kind_ = new QuietComboBox(tr("Kind of light"), out);
  kind_->setToolTip(
      tr("point: from a place to all sides; directional: from far away; spot: from a place within a cone; "
         "rectangle, disc: from an area, lit on the side to which its direction shows"));
  for (const LightKind each : light_kinds) kind_->addItem(qt_text(name(each)));
  color_ = new ColorField(tr("Light colour"), {1, 1, 1}, out);
  intensity_ = new NumberField(tr("Intensity"), 0, 20, 1, out);
  intensity_->setToolTip(tr(
      "Factor of the light's colour. Of a directional light both together are the irradiance on a plane that "
      "faces it, in W/m\u00b2; of a point or a spot the radiant intensity in W/sr, which is the irradiance "
      "at a "
      "distance of one radius of the sphere; of an area its radiance in W/(m\u00b2 sr)"));
  color_->setToolTip(tr("Linear colour, times the intensity"));
  intensity_->box().setRange(0, 1e6);
  inner_ = new NumberField(tr("Inner cone"), 0, 90, 20, out);
  outer_ = new NumberField(tr("Outer cone"), 0, 90, 30, out);
  inner_->setToolTip(tr("Angle from the spot's axis up to which it has its whole strength, in degrees"));
  outer_->setToolTip(tr("Angle from the spot's axis from which on there is no light, in degrees"));
  out->add(row);
  out->add(tr("Kind"), kind_);
  out->add_below(tr("Colour"), color_);
  out->add(QString(), intensity_);  // show_view() writes the unit there
  intensity_unit_ = qobject_cast<QLabel*>(out->rows().labelForField(intensity_));
  out->add(
      tr("Place r"),
      three_boxes(tr("Light place"), tr("Where the light is, in radii of the sphere: right, up, towards you"),
                  position_, out));
  out->add(tr("Direction"),
           three_boxes(tr("Light direction"), tr("Where the light shines to, of length 1"), direction_, out));
  width_ = new NumberField(tr("Width of the area"), 0.01, 10, 1, out);
  height_ = new NumberField(tr("Height of the area"), 0.01, 10, 1, out);
  for (NumberField* each : {width_, height_}) {
    each->setToolTip(tr("Side or diameter of the area, in radii of the sphere"));
    each->box().setRange(1e-6, 1e6);
  }
  out->add(tr("Width r"), width_);
  out->add(tr("Height r"), height_);
  out->add(tr("Inner \u00b0"), inner_);
  out->add(tr("Outer \u00b0"), outer_);
  connect_light();
  return out;
}

void LightPanel::connect_light() {
  connect(which_, &QComboBox::currentIndexChanged, this, [this] {
    if (!showing_) show_view();
  });
  connect(kind_, &QComboBox::activated, this, [this](int row_now) {
    edit_light(tr("kind of light"), next_press_id(),
               [&](Light& light) { light.kind = light_kinds[static_cast<std::size_t>(row_now)]; });
  });
  connect(color_, &ColorField::edited, this, [this](const LinearRgb& c, int press) {
    edit_light(tr("light colour"), press, [&](Light& light) {
      light.color = {std::max(0.0, c.r), std::max(0.0, c.g), std::max(0.0, c.b)};
    });
  });
  const auto number = [this](NumberField* field, const QString& what, double Light::*member) {
    connect(field, &NumberField::edited, this, [this, what, member](double value, int press) {
      edit_light(what, press, [&](Light& light) {
        light.*member = value;
        light.outer_deg = std::max(light.inner_deg, light.outer_deg);
      });
    });
  };
  number(intensity_, tr("intensity"), &Light::intensity);
  number(inner_, tr("inner cone"), &Light::inner_deg);
  number(outer_, tr("outer cone"), &Light::outer_deg);
  number(width_, tr("width of the area"), &Light::width);
  number(height_, tr("height of the area"), &Light::height);
  for (std::size_t i = 0; i < 3; ++i) {
    connect(position_[i], &FineSpinBox::edited, this, [this, i](double value, int press) {
      edit_light(tr("place of light"), press, [&](Light& light) { light.position[i] = value; });
    });
    connect(direction_[i], &FineSpinBox::edited, this, [this, i](double value, int press) {
      edit_light(tr("direction of light"), press, [&](Light& light) {
        light.direction[i] = value;
        light.direction = normalised_direction(light.direction);
      });
    });
  }
}

Section* LightPanel::make_hemispheres() {
  auto* out = new Section(tr("Two hemispheres"), this);
  hemispheres_ = new QCheckBox(tr("on"), out);
  hemispheres_->setAccessibleName(tr("Two hemispheres on"));
  upper_ = new ColorField(tr("Upper hemisphere"), {0.6, 0.7, 0.8}, out);
  lower_ = new ColorField(tr("Lower hemisphere"), {0.25, 0.22, 0.2}, out);
  form_ = new QuietComboBox(tr("Form of the hemispheres' formula"), out);
  form_->setToolTip(
      tr("How the two colours are mixed: model, by the chosen model's own reflectance and lobe; Schüler's "
         "corrected; wide, "
         "with a transition that is never a step; printed, as the article has it, white on rough surfaces; "
         "auto: Schüler's "
         "for his own models, else model"));
  for (const HemisphereForm each : hemisphere_forms) form_->addItem(qt_text(name(each)));
  hemispheres_->setToolTip(tr("Light from two half spheres, one colour each"));
  upper_->setToolTip(tr("Linear colour of the half sphere around the axis: its radiance in W/(m\u00b2 sr)"));
  lower_->setToolTip(
      tr("Linear colour of the half sphere opposite to the axis: its radiance in W/(m\u00b2 sr)"));
  out->add(hemispheres_);
  out->add_below(tr("Upper"), upper_);
  out->add_below(tr("Lower"), lower_);
  out->add(tr("Axis"), three_boxes(tr("Hemispheres' axis"), tr("Where the upper hemisphere is, of length 1"),
                                   axis_, out));
  out->add(tr("Form"), form_);
  const auto edit = [this](const QString& what, int press, auto change) {
    edit_lights(what, press, [&](LightSetup& l) {
      if (l.hemispheres) change(*l.hemispheres);
    });
  };
  connect(hemispheres_, &QCheckBox::clicked, this, [this](bool on) {
    edit_lights(tr("hemispheres"), next_press_id(), [&](LightSetup& l) {
      l.hemispheres = on ? std::optional<Hemispheres>(Hemispheres{}) : std::nullopt;
    });
  });
  const auto color = [this, edit](ColorField* field, const QString& what, Vec3 Hemispheres::*member) {
    connect(field, &ColorField::edited, this, [edit, what, member](const LinearRgb& c, int press) {
      edit(what, press, [&](Hemispheres& h) {
        h.*member = {std::max(0.0, c.r), std::max(0.0, c.g), std::max(0.0, c.b)};
      });
    });
  };
  color(upper_, tr("upper hemisphere"), &Hemispheres::upper);
  color(lower_, tr("lower hemisphere"), &Hemispheres::lower);
  for (std::size_t i = 0; i < 3; ++i)
    connect(axis_[i], &FineSpinBox::edited, this, [edit, this, i](double value, int press) {
      edit(tr("hemispheres' axis"), press, [&](Hemispheres& h) {
        h.axis[i] = value;
        h.axis = normalised_direction(h.axis);
      });
    });
  connect(form_, &QComboBox::activated, this, [edit, this](int row) {
    edit(tr("hemispheres' form"), next_press_id(),
         [&](Hemispheres& h) { h.form = hemisphere_forms[static_cast<std::size_t>(row)]; });
  });
  return out;
}

// The computed environments as pictures. The one that lights the scene is pressed; where it is a file or none,
// no button is.
QWidget* LightPanel::make_strip() {
  auto* out = new QWidget(this);
  out->setAccessibleName(tr("Computed environments"));
  auto* row = new QHBoxLayout(out);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2);
  strip_ = new QButtonGroup(this);
  strip_->setExclusive(false);
  for (const NamedStudio& each : named_studios()) {
    auto* button = new QToolButton(out);
    button->setCheckable(true);
    button->setAutoRaise(true);
    button->setIconSize(icon_size);
    button->setToolTip(tr("%1: %2").arg(qt_text(each.name), qt_text(each.title)));
    button->setAccessibleName(tr("Environment %1").arg(qt_text(each.name)));
    row->addWidget(button);
    strip_->addButton(button);
    connect(button, &QToolButton::clicked, this, [this, name = std::string(each.name)] {
      edit_lights(tr("environment"), next_press_id(), [&](LightSetup& l) { choose_environment(l, name); });
      show_view();  // a button that was pressed already stays so
    });
  }
  row->addStretch(1);
  return out;
}

// The pictures of the strip are drawn when they are seen first, not while the program starts.
void LightPanel::showEvent(QShowEvent* event) {
  PanelScroll::showEvent(event);
  const QList<QAbstractButton*> buttons = strip_->buttons();
  if (!buttons.front()->icon().isNull()) return;
  for (qsizetype i = 0; i < buttons.size(); ++i)
    buttons[i]->setIcon(studio_icon(named_studios()[static_cast<std::size_t>(i)].studio));
}

Section* LightPanel::make_environment() {
  auto* out = new Section(tr("Environment"), this);
  environment_ = new QuietComboBox(tr("Environment picture"), out);
  environment_->addItem(tr("none"), QString());
  for (const NamedStudio& each : named_studios())
    environment_->addItem(qt_text(each.name), qt_text(each.name));
  scale_ = new NumberField(tr("Environment scale"), 0, 4, 1, out);
  environment_->setToolTip(
      tr("A lat-long picture of light from all sides; choosing one switches the two hemispheres off"));
  scale_->setToolTip(tr("Factor of the picture's values, which make its radiance in W/(m\u00b2 sr)"));
  scale_->box().setRange(0, 1e6);
  turn_ = new NumberField(tr("Environment turn"), -180, 180, 0, out);
  turn_->setToolTip(tr("Turn of the environment about the upright axis, in degrees"));
  auto* open = new QPushButton(tr("Open a lat-long HDR or EXR\u2026"), out);
  open->setAccessibleName(tr("Open an environment picture"));
  out->add(make_strip());
  out->add(tr("Picture"), environment_);
  out->add(open);
  out->add(tr("Scale \u00d7"), scale_);
  out->add(tr("Turn \u00b0"), turn_);
  connect(environment_, &QComboBox::activated, this, [this] {
    edit_lights(tr("environment"), next_press_id(), [&](LightSetup& l) {
      choose_environment(l, environment_->currentData().toString().toStdString());
    });
  });
  connect(open, &QPushButton::clicked, this, [this] {
    const QString file = QFileDialog::getOpenFileName(this, tr("Environment"), document_.folder(),
                                                      tr("Lat-long pictures (*.hdr *.exr);;All files (*)"));
    if (!file.isEmpty())
      edit_lights(tr("environment"), next_press_id(),
                  [&](LightSetup& l) { choose_environment(l, file.toStdString()); });
  });
  connect(scale_, &NumberField::edited, this, [this](double value, int press) {
    edit_lights(tr("environment scale"), press, [&](LightSetup& l) { l.environment_scale = value; });
  });
  connect(turn_, &NumberField::edited, this, [this](double value, int press) {
    ProjectView view = document_.project().view;
    view.environment_turn_deg = value;
    document_.edit_view(view, tr("environment turn"), press);
  });
  return out;
}

void LightPanel::edit_lights(const QString& what, int press_id,
                             const std::function<void(LightSetup&)>& change) {
  ProjectView view = document_.project().view;
  change(view.lights);
  try {
    validate(view.lights, "lights");
  } catch (const Error&) {
    return show_view();  // the change makes no valid setup: the fields show the present one again
  }
  document_.edit_view(view, what, press_id);
}

void LightPanel::edit_light(const QString& what, int press_id, const std::function<void(Light&)>& change) {
  const int row = which_->currentIndex();
  edit_lights(what, press_id, [&](LightSetup& l) {
    if (row >= 0 && row < static_cast<int>(l.lights.size())) change(l.lights[static_cast<std::size_t>(row)]);
  });
}

void LightPanel::show_view() {
  showing_ = true;
  const ProjectView& view = document_.project().view;
  const LightSetup& lights = view.lights;
  const int row =
      std::clamp(which_->currentIndex(), 0, std::max(0, static_cast<int>(lights.lights.size()) - 1));
  which_->clear();
  for (std::size_t i = 0; i < lights.lights.size(); ++i)
    which_->addItem(tr("%1: %2").arg(i + 1).arg(qt_text(name(lights.lights[i].kind))));
  which_->setCurrentIndex(lights.lights.empty() ? -1 : row);
  const bool any = !lights.lights.empty();
  const Light light = any ? lights.lights[static_cast<std::size_t>(row)] : Light{};
  kind_->setCurrentIndex(static_cast<int>(light.kind));
  color_->show_color(rgb(light.color));
  intensity_->show_value(light.intensity);
  // What the number is of, with its unit: an irradiance or a radiant intensity.
  const bool far = light.kind == LightKind::directional, area = is_area(light.kind);
  intensity_unit_->setText(area ? QStringLiteral("L W/(m\u00b2 sr)")
                                : (far ? QStringLiteral("E") : QStringLiteral("I")) +
                                      (lights.pi_scaled ? QStringLiteral("/\u03c0 ") : QStringLiteral(" ")) +
                                      (far ? QStringLiteral("W/m\u00b2") : QStringLiteral("W/sr")));
  width_->show_value(light.width);
  height_->show_value(light.height);
  for (NumberField* each : {width_, height_}) each->setEnabled(any && area);
  inner_->show_value(light.inner_deg);
  outer_->show_value(light.outer_deg);
  for (std::size_t i = 0; i < 3; ++i) {
    position_[i]->show_value(light.position[i]);
    direction_[i]->show_value(light.direction[i]);
    position_[i]->setEnabled(any && light.kind != LightKind::directional);
    direction_[i]->setEnabled(any && light.kind != LightKind::point);
  }
  for (QWidget* each :
       {static_cast<QWidget*>(kind_), static_cast<QWidget*>(color_), static_cast<QWidget*>(intensity_)})
    each->setEnabled(any);
  for (NumberField* each : {inner_, outer_}) each->setEnabled(any && light.kind == LightKind::spot);
  hemispheres_->setChecked(lights.hemispheres.has_value());
  const Hemispheres h = lights.hemispheres.value_or(Hemispheres{});
  upper_->show_color(rgb(h.upper));
  lower_->show_color(rgb(h.lower));
  form_->setCurrentIndex(static_cast<int>(h.form));
  for (std::size_t i = 0; i < 3; ++i) {
    axis_[i]->show_value(h.axis[i]);
    axis_[i]->setEnabled(lights.hemispheres.has_value());
  }
  for (QWidget* each :
       {static_cast<QWidget*>(upper_), static_cast<QWidget*>(lower_), static_cast<QWidget*>(form_)})
    each->setEnabled(lights.hemispheres.has_value());
  const QString environment = qt_text(lights.environment);
  if (environment_->findData(environment) < 0)
    environment_->addItem(environment.section(QLatin1Char('/'), -1), environment);
  environment_->setCurrentIndex(environment_->findData(environment));
  for (std::size_t i = 0; i < named_studios().size(); ++i)
    strip_->buttons()[static_cast<qsizetype>(i)]->setChecked(named_studios()[i].name == lights.environment);
  scale_->show_value(lights.environment_scale);
  turn_->show_value(view.environment_turn_deg);
  pi_scaled_->setChecked(lights.pi_scaled);
  showing_ = false;
}

}  // namespace etak::editor
