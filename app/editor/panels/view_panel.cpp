// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/view_panel.h"

#include <QCheckBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/editor/fields/color_field.h"
#include "app/editor/fields/number_field.h"
#include "app/editor/fields/path_edit.h"
#include "app/editor/panels/model_list.h"
#include "app/editor/panels/sections.h"
#include "app/viewport/background.h"
#include "app/viewport/qt_text.h"
#include "core/base/error.h"
#include "core/color/ocio.h"
#include "core/light/rows.h"
#include "core/render/display.h"

namespace etak::editor {
namespace {

constexpr std::array tones{Tone::plain, Tone::neutral, Tone::agx_like, Tone::false_color};
constexpr double most_stops = 8;

// As the registry calls them.
QStringList tone_titles() {
  QStringList out;
  for (const Tone tone : tones)
    for (const LightRow& row : light_rows())
      if (row.kind == LightRowKind::tone && row.id == name(tone)) out << qt_text(row.title);
  return out;
}

QCheckBox* check(const QString& label, const QString& tip, QWidget* parent) {
  auto* out = new QCheckBox(label, parent);
  out->setToolTip(tip);
  out->setAccessibleName(label);
  return out;
}

}  // namespace

struct ViewPanel::ReadDisplays {
  std::vector<OcioDisplayInfo> displays;
  QString error;
};

ViewPanel::ReadDisplays ViewPanel::read_displays(const std::string& config) {
  ReadDisplays out;
  try {
    out.displays = OcioConfig::open(config).displays();
  } catch (const Error& error) {
    out.error = QString::fromUtf8(error.what());
  }
  return out;
}

ViewPanel::~ViewPanel() {
  pool_.clear();
  pool_.waitForDone();
}

ViewPanel::ViewPanel(Document& document, Look& look, QWidget* parent)
    : PanelScroll(tr("View"), parent), document_(document), look_(look) {
  auto* page = new QWidget(this);
  page->setAccessibleName(tr("View settings"));
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(4, 4, 4, 4);
  column->addWidget(make_display());
  column->addWidget(make_backdrop());
  column->addWidget(make_shape());
  column->addWidget(make_compare());
  column->addStretch(1);
  setWidget(page);
  pool_.setMaxThreadCount(1);
  connect(&document, &Document::view_changed, this, &ViewPanel::show_look);
  connect(&document, &Document::replaced, this, &ViewPanel::show_look);
  show_look();
}

Section* ViewPanel::make_display() {
  auto* out = new Section(tr("Display"), this);
  exposure_ = new NumberField(tr("Exposure"), -most_stops, most_stops, 0, out);
  exposure_->setToolTip(
      tr("In stops (EV): each one more doubles the light. The view \"false colours of exposure\" "
         "shows how many stops above or below 18 % grey each place is"));
  display_ = new QuietComboBox(tr("Display"), out);
  view_ = new QuietComboBox(tr("View of the display"), out);
  display_->setToolTip(
      tr("What kind of screen the picture is made for: the plain sRGB curve, or a display of the config"));
  view_->setToolTip(
      tr("How scene colours are brought to that screen: a tone curve before the one of sRGB, or the config's "
         "own "
         "views"));
  config_ = quiet_label(tr("OpenColorIO config"), out);
  auto* buttons = new QWidget(out);
  buttons->setAccessibleName(tr("OpenColorIO config, choice"));
  auto* line = new QHBoxLayout(buttons);
  line->setContentsMargins(0, 0, 0, 0);
  auto* open = new QPushButton(tr("Config\u2026"), buttons);
  open->setAccessibleName(tr("Open an OpenColorIO config"));
  auto* own = new QPushButton(tr("Own config"), buttons);
  own->setAccessibleName(tr("Take etak's own config"));
  line->addWidget(open);
  line->addWidget(own);
  out->add(tr("Exposure EV"), exposure_);
  out->add(tr("Display"), display_);
  out->add(tr("View"), view_);
  out->add(config_);
  out->add(buttons);
  connect(exposure_, &NumberField::edited, this, [this](double value, int press) {
    ProjectView view = document_.project().view;
    view.exposure = std::exp2(value);
    document_.edit_view(view, tr("exposure"), press);
  });
  connect(display_, &QComboBox::activated, this, [this] {
    showing_ = true;
    view_->clear();
    view_->addItems(display_->currentData().toStringList());
    showing_ = false;
    take_display();
  });
  connect(view_, &QComboBox::activated, this, &ViewPanel::take_display);
  const auto take_config = [this](const QString& file) {
    ProjectView view = document_.project().view;
    view.config = file.toStdString();
    view.display.clear();
    view.view.clear();
    document_.edit_view(view, tr("OpenColorIO config"), next_press_id());
  };
  connect(open, &QPushButton::clicked, this, [this, take_config] {
    const QString file = QFileDialog::getOpenFileName(this, tr("OpenColorIO config"), document_.folder(),
                                                      tr("Configs (*.ocio);;All files (*)"));
    if (!file.isEmpty()) take_config(file);
  });
  connect(own, &QPushButton::clicked, this, [take_config] { take_config({}); });
  return out;
}

Section* ViewPanel::make_backdrop() {
  auto* out = new Section(tr("Backdrop"), this);
  behind_ = new QuietComboBox(tr("Behind the object"), out);
  behind_->addItems({tr("plain colour"), tr("environment")});
  behind_->setToolTip(tr("What is seen beside the object"));
  background_ = new ColorField(tr("Background"), ProjectView().background, out);
  background_->setToolTip(tr("Linear colour behind the object"));
  blur_ = new NumberField(tr("Blur"), 0, 1, Backdrop().blur, out);
  blur_->setToolTip(
      tr("Of the environment behind the object: 0 shows it sharp, 1 as a rough surface mirrors it"));
  ground_ = check(tr("ground with contact shadow"),
                  tr("A level ground below the sphere, which shows the sphere's shadow alone"), out);
  out->add(tr("Behind"), behind_);
  out->add(tr("Blur"), blur_);
  out->add_below(tr("Colour"), background_);
  out->add(ground_);
  const auto edit = [this](const QString& what, int press, auto change) {
    ProjectView view = document_.project().view;
    change(view);
    document_.edit_view(view, what, press);
  };
  connect(behind_, &QComboBox::activated, this, [edit](int row) {
    edit(tr("backdrop"), next_press_id(), [&](ProjectView& v) { v.backdrop.environment = row == 1; });
  });
  connect(blur_, &NumberField::edited, this, [edit](double value, int press) {
    edit(tr("blur of the backdrop"), press,
         [&](ProjectView& v) { v.backdrop.blur = std::clamp(value, 0.0, 1.0); });
  });
  connect(background_, &ColorField::edited, this, [edit](const LinearRgb& c, int press) {
    edit(tr("background"), press, [&](ProjectView& v) {
      v.background = {std::max(0.0, c.r), std::max(0.0, c.g), std::max(0.0, c.b)};
    });
  });
  connect(ground_, &QCheckBox::clicked, this, [edit](bool on) {
    edit(tr("ground"), next_press_id(), [&](ProjectView& v) { v.backdrop.ground = on; });
  });
  return out;
}

void ViewPanel::take_display() {
  ProjectView view = document_.project().view;
  const bool plain = display_->currentIndex() <= 0;
  view.display = plain ? "" : display_->currentText().toStdString();
  view.view = plain ? "" : view_->currentText().toStdString();
  if (plain) view.tone = tones[static_cast<std::size_t>(std::max(0, view_->currentIndex()))];
  document_.edit_view(view, tr("display"), next_press_id());
}

void ViewPanel::fill_displays() {
  const ProjectView& view = document_.project().view;
  if (view.config == filled_config_) return;
  filled_config_ = view.config;
  // etak's own config is part of the program. A file may lie on a network share that is slow to answer, so a
  // worker reads it.
  if (view.config.empty()) return show_displays(read_displays(""));
  ReadDisplays until_read;
  if (!view.display.empty()) until_read.displays = {{view.display, {view.view}}};
  show_displays(until_read);
  pool_.clear();
  in_background(
      pool_, this, [config = view.config] { return read_displays(config); },
      [this, config = view.config](const ReadDisplays& read) {
        if (config != filled_config_) return;
        show_displays(read);
        show_look();
      });
}

void ViewPanel::show_displays(const ReadDisplays& read) {
  display_->clear();
  display_->addItem(tr("sRGB curve"), tone_titles());
  for (const OcioDisplayInfo& each : read.displays) {
    QStringList views;
    for (const std::string& view : each.views) views << qt_text(view);
    display_->addItem(qt_text(each.name), views);
  }
  const QString path = qt_text(filled_config_);
  config_->setText(!read.error.isEmpty() ? read.error
                   : path.isEmpty()      ? tr("own OpenColorIO config")
                                         : short_path(path));
  config_->setToolTip(path);
}

Section* ViewPanel::make_shape() {
  auto* out = new Section(tr("Shape"), this);
  shape_ = new QuietComboBox(tr("Shape"), out);
  shape_->addItems({tr("sphere"), tr("quad"), tr("wedge of a parameter")});
  shape_->setToolTip(tr("What the material is shown on"));
  parameter_ = new QuietComboBox(tr("Parameter of the wedge"), out);
  parameter_->setToolTip(tr("What runs from its least to its most along the wedge's spheres"));
  steps_ = new QuietSpinBox(out);
  steps_->setRange(Wedge::least_steps, Wedge::most_steps);
  steps_->setAccessibleName(tr("Steps of the wedge"));
  steps_->setToolTip(tr("Number of spheres of the wedge"));
  textured_ = check(tr("show textures"), tr("The textures of the material, or its numbers alone"), out);
  zone_ =
      check(tr("forbidden zone overlay"),
            tr("Marks F0 of a luminance between 0.20 and 0.45, where few real materials are (Ctrl+1)"), out);
  energy_ = check(tr("energy overlay"), tr("Marks where more light leaves than comes (Ctrl+2)"), out);
  angles_ = check(tr("angle zones overlay"),
                  tr("Tints where the surface is seen at 45 to 75 degrees, and at more (Ctrl+3)"), out);
  out->add(tr("Shape"), shape_);
  out->add(tr("Wedge of"), parameter_);
  out->add(tr("Steps"), steps_);
  out->add(textured_);
  out->add(zone_);
  out->add(energy_);
  out->add(angles_);
  connect(shape_, &QComboBox::activated, this, [this](int row) {
    ProjectView view = document_.project().view;
    view.wedge.on = row == 2;
    if (row != 2) view.shape = row == 1 ? etak::Shape::quad : etak::Shape::sphere;
    document_.edit_view(view, tr("shape"), next_press_id());
  });
  const auto wedge = [this](int press_id) {
    if (showing_) return;
    Wedge to = document_.project().view.wedge;
    to.parameter = parameter_->currentText().toStdString();
    to.steps = steps_->value();
    document_.edit_wedge(to, tr("wedge"), press_id);
  };
  connect(parameter_, &QComboBox::activated, this, [wedge] { wedge(next_press_id()); });
  connect(steps_, &QSpinBox::valueChanged, this, [this, wedge] { wedge(step_press_.id()); });
  const auto update_look = [this] {
    if (showing_) return;
    look_.zone_overlay = zone_->isChecked();
    look_.energy_overlay = energy_->isChecked();
    look_.angle_overlay = angles_->isChecked();
    look_.textured = textured_->isChecked();
    emit look_changed();
  };
  for (QCheckBox* each : {zone_, energy_, angles_, textured_})
    connect(each, &QCheckBox::clicked, this, update_look);
  return out;
}

Section* ViewPanel::make_compare() {
  auto* out = new Section(tr("Compare A and B"), this);
  split_ = check(tr("split the picture"),
                 tr("Side A left, side B right of a line that can be dragged (Ctrl+T)"), out);
  pinned_ = quiet_label(tr("Side B"), out);
  model_ = new QuietComboBox(tr("Specular model of side B"), out);
  model_->setToolTip(tr("The formula of side B's reflection"));
  model_->addItem(tr("as the material"), QString());
  add_models(*model_, [](const Model& each) { return each.kind != ModelKind::diffuse; });
  auto* buttons = new QWidget(out);
  buttons->setAccessibleName(tr("Side B, choice"));
  auto* line = new QHBoxLayout(buttons);
  line->setContentsMargins(0, 0, 0, 0);
  auto* pin = new QPushButton(tr("Pin as B"), buttons);
  pin->setToolTip(tr("Keep the material as it is now as side B (Ctrl+B)"));
  pin->setAccessibleName(tr("Pin the material as side B"));
  unpin_ = new QPushButton(tr("Unpin"), buttons);
  unpin_->setAccessibleName(tr("Unpin side B"));
  line->addWidget(pin);
  line->addWidget(unpin_);
  patch_ = quiet_label(tr("Difference under the cursor"), out);
  out->add(split_);
  out->add(pinned_);
  out->add(buttons);
  out->add(tr("B model"), model_);
  out->add(patch_);
  connect(split_, &QCheckBox::clicked, this, [this](bool on) {
    Comparison compare = document_.project().view.compare;
    compare.on = on;
    document_.edit_compare(compare, tr("compare"));
  });
  connect(pin, &QPushButton::clicked, this, &ViewPanel::pin_asked);
  connect(unpin_, &QPushButton::clicked, this, [this] {
    Comparison compare = document_.project().view.compare;
    compare.pinned.reset();
    document_.edit_compare(compare, tr("unpin B"));
  });
  connect(model_, &QComboBox::activated, this, [this] {
    Comparison compare = document_.project().view.compare;
    compare.model = model_->currentData().toString().toStdString();
    document_.edit_compare(compare, tr("model of B"));
  });
  return out;
}

void ViewPanel::show_patch(const QString& difference) {
  patch_->setText(difference);
}

void ViewPanel::show_look() {
  showing_ = true;
  const ProjectView& view = document_.project().view;
  // A file may hold 0, which is no number of stops.
  exposure_->show_value(std::log2(std::max(view.exposure, 1e-9)));
  fill_displays();
  display_->setCurrentIndex(view.display.empty() ? 0
                                                 : std::max(0, display_->findText(qt_text(view.display))));
  const QStringList views = display_->currentData().toStringList();
  view_->clear();
  view_->addItems(views);
  if (!view.view.empty()) view_->setCurrentText(qt_text(view.view));
  if (view.display.empty())
    view_->setCurrentIndex(static_cast<int>(std::ranges::find(tones, view.tone) - tones.begin()));
  view_->setEnabled(!views.isEmpty());
  behind_->setCurrentIndex(view.backdrop.environment ? 1 : 0);
  blur_->show_value(view.backdrop.blur);
  blur_->setEnabled(view.backdrop.environment);
  background_->show_color(view.background);
  background_->setEnabled(!view.backdrop.environment);
  ground_->setChecked(view.backdrop.ground);
  shape_->setCurrentIndex(view.wedge.on ? 2 : view.shape == etak::Shape::quad ? 1 : 0);
  QStringList parameters{QStringLiteral("gloss"), QStringLiteral("opacity")};
  if (const ProjectMaterial* m = document_.material())
    if (const Model* model = find_model(m->specular_model))
      for (const Parameter& each : model->parameters)
        if (!each.color && each.role != Role::gloss) parameters << qt_text(each.name);
  parameter_->clear();
  parameter_->addItems(parameters);
  parameter_->setCurrentText(qt_text(view.wedge.parameter));
  parameter_->setEnabled(view.wedge.on);
  steps_->setValue(view.wedge.steps);
  steps_->setEnabled(view.wedge.on);
  zone_->setChecked(look_.zone_overlay);
  energy_->setChecked(look_.energy_overlay);
  angles_->setChecked(look_.angle_overlay);
  textured_->setChecked(look_.textured);
  split_->setChecked(view.compare.on);
  pinned_->setText(view.compare.pinned
                       ? tr("B is %1, as it was when pinned").arg(qt_text(view.compare.pinned->name))
                       : tr("B is the material in hand; choose another model for it, or pin one"));
  unpin_->setEnabled(view.compare.pinned.has_value());
  model_->setCurrentIndex(std::max(0, model_->findData(qt_text(view.compare.model))));
  showing_ = false;
}

}  // namespace etak::editor
