// SPDX-License-Identifier: Apache-2.0
// What is switched by actions that the bar above the viewport and the menu View share, the history and the preferences.
#include <QAction>
#include <QColorSpace>
#include <QDockWidget>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QImageReader>
#include <QLabel>
#include <QTabWidget>
#include <QToolButton>
#include <QUndoView>
#include <algorithm>

#include "app/document/press_id.h"
#include "app/editor/panels/inspector/sections.h"
#include "app/editor/panels/light_panel.h"
#include "app/editor/panels/preferences.h"
#include "app/editor/panels/view_bar.h"
#include "app/editor/panels/view_panel.h"
#include "app/editor/window.h"
#include "app/viewport/background.h"
#include "core/image/image_io.h"
#include "core/project/shown_mesh.h"

namespace etak::editor {

QAction* Window::switch_action(const QString& title, const QString& tip, const QKeySequence& keys,
                               const std::function<bool()>& is_on, const std::function<void()>& act) {
  auto* out = new QAction(title, this);
  out->setCheckable(true);
  out->setToolTip(tip);
  out->setShortcut(keys);
  connect(out, &QAction::triggered, this, [this, act] {
    act();
    show_switches();  // one that was on may stay so
  });
  switches_.emplace_back([out, is_on] { out->setChecked(is_on()); });
  return out;
}

void Window::show_switches() {
  for (const auto& each : switches_) each();
}

void Window::make_looks() {
  auto* corner = new QWidget(tabs_);
  corner->setAccessibleName(tr("Ways of looking"));
  auto* row = new QHBoxLayout(corner);
  row->setContentsMargins(0, 0, 4, 2);
  row->setSpacing(2);
  const auto add = [&](const QString& title, const QString& tip, bool (*is)(const ProjectView&),
                       void (*take)(ProjectView&)) {
    QAction* out = switch_action(
        title, tip, {}, [this, is] { return is(document_.project().view); },
        [this, title, take] { document_.change_view(title.toLower(), next_press_id(), take); });
    auto* button = new QToolButton(corner);
    button->setDefaultAction(out);
    button->setAccessibleName(title);
    button->setProperty("chip", true);  // shows clearly that it is on, in both themes
    row->addWidget(button);
    return out;
  };
  look_action_ =
      add(tr("Look"), tr("Environment behind, ground and a neutral tone curve, as in new projects"), is_look,
          take_look);
  measure_action_ = add(tr("Measure"), tr("Grey background, plain sRGB curve, exposure 0: 18 % is code 118"),
                        is_measure, take_measure);
  tabs_->setCornerWidget(corner);
}

void Window::make_view_bar(QWidget* parent) {
  view_bar_ = new ViewBar(document_, parent);
  connect(view_bar_, &ViewBar::mesh_asked, this, &Window::choose_mesh);
  connect(view_bar_, &ViewBar::open_environment_asked, this, [this] { light_panel_->open_environment(); });
  const auto of_backdrop = [this](const QString& title, const QString& tip, const QString& step,
                                  bool Backdrop::*part) {
    return switch_action(
        title, tip, {}, [this, part] { return document_.project().view.backdrop.*part; },
        [this, step, part] {
          document_.change_view(step, next_press_id(),
                                [part](ProjectView& view) { view.backdrop.*part = !(view.backdrop.*part); });
        });
  };
  view_bar_->add_menu(tr("Backdrop"), tr("What is seen beside the object"),
                      {of_backdrop(tr("Environment &behind"), tr("The environment behind the object"),
                                   tr("backdrop"), &Backdrop::environment),
                       of_backdrop(tr("&Ground"), tr("A level ground with the sphere's shadow"), tr("ground"),
                                   &Backdrop::ground)});
  const auto of_look = [this](const QString& title, const QString& tip, const QKeySequence& keys,
                              bool Look::*part) {
    return switch_action(
        title, tip, keys, [this, part] { return look_.*part; },
        [this, part] {
          look_.*part = !(look_.*part);
          look_changed();
        });
  };
  overlays_ = {of_look(tr("Forbidden &zone overlay"), tr("F0 between 0.20 and 0.45"), QKeySequence("Ctrl+1"),
                       &Look::zone_overlay),
               of_look(tr("&Energy overlay"), tr("More light leaves than comes"), QKeySequence("Ctrl+2"),
                       &Look::energy_overlay),
               of_look(tr("Angle z&ones overlay"), tr("Seen at 45 to 75 degrees, and at more"),
                       QKeySequence("Ctrl+3"), &Look::angle_overlay),
               of_look(tr("Textures as &BC7"), {}, QKeySequence("Ctrl+5"), &Look::in_blocks)};
  switches_.emplace_back(
      [this, blocks = overlays_.back()] { show_blocks_switch(*blocks, document_.material()); });
  view_bar_->add_menu(
      tr("Overlays"), tr("What is marked in the picture (Ctrl+1 to Ctrl+3), and the textures (Ctrl+5)"),
      overlays_ + QList<QAction*>{of_look(tr("Show te&xtures"), tr("The material's textures, or its numbers"),
                                          {}, &Look::textured)});
  perspective_action_ = of_look(tr("Perspecti&ve camera"),
                                tr("From near by, 30 degrees high, in place of parallel rays (Ctrl+4)"),
                                QKeySequence("Ctrl+4"), &Look::perspective);
  compare_action_ = switch_action(
      tr("&Compare A and B"), tr("Side A left, side B right of a line that can be dragged (Ctrl+T)"),
      QKeySequence(Qt::CTRL | Qt::Key_T), [this] { return document_.project().view.compare.on; },
      [this] {
        document_.change_view(tr("compare"), next_press_id(),
                              [](ProjectView& view) { view.compare.on = !view.compare.on; });
      });
  compare_action_->setIconText(tr("A | B"));
  view_bar_->add(compare_action_);
}

void Window::choose_mesh() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Show on a mesh"), beside_project(),
                                                    tr("Scenes of glTF (*.gltf *.glb);;All files (*)"));
  if (!file.isEmpty()) take_mesh(file);
}

