// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/light_panel.h"

#include <QButtonGroup>
#include <QFileDialog>
#include <QGridLayout>
#include <QPixmap>
#include <QPushButton>

#include "app/editor/panels/view_panel.h"
#include "app/fields/add_button.h"
#include "app/viewport/qt_picture.h"
#include "app/viewport/qt_text.h"
#include "core/base/error.h"
#include "core/light/studio.h"
#include "core/render/display.h"
#include "core/render/environment.h"

namespace etak::editor {
namespace {

constexpr QSize icon_size(80, 40);
constexpr int strip_columns = 3;

template <class Names>
QStringList names_of(const Names& all) {
  QStringList out;
  for (const auto each : all) out << qt_text(name(each));
  return out;
}

// A small lat-long picture of a studio, with pixels enough for twice the scale.
QIcon studio_icon(const Studio& studio) {
  const Image picture = environment_picture(studio, 2 * icon_size.width());
  return QIcon(QPixmap::fromImage(qt_image(to_codes(picture, 1, Transfer::srgb, Tone::agx_like))));
}

// The symbol and the unit of a light's intensity: an irradiance, a radiant intensity, or a radiance.
QString intensity_unit(const Light& light, bool pi_scaled) {
  if (is_area(light.kind)) return "L W/(m\u00b2 sr)";
  const bool far = light.kind == LightKind::directional;
  return QStringLiteral("%1%2 %3").arg(far ? "E" : "I", pi_scaled ? "/\u03c0" : QString(),
                                       far ? "W/m\u00b2" : "W/sr");
}

}  // namespace

LightPanel::LightPanel(Document& document, QWidget* parent)
    : PanelScroll(tr("Light"), tr("Light settings"), parent),
      document_(document),
      view_(std::bind_front(&LightPanel::edit, this)),
      light_(std::bind_front(&LightPanel::edit_light, this)),
      hemispheres_([this](const QString& step, int press, const auto& change) {
        edit(step, press, [&](ProjectView& v) {
          if (v.lights.hemispheres) change(*v.lights.hemispheres);
        });
      }) {
  make_environment();
  make_light();
  make_hemispheres();
  view_.check(
      {tr("Irradiance as E over pi"), tr("irradiance as E / \u03c0, as in the sources"),
       tr("Lights are given so that a white diffuse surface has their colour, as the articles have it"),
       tr("light unit")},
      [](auto& v) -> auto& { return v.lights.pi_scaled; }, &column());
  const auto preset = [&](const QString& label, const QString& tip, LightSetup (*setup)()) {
    connect(add_button<QPushButton>(column(), label, tip, label), &QPushButton::clicked, this,
            [this, label, setup] {
              edit(label, next_press_id(), [setup](ProjectView& v) { v.lights = setup(); });
            });
  };
  preset(tr("Studio light"), tr("The computed studio and two flashes, as in new projects"), studio_lights);
  preset(tr("Lights of the sources"),
         tr("Three directional lights and two hemispheres, as the articles light their pictures"),
         default_lights);
  column().addStretch(1);
  connect(&document, &Document::view_changed, this, &LightPanel::show_view);
  connect(&document, &Document::replaced, this, &LightPanel::show_view);
  show_view();
}

void LightPanel::make_which(Section& section) {
  QHBoxLayout& line = section.add_line(tr("Lights of the scene"));
  which_ = new QuietComboBox(tr("Light in hand"), line.parentWidget());
  which_->setToolTip(tr("The light that the fields below are of"));
  line.addWidget(which_, 1);
  connect(which_, &QComboBox::currentIndexChanged, this, [this] {
    if (!showing_) show_view();
  });
  connect(add_button(line, "+", tr("Add a light")), &QToolButton::clicked, this, [this] {
    edit(tr("add a light"), next_press_id(), [](ProjectView& v) {
      Light& light = v.lights.lights.emplace_back();
      light.kind = LightKind::point;
      light.position = {2, 2, 2};
      light.intensity = 8;
    });
    which_->setCurrentIndex(which_->count() - 1);
    show_view();
  });
  connect(add_button(line, "\u2212", tr("Remove the light")), &QToolButton::clicked, this, [this] {
    const int row = which_->currentIndex();
    if (row < 0) return;
    edit(tr("remove a light"), next_press_id(),
         [&](ProjectView& v) { v.lights.lights.erase(v.lights.lights.begin() + row); });
  });
}

void LightPanel::make_light() {
  Section& section = add_section(tr("Lights"));
  make_which(section);
  const auto area = [](const Light& light) { return is_area(light.kind); };
  const auto spot = [](const Light& light) { return light.kind == LightKind::spot; };
  light_.in(section);
  light_.choice(
      {tr("Kind of light"), tr("Kind"),
       tr("point: from a place to all sides; directional: from far away; spot: from a place within a cone; rectangle, disc: from an area, lit on the side to which its direction shows")},
      names_of(light_kinds), &Light::kind);
  light_.color({tr("Light colour"), tr("Colour"), tr("Linear colour, times the intensity")}, {1, 1, 1},
               &Light::color);
  NumberField* intensity = light_.number(
      {tr("Intensity"), tr("I"),
       tr("Factor of the light's colour. Of a directional light both together are the irradiance on a plane that faces it, in W/m\u00b2; of a point or a spot the radiant intensity in W/sr, which is the "
          "irradiance at a distance of one radius of the sphere; of an area its radiance in W/(m\u00b2 sr)")},
      {0, 20, 1, 0, 1e6}, &Light::intensity);
  intensity_unit_ = qobject_cast<QLabel*>(section.rows().labelForField(intensity));
  light_.vector(
      {tr("Light place"), tr("Place r"),
       tr("Where the light is, in radii of the sphere: right, up, towards you"), tr("place of light")},
      &Light::position, nullptr, [](const Light& l) { return l.kind != LightKind::directional; });
  light_.vector({tr("Light direction"), tr("Direction"), tr("Where the light shines to, of length 1"),
                 tr("direction of light")},
                &Light::direction, normalised_direction,
                [](const Light& l) { return l.kind != LightKind::point; });
  const QString side = tr("Side or diameter of the area, in radii of the sphere");
  light_.number({tr("Width of the area"), tr("Width r"), side}, {0.01, 10, 1, 1e-6, 1e6}, &Light::width,
                area);
  light_.number({tr("Height of the area"), tr("Height r"), side}, {0.01, 10, 1, 1e-6, 1e6}, &Light::height,
                area);
  light_.number({tr("Inner cone"), tr("Inner \u00b0"),
                 tr("Angle from the spot's axis up to which it has its whole strength, in degrees")},
                {0, 90, 20}, &Light::inner_deg, spot);
  light_.number({tr("Outer cone"), tr("Outer \u00b0"),
                 tr("Angle from the spot's axis from which on there is no light, in degrees")},
                {0, 90, 30}, &Light::outer_deg, spot);
}

void LightPanel::make_hemispheres() {
  Section& section = add_section(tr("Two hemispheres"));
  view_.in(section).check({tr("Two hemispheres on"), tr("on"),
                           tr("Light from two half spheres, one colour each"), tr("hemispheres")},
                          Computed{[](const ProjectView& v) { return v.lights.hemispheres.has_value(); },
                                   [](ProjectView& v, bool on) {
                                     v.lights.hemispheres =
                                         on ? std::optional<Hemispheres>(Hemispheres{}) : std::nullopt;
                                   }});
  // Folded while they are off, as in most projects.
  view_.shows({}, {}, [rows = &section.rows()](const ProjectView& view) {
    for (int row = 1; row < rows->rowCount(); ++row)
      rows->setRowVisible(row, view.lights.hemispheres.has_value());
  });
  hemispheres_.in(section);
  hemispheres_.color({tr("Upper hemisphere"), tr("Upper"),
                      tr("Linear colour of the half sphere around the axis: its radiance in W/(m\u00b2 sr)")},
                     {0.6, 0.7, 0.8}, &Hemispheres::upper);
  hemispheres_.color(
      {tr("Lower hemisphere"), tr("Lower"),
       tr("Linear colour of the half sphere opposite to the axis: its radiance in W/(m\u00b2 sr)")},
      {0.25, 0.22, 0.2}, &Hemispheres::lower);
  hemispheres_.vector({tr("Hemispheres' axis"), tr("Axis"), tr("Where the upper hemisphere is, of length 1")},
                      &Hemispheres::axis, normalised_direction);
  hemispheres_.choice(
      {tr("Form of the hemispheres' formula"), tr("Form"),
       tr("How the two colours are mixed: model, by the chosen model's own reflectance and lobe; Schüler's corrected; wide, with a transition that is never a step; printed, as the article has it, white on "
          "rough surfaces; auto: Schüler's for his own models, else model"),
       tr("hemispheres' form")},
      names_of(hemisphere_forms), &Hemispheres::form);
}

// The computed environments as pictures. The one that lights the scene is pressed; where it is a file or none,
// no button is.
void LightPanel::make_strip(Section& section) {
  auto* room = new QWidget(&section);
  room->setAccessibleName(tr("Computed environments"));
  auto* grid = new QGridLayout(room);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(2);
  section.add(room);
  strip_ = new QButtonGroup(this);
  strip_->setExclusive(false);
  for (const NamedStudio& each : named_studios()) {
    auto* button = new QToolButton(room);
    button->setToolTip(tr("%1: %2").arg(qt_text(each.name), qt_text(each.title)));
    button->setAccessibleName(tr("Environment %1").arg(qt_text(each.name)));
    const int at = static_cast<int>(strip_->buttons().size());
    grid->addWidget(button, at / strip_columns, at % strip_columns);
    button->setCheckable(true);
    button->setAutoRaise(true);
    button->setIconSize(icon_size);
    strip_->addButton(button);
    connect(button, &QToolButton::clicked, this, [this, &each] {
      set_environment(qt_text(each.name));
      show_view();  // a button that was pressed already stays so
    });
  }
  grid->setColumnStretch(strip_columns, 1);
}

// The pictures of the strip are drawn when they are seen first, not while the program starts.
void LightPanel::showEvent(QShowEvent* event) {
  PanelScroll::showEvent(event);
  const QList<QAbstractButton*> buttons = strip_->buttons();
  if (!buttons.front()->icon().isNull()) return;
  for (qsizetype i = 0; i < buttons.size(); ++i)
    buttons[i]->setIcon(studio_icon(named_studios()[static_cast<std::size_t>(i)].studio));
}

void LightPanel::make_environment() {
  Section& section = add_section(tr("Environment"));
  make_strip(section);
  auto* box = new QuietComboBox(tr("Environment picture"), &section);
  box->addItem(tr("none"), QString());
  for (const NamedStudio& each : named_studios()) box->addItem(qt_text(each.name), qt_text(each.name));
  section.add(
      tr("Picture"), box,
      tr("A lat-long picture of light from all sides; choosing one switches the two hemispheres off"));
  connect(box, &QComboBox::activated, this, [this, box] { set_environment(box->currentData().toString()); });
  view_.shows({}, {}, [this, box](const ProjectView& view) {
    const QString environment = qt_text(view.lights.environment);
    if (box->findData(environment) < 0) box->addItem(environment.section('/', -1), environment);
    box->setCurrentIndex(box->findData(environment));
    for (std::size_t i = 0; i < named_studios().size(); ++i)
      strip_->buttons()[static_cast<qsizetype>(i)]->setChecked(named_studios()[i].name ==
                                                               view.lights.environment);
  });
  auto* open = new QPushButton(tr("Open a lat-long HDR or EXR\u2026"), &section);
  open->setAccessibleName(tr("Open an environment picture"));
  section.add(open);
  connect(open, &QPushButton::clicked, this, &LightPanel::open_environment);
  view_.in(section);
  view_.number({tr("Environment turn"), tr("Turn \u00b0"),
                tr("Turn of the environment about the upright axis, in degrees")},
               {-180, 180, 0}, &ProjectView::environment_turn_deg);
  view_.number(
      {tr("Environment scale"), tr("Scale \u00d7"),
       tr("Factor of the picture's values, which make its radiance in W/(m\u00b2 sr)")},
      {0, 4, 1, 0, 1e6}, [](auto& v) -> auto& { return v.lights.environment_scale; });
  view_.number({tr("Exposure of the light"), tr("Exposure EV"),
                tr("In stops (EV): each one more doubles the light; the same number as in the tab View"),
                tr("exposure")},
               exposure_range, stops_of_exposure());
}

void LightPanel::open_environment() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Environment"), document_.folder(),
                                                    tr("Lat-long pictures (*.hdr *.exr);;All files (*)"));
  if (!file.isEmpty()) set_environment(file);
}

