// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/view_panel.h"

#include <QFileDialog>
#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "app/editor/panels/difference_map.h"
#include "app/editor/panels/inspector/model_list.h"
#include "app/editor/panels/shape_box.h"
#include "app/fields/add_button.h"
#include "app/fields/path_edit.h"
#include "app/viewport/background.h"
#include "app/viewport/qt_text.h"
#include "core/color/ocio.h"
#include "core/light/rows.h"
#include "core/render/display.h"

namespace etak::editor {

QStringList tone_titles() {
  QStringList out;
  for (const Tone tone : tones)
    for (const LightRow& row : light_rows())
      if (row.kind == LightRowKind::tone && row.id == name(tone)) out << qt_text(row.title);
  return out;
}

struct ViewPanel::ReadDisplays {
  std::vector<OcioDisplayInfo> displays;
  QString error;
};

ViewPanel::ReadDisplays ViewPanel::read_displays(const std::string& config) {
  ReadDisplays out;
  out.error = failure_of([&] { out.displays = OcioConfig::open(config).displays(); });
  return out;
}

ViewPanel::ViewPanel(Document& document, Look& look, QWidget* parent)
    : PanelScroll(tr("View"), tr("View settings"), parent),
      document_(document),
      look_(look),
      view_(std::bind_front(&Document::change_view, &document)),
      overlays_([this](const QString&, int, const auto& change) {
        change(look_);
        emit look_changed();
      }) {
  make_engine();
  make_display();
  make_backdrop();
  make_shape();
  make_compare();
  column().addStretch(1);
  connect(&document, &Document::view_changed, this, &ViewPanel::show_look);
  connect(&document, &Document::replaced, this, &ViewPanel::show_look);
  show_look();
}

void ViewPanel::make_engine() {
  QStringList titles{tr("its own models")};
  for (const Engine& each : engines()) titles << qt_text(each.title);
  Section& section = add_section(tr("As in engine"));
  overlays_.in(section).choice(
      {tr("Engine"), tr("As in"),
       tr("Shows model, roughness, light from all around and tone curve as the engine publishes them, and how far that is from the exact material")},
      titles,
      Computed{[](const Look& look) {
                 const Engine* engine = find_engine(look.engine);
                 return engine == nullptr ? 0 : static_cast<int>(engine - engines().data()) + 1;
               },
               [](Look& look, int row) {
                 look.engine = row <= 0 ? "" : engines()[static_cast<std::size_t>(row - 1)].id;
               }});
  difference_ = quiet_label(tr("Difference to the exact material"), &section);
  section.add(difference_);
  difference_map_ = new DifferenceMap(tr("Difference to the exact material, in colour"), &section);
  section.add(difference_map_);
  show_difference(nullptr);
}

void ViewPanel::show_difference(const DifferencePicture* difference) {
  const Engine* engine = find_engine(look_.engine);
  const bool shown = difference != nullptr && engine != nullptr;
  difference_map_->setVisible(shown);
  QString text = tr("Whatever is chosen changes no material");
  if (shown) {
    difference_map_->show_map(*difference);
    text = tr("dE2000 to the exact material: mean %1, largest %2. %3")
               .arg(difference->mean_de, 0, 'g', 3)
               .arg(difference->max_de, 0, 'g', 3)
               .arg(qt_text(engine->source));
    if (!engine->not_drawn.empty()) text += tr(". Not drawn: %1").arg(qt_text(engine->not_drawn));
  }
  difference_->setText(text);
}

void ViewPanel::show_sides(const DifferencePicture* difference) {
  sides_map_->setVisible(difference != nullptr);
  sides_->setVisible(difference != nullptr);
  if (difference == nullptr) return;
  sides_map_->show_map(*difference);
  sides_->setText(tr("dE2000 of A to B over the object, as the display shows both: mean %1, largest %2")
                      .arg(difference->mean_de, 0, 'g', 3)
                      .arg(difference->max_de, 0, 'g', 3));
}

void ViewPanel::make_display() {
  Section& section = add_section(tr("Display"));
  view_.in(section).number(
      {tr("Exposure"), tr("Exposure EV"),
       tr("In stops (EV): each one more doubles the light. The view \"false colours of exposure\" shows how many stops above or below 18 % grey each place is")},
      exposure_range, stops_of_exposure());
  display_ = new QuietComboBox(tr("Display"), &section);
  view_of_display_ = new QuietComboBox(tr("View of the display"), &section);
  section.add(
      tr("Display"), display_,
      tr("What kind of screen the picture is made for: the plain sRGB curve, or a display of the config"));
  section.add(
      tr("View"), view_of_display_,
      tr("How scene colours are brought to that screen: a tone curve before the one of sRGB, or the config's own views"));
  connect(display_, &QComboBox::activated, this, [this] {
    view_of_display_->clear();
    view_of_display_->addItems(display_->currentData().toStringList());
    take_display();
  });
  connect(view_of_display_, &QComboBox::activated, this, &ViewPanel::take_display);
  config_ = quiet_label(tr("OpenColorIO config"), &section);
  section.add(config_);
  const auto take_config = [this](const QString& file) {
    document_.change_view(tr("OpenColorIO config"), next_press_id(), [&](ProjectView& view) {
      view.config = file.toStdString();
      view.display.clear();
      view.view.clear();
    });
  };
  QHBoxLayout& line = section.add_line(tr("OpenColorIO config, choice"));
  const auto* open = add_button<QPushButton>(line, tr("Config\u2026"), {}, tr("Open an OpenColorIO config"));
  connect(open, &QPushButton::clicked, this, [this, take_config] {
    const QString file = QFileDialog::getOpenFileName(this, tr("OpenColorIO config"), document_.folder(),
                                                      tr("Configs (*.ocio);;All files (*)"));
    if (!file.isEmpty()) take_config(file);
  });
  const auto* own = add_button<QPushButton>(line, tr("Own config"), {}, tr("Take etak's own config"));
  connect(own, &QPushButton::clicked, this, [take_config] { take_config({}); });
}

void ViewPanel::make_backdrop() {
  const auto environment = [](const ProjectView& v) { return v.backdrop.environment; };
  view_.in(add_section(tr("Backdrop")));
  view_.choice(
      {tr("Behind the object"), tr("Behind"), tr("What is seen beside the object"), tr("backdrop")},
      {tr("plain colour"), tr("environment")}, [](auto& v) -> auto& { return v.backdrop.environment; });
  view_.number(
      {tr("Blur"), "",
       tr("Of the environment behind the object: 0 shows it sharp, 1 as a rough surface mirrors it"),
       tr("blur of the backdrop")},
      {0, 1, Backdrop().blur}, [](auto& v) -> auto& { return v.backdrop.blur; }, environment);
  view_.color({tr("Background"), tr("Colour"), tr("Linear colour behind the object")},
              ProjectView().background, &ProjectView::background, std::not_fn(environment));
  view_.check(
      {tr("ground with contact shadow"), "",
       tr("A level ground below the sphere, which shows the sphere's shadow alone"), tr("ground")},
      [](auto& v) -> auto& { return v.backdrop.ground; });
}

void ViewPanel::take_display() {
  document_.change_view(tr("display"), next_press_id(), [this](ProjectView& view) {
    const bool plain = display_->currentIndex() <= 0;
    view.display = plain ? "" : display_->currentText().toStdString();
    view.view = plain ? "" : view_of_display_->currentText().toStdString();
    if (plain) view.tone = tones[static_cast<std::size_t>(std::max(0, view_of_display_->currentIndex()))];
  });
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

void ViewPanel::make_shape() {
  Section& section = add_section(tr("Shape"));
  auto* shape = new ShapeBox(document_, tr("Shape"), &section);
  section.add(tr("Shape"), shape, shape->toolTip());
  connect(shape, &ShapeBox::mesh_asked, this, &ViewPanel::mesh_asked);
  const auto wedge_on = [](const ProjectView& v) { return v.wedge.on; };
  auto* parameter = new QuietComboBox(tr("Parameter of the wedge"), &section);
  section.add(tr("Wedge of"), parameter,
              tr("What runs from its least to its most along the wedge's spheres"));
  connect(parameter, &QComboBox::activated, this, [this, parameter] {
    document_.change_view(tr("wedge"), next_press_id(), [&](ProjectView& v) {
      v.wedge.parameter = parameter->currentText().toStdString();
    });
  });
  view_.shows({parameter}, wedge_on, [this, parameter](const ProjectView& view) {
    QStringList parameters{"gloss", "opacity"};
    if (const ProjectMaterial* m = document_.material())
      if (const Model* model = find_model(m->specular_model))
        for (const Parameter& each : model->parameters)
          if (!each.color && each.role != Role::gloss) parameters << qt_text(each.name);
    parameter->show_items(parameters);
    parameter->setCurrentText(qt_text(view.wedge.parameter));
  });
  auto* steps = new FineSpinBox(&section);
  steps->setDecimals(0);
  steps->setSingleStep(1);
  steps->setRange(Wedge::least_steps, Wedge::most_steps);
  steps->setAccessibleName(tr("Steps of the wedge"));
  section.add(tr("Steps"), steps, tr("Number of spheres of the wedge"));
  connect(steps, &FineSpinBox::edited, this, [this](double count, int press) {
    document_.change_view(tr("wedge"), press,
                          [&](ProjectView& v) { v.wedge.steps = static_cast<int>(count); });
  });
  view_.shows({steps}, wedge_on, [steps](const ProjectView& view) { steps->show_value(view.wedge.steps); });
  overlays_.in(section);
  overlays_.check({tr("show textures"), "", tr("The textures of the material, or its numbers alone")},
                  &Look::textured);
  auto* blocks = overlays_.check({tr("textures as BC7"), "", ""}, &Look::in_blocks);
  overlays_.shows({}, {}, [=, this](const Look&) { show_blocks_switch(*blocks, document_.material()); });
  overlays_.check(
      {tr("forbidden zone overlay"), "",
       tr("Marks F0 of a luminance between 0.20 and 0.45, where few real materials are (Ctrl+1)")},
      &Look::zone_overlay);
  overlays_.check({tr("energy overlay"), "", tr("Marks where more light leaves than comes (Ctrl+2)")},
                  &Look::energy_overlay);
  overlays_.check({tr("angle zones overlay"), "",
                   tr("Tints where the surface is seen at 45 to 75 degrees, and at more (Ctrl+3)")},
                  &Look::angle_overlay);
}

void ViewPanel::make_compare() {
  Section& section = add_section(tr("Compare A and B"));
  view_.in(section).check(
      {tr("split the picture"), "", tr("Side A left, side B right of a line that can be dragged (Ctrl+T)"),
       tr("compare")},
      [](auto& v) -> auto& { return v.compare.on; });
  auto* pinned = quiet_label(tr("Side B"), &section);
  section.add(pinned);
  QHBoxLayout& line = section.add_line(tr("Side B, choice"));
  const auto* pin =
      add_button<QPushButton>(line, tr("Pin as B"), tr("Keep the material as it is now as side B (Ctrl+B)"),
                              tr("Pin the material as side B"));
  connect(pin, &QPushButton::clicked, this, &ViewPanel::pin_asked);
  const auto* photograph = add_button<QPushButton>(
      line, tr("Photo\u2026"),
      tr("A photograph as side B. Zoom and move the picture until the object lies on it"),
      tr("Photograph as side B"));
  connect(photograph, &QPushButton::clicked, this, &ViewPanel::photograph_asked);
  auto* unpin = add_button<QPushButton>(line, tr("Unpin"), tr("The material in hand is side B again"),
                                        tr("Unpin side B"));
  connect(unpin, &QPushButton::clicked, this, [this] {
    emit photograph_ended();
    document_.change_view(tr("unpin B"), next_press_id(), [](ProjectView& v) { v.compare.pinned.reset(); });
  });
  const auto has_pinned = [this](const ProjectView& v) {
    return v.compare.pinned.has_value() || !look_.photograph.empty();
  };
  view_.shows({unpin}, has_pinned, [this, pinned](const ProjectView& view) {
    pinned->setText(!look_.photograph.empty() ? tr("B is the photograph %1").arg(qt_text(look_.photograph))
                    : view.compare.pinned
                        ? tr("B is %1, as it was when pinned").arg(qt_text(view.compare.pinned->name))
                        : tr("B is the material in hand; choose another model for it, or pin one"));
  });
  auto* model = new QuietComboBox(tr("Specular model of side B"), &section);
  model->addItem(tr("as the material"), QString());
  add_models(*model, [](const Model& each) { return each.kind != ModelKind::diffuse; });
  section.add(tr("B model"), model, tr("The formula of side B's reflection"));
  connect(model, &QComboBox::activated, this, [this, model] {
    document_.change_view(tr("model of B"), next_press_id(), [&](ProjectView& v) {
      v.compare.model = model->currentData().toString().toStdString();
    });
  });
  view_.shows({}, {}, [model](const ProjectView& view) {
    model->setCurrentIndex(std::max(0, model->findData(qt_text(view.compare.model))));
  });
  patch_ = quiet_label(tr("Difference under the cursor"), &section);
  section.add(patch_);
  sides_ = quiet_label(tr("Difference of A and B"), &section);
  section.add(sides_);
  sides_map_ = new DifferenceMap(tr("Difference of A and B, in colour"), &section);
  section.add(sides_map_);
  show_sides(nullptr);
}

void ViewPanel::show_patch(const QString& difference) {
  patch_->setText(difference);
}

void ViewPanel::show_look() {
  const ProjectView& view = document_.project().view;
  view_.show(view);
  overlays_.show(look_);
  fill_displays();
  display_->setCurrentIndex(view.display.empty() ? 0
                                                 : std::max(0, display_->findText(qt_text(view.display))));
  const QStringList views = display_->currentData().toStringList();
  view_of_display_->show_items(views);
  if (!view.view.empty()) view_of_display_->setCurrentText(qt_text(view.view));
  if (view.display.empty())
    view_of_display_->setCurrentIndex(static_cast<int>(std::ranges::find(tones, view.tone) - tones.begin()));
  view_of_display_->setEnabled(!views.isEmpty());
}

}  // namespace etak::editor