void Window::take_mesh(const QString& file) {
  document_.change_view(tr("mesh"), next_press_id(), [&](ProjectView& view) {
    view.mesh = file.toStdString();
    view.shape = Shape::sphere;
    view.wedge.on = false;
  });
}

void Window::load_mesh() {
  const std::string& name = document_.project().view.mesh;
  if (name == mesh_key_) return;
  mesh_key_ = name;
  look_.mesh.reset();
  mesh_coming_ = !name.empty();
  if (name.empty()) return;
  struct Loaded {
    std::shared_ptr<const MeshShape> mesh;
    QString failure;
  };
  in_background(
      heavy_, this,
      [name] {
        Loaded out;
        out.failure = failure_of([&] { out.mesh = shown_mesh(name, picture_door().mesh, 2); },
                                 tr("not enough memory for the mesh"));
        return out;
      },
      [this, name](const Loaded& loaded) {
        if (name != mesh_key_) return;
        mesh_coming_ = false;
        look_.mesh = loaded.mesh;
        if (!loaded.failure.isEmpty())
          show_problems(tr("The mesh could not be read; the sphere is shown"), {loaded.failure});
        refresh_timer_.start();
      });
}

void Window::choose_photograph() {
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Photograph as side B"), beside_project(),
                                   tr("Photographs (*.png *.jpg *.jpeg *.bmp *.webp);;All files (*)"));
  if (!file.isEmpty()) take_photograph(file);
}

void Window::take_photograph(const QString& file) {
  struct Read {
    QImage picture;
    QString failure;
  };
  read_or_write(
      [file] {
        constexpr int most = 2048;  // what a screen shows of it
        QImageReader reader(file);
        reader.setAutoTransform(true);
        Read out{reader.read(), {}};
        if (out.picture.isNull()) out.failure = tr("%1: %2").arg(file, reader.errorString());
        if (out.picture.colorSpace().isValid()) out.picture.convertToColorSpace(QColorSpace::SRgb);
        if (std::max(out.picture.width(), out.picture.height()) > most)
          out.picture = out.picture.scaled(most, most, Qt::KeepAspectRatio, Qt::SmoothTransformation);
        return out;
      },
      [this, file](const Read& read) {
        if (!read.failure.isEmpty()) return show_problems(tr("No photograph was taken"), {read.failure});
        show_photograph(read.picture, QFileInfo(file).fileName());
        document_.change_view(tr("photograph as B"), next_press_id(),
                              [](ProjectView& view) { view.compare.on = true; });
      });
}

void Window::show_photograph(const QImage& photograph, const QString& name) {
  if (photograph.isNull() && look_.photograph.empty()) return;
  look_.photograph = name.toStdString();
  viewport_->set_photograph(photograph);
  look_changed();
}

QDockWidget* Window::make_history() {
  auto* out = new QDockWidget(tr("History"), this);
  out->setObjectName("history");
  out->setAccessibleName(tr("History"));
  auto* page = new QWidget(out);
  page->setAccessibleName(tr("Steps of undo"));
  auto* column = panel_column(page, 3);
  const auto add = [&](const QString& title, QUndoStack& stack) {
    auto* label = new QLabel(title, page);
    auto* list = new QUndoView(&stack, page);
    list->setEmptyLabel(tr("as it was opened"));
    list->setAccessibleName(title);
    list->setToolTip(tr("A click goes back or forth to that step"));
    label->setBuddy(list);
    column->addWidget(label);
    column->addWidget(list, 1);
  };
  add(tr("Edits"), document_.undo_stack());
  add(tr("Looks"), document_.view_stack());
  out->setWidget(page);
  return out;
}

void Window::ask_preferences() {
  auto* dialog = new PreferencesDialog(preferences_, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    preferences_ = dialog->chosen();
    if (options_.remember) preferences_.remember();
  });
  dialog->open();
}

Project Window::fresh_project() const {
  Project out = new_project();
  if (preferences_.measure) take_measure(out.view);
  return out;
}

ProjectMaterial Window::as_preferred(ProjectMaterial material) const {
  if (!preferences_.model.empty()) material.specular_model = preferences_.model;
  return material;
}

}  // namespace etak::editor