void LightPanel::set_environment(const QString& name) {
  edit(tr("environment"), next_press_id(),
       [&](ProjectView& v) { choose_environment(v.lights, name.toStdString()); });
}

void LightPanel::edit(const QString& step, int press_id, const std::function<void(ProjectView&)>& change) {
  ProjectView view = document_.project().view;
  change(view);
  try {
    validate(view.lights, "lights");
  } catch (const Error&) {
    return show_view();  // the change makes no valid setup: the fields show the present one again
  }
  document_.edit_view(view, step, press_id);
}

void LightPanel::edit_light(const QString& step, int press_id, const std::function<void(Light&)>& change) {
  const auto row = static_cast<std::size_t>(which_->currentIndex());
  edit(step, press_id, [&](ProjectView& v) {
    if (row >= v.lights.lights.size()) return;
    Light& light = v.lights.lights[row];
    change(light);
    light.outer_deg = std::max(light.inner_deg, light.outer_deg);
  });
}

void LightPanel::show_view() {
  showing_ = true;
  const ProjectView& view = document_.project().view;
  const LightSetup& lights = view.lights;
  const int row =
      std::clamp(which_->currentIndex(), 0, std::max(0, static_cast<int>(lights.lights.size()) - 1));
  QStringList all;
  for (std::size_t i = 0; i < lights.lights.size(); ++i)
    all << tr("%1: %2").arg(i + 1).arg(qt_text(name(lights.lights[i].kind)));
  which_->show_items(all);
  const bool any = !lights.lights.empty();
  which_->setCurrentIndex(any ? row : -1);
  const Light light = any ? lights.lights[static_cast<std::size_t>(row)] : Light{};
  light_.show(light, any);
  intensity_unit_->setText(intensity_unit(light, lights.pi_scaled));
  hemispheres_.show(lights.hemispheres.value_or(Hemispheres{}), lights.hemispheres.has_value());
  view_.show(view);
  showing_ = false;
}

}  // namespace etak::editor
