// SPDX-License-Identifier: Apache-2.0
#include "app/editor/screenshot.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDialog>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QImage>
#include <QLineEdit>
#include <QPainter>
#include <QPixmap>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QThread>
#include <QTreeView>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>

#include "app/curves/curves_panel.h"
#include "app/document/files.h"
#include "app/document/press_id.h"
#include "app/editor/panels/drop_table.h"
#include "app/editor/panels/findings_panel.h"
#include "app/editor/panels/inspector/inspector.h"
#include "app/editor/panels/inspector/layers_section.h"
#include "app/editor/panels/inspector/texture_section.h"
#include "app/editor/panels/library_panel.h"
#include "app/editor/panels/mask_dialog.h"
#include "app/editor/panels/pack_dialog.h"
#include "app/editor/panels/problem_strip.h"
#include "app/editor/panels/texture_view.h"
#include "app/editor/panels/view_panel.h"
#include "app/editor/shortcuts.h"
#include "app/editor/window.h"
#include "core/project/project_pictures.h"
#include "core/render/mesh/mesh_shape.h"

namespace etak::editor {
namespace {

// Waits until all workers are done and the window has drawn their results.
void settle(Window& window) {
  constexpr int most_ms = 20000, quiet_ms = 250;
  QElapsedTimer all, quiet;
  all.start();
  quiet.start();
  while (all.elapsed() < most_ms) {
    QApplication::processEvents(QEventLoop::AllEvents, 20);
    const auto packing = window.findChildren<PackDialog*>();
    const auto masking = window.findChildren<MaskDialog*>();
    if (window.is_busy() || !window.thumbnails().is_idle() || !window.validator().is_idle() ||
        window.viewport().is_refining() || window.curves().busy() || window.texture_view().is_busy() ||
        std::any_of(packing.begin(), packing.end(),
                    [](const PackDialog* each) { return each->is_running(); }) ||
        std::any_of(masking.begin(), masking.end(), [](const MaskDialog* each) { return each->is_busy(); }))
      quiet.restart();
    if (quiet.elapsed() > quiet_ms) return;
    QThread::msleep(5);
  }
}

void edit_material(Window& window, const std::function<void(ProjectMaterial&)>& change) {
  window.document().change_material(QObject::tr("edit"), next_press_id(), change);
}

void edit_view(Window& window, const std::function<void(ProjectView&)>& change) {
  window.document().change_view(QObject::tr("view"), next_press_id(), change);
}

// A folder for files that a state needs; it is removed when the program ends.
const QTemporaryDir& own_files() {
  static const QTemporaryDir folder;
  return folder;
}

// Writes a picture of square tiles with joints between them; `tile` gives the colour of each tile. Returns
// its path.
QString tiles(const QString& name, const std::function<QColor(int)>& tile, const QColor& joint) {
  constexpr int side = 256, count = 4, step = side / count, gap = 6;
  QImage picture(side, side, QImage::Format_RGB32);
  picture.fill(joint);
  QPainter painter(&picture);
  for (int i = 0; i < count * count; ++i)
    painter.fillRect(i % count * step + gap / 2, i / count * step + gap / 2, step - gap, step - gap, tile(i));
  painter.end();
  const QString file = own_files().filePath(name);
  picture.save(file);
  return file;
}

void put_tiles_on(Window& window) {
  const QString colors = tiles(
      "tiles_diffuse.png", [](int i) { return i * 7 % 3 == 0 ? QColor(170, 74, 52) : QColor(186, 142, 96); },
      QColor(140, 136, 130));
  const QString gloss = tiles(
      "tiles_gloss.png", [](int i) { return QColor(Qt::white).darker(130 + i * 5 % 7 * 12); },
      QColor(60, 60, 60));
  window.take_files({colors, gloss});
  settle(window);
  if (auto* table = window.findChild<DropTable*>()) table->accept();
  settle(window);
}

// Drops a set of metal-rough pictures, whose table stays open.
void drop_set_on(Window& window) {
  const auto grey = [](int) { return QColor(120, 90, 200); };
  QStringList files;
  for (const char* each : {"Crate_BaseColor.png", "Crate_ORM.png", "Crate_Normal.png", "Crate_Height.png"})
    files << tiles(QLatin1String(each), grey, QColor(60, 60, 60));
  window.take_files(files);
}

// The dialog of materials by mask, with worn paint on iron.
void mask_on(Window& window) {
  window.use_library_material("iron");
  edit_material(window, [](ProjectMaterial& m) { m.gloss = 0.7; });
  ProjectMaterial paint;
  paint.name = "Red paint";
  paint.diffuse = {0.3, 0.02, 0.015};
  paint.gloss = 0.6;
  paint.alpha_mode = AlphaMode::opaque;
  window.document().add({paint}, {}, QObject::tr("paint"));
  QImage mask(256, 256, QImage::Format_Grayscale8);
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x)
      mask.scanLine(y)[x] = static_cast<uchar>(
          std::clamp(128 + 90 * std::sin(x * 0.11) * std::cos(y * 0.07 + x * 0.02) + 70 * std::sin(y * 0.19),
                     0.0, 255.0));
  const QString file = own_files().filePath("wear.png");
  mask.save(file);
  auto* dialog =
      new MaskDialog(window.document().project(), window.document().library(),
                     {QStringLiteral("Red paint"), QStringLiteral("Iron")}, own_files().path(), &window);
  dialog->show();
  dialog->take_mask(file);
}

// Makes the current material one that has findings, and selects the first of them.
void show_findings(Window& window) {
  edit_material(window, [](ProjectMaterial& m) {
    m.measured.reset();
    m.specular = {0.3, 0.3, 0.3};
    m.diffuse = {0.98, 0.98, 0.98};
  });
  settle(window);
  window.tabs().setCurrentWidget(&window.findings());
  auto* table = window.findings().findChild<QTreeView*>();
  table->setCurrentIndex(table->model()->index(0, 0));
}

// The states that differ in how a material is lit and what is behind it. Those of an environment have its name.
void show_light_state(Window& window, const QString& state) {
  const auto is = [&](const char* name) { return state == QLatin1String(name); };
  if (const std::string name = state.toStdString(); find_studio(name) != nullptr) {
    edit_view(window, [&](ProjectView& view) { choose_environment(view.lights, name); });
    window.inspector_tabs().setCurrentIndex(1);
  }
  if (is("glass")) window.use_library_material("fused_silica");
  if (is("water")) window.use_library_material("water");
  const bool behind = is("glass") || is("backdrop"), ground = is("water") || is("ground") || is("backdrop");
  if (!behind && !ground && !is("exposure")) return;
  edit_view(window, [&](ProjectView& view) {
    view.backdrop.environment = behind;
    view.backdrop.ground = ground;
    if (is("exposure")) view.tone = Tone::false_color;
  });
  window.inspector_tabs().setCurrentIndex(2);
}

// Copper beside a picture of the material that was there before.
void compare_with_photograph(Window& window) {
  const QString file = own_files().filePath("photograph.png");
  settle(window);
  window.viewport().grab_picture(true).save(file);
  window.take_photograph(file);
  window.use_library_material("copper");
  window.inspector_tabs().setCurrentIndex(2);
  settle(window);
  window.view_panel().verticalScrollBar()->setValue(window.view_panel().verticalScrollBar()->maximum());
}

// Brings the window into a state by the function of that name. A state that has no function is that of a new
// window.
void show_state(Window& window, const QString& state) {
  const auto curve = [&](int tab) {
    window.tabs().setCurrentWidget(&window.curves());
    window.curves().findChild<QTabWidget*>()->setCurrentIndex(tab);
  };
  const std::map<QString, std::function<void()>> states{
      {"reflectance", [&] { curve(1); }},
      {"fresnel", [&] { curve(2); }},
      {"lobe", [&] { curve(3); }},
      {"shader", [&] { window.tabs().setCurrentWidget(window.tabs().findChild<QPlainTextEdit*>()); }},
      {"textures",
       [&] {
         if (const ProjectMaterial* m = window.document().material(); m == nullptr || !has_textures(*m)) {
           window.use_library_material("chalk");
           put_tiles_on(window);
         }
         window.tabs().setCurrentWidget(&window.texture_view());
       }},
      {"blocks",
       [&] {
         show_state(window, "textures");
         window.look().in_blocks = true;
         window.inspector_tabs().setCurrentIndex(2);
       }},
      {"light", [&] { window.inspector_tabs().setCurrentIndex(1); }},
      {"view", [&] { window.inspector_tabs().setCurrentIndex(2); }},
      {"compare",
       [&] {
         emit window.view_panel().pin_asked();
         window.use_library_material("copper");
         window.inspector_tabs().setCurrentIndex(2);
       }},
      {"photograph", [&] { compare_with_photograph(window); }},
      {"engine",
       [&] {
         window.look().engine = "unity-urp";
         window.look_changed();
         window.inspector_tabs().setCurrentIndex(2);
       }},
      {"alone", [&] { window.show_viewport_only(true); }},
      {"wedge",
       [&] {
         edit_view(window, [](ProjectView& view) { view.wedge.on = true; });
         window.inspector_tabs().setCurrentIndex(2);
       }},
      {"mesh", [&] { edit_view(window, [](ProjectView& v) { v.mesh = shader_ball_name; }); }},
      {"quad", [&] { edit_view(window, [](ProjectView& v) { v.shape = Shape::quad; }); }},
      {"zone",
       [&] {
         window.look().zone_overlay = true;
         window.use_library_material("silicon");
       }},
      {"energy", [&] { window.look().energy_overlay = true; }},
      {"angles", [&] { window.look().angle_overlay = true; }},
      {"gamut",
       [&] {
         edit_material(window, [](ProjectMaterial& m) {
           m.measured.reset();
           m.specular = {1.2, 0.7, -0.05};
         });
       }},
      {"library",
       [&] {
         for (QAbstractButton* chip : window.library_panel().findChildren<QAbstractButton*>())
           if (chip->text() == "gem") chip->click();
       }},
      {"layers",
       [&] {
         window.use_library_material("anodised_titanium_50nm");
         window.inspector().ensureWidgetVisible(window.inspector().findChild<LayersSection*>());
       }},
      {"drop", [&] { drop_set_on(window); }},
      {"mask", [&] { mask_on(window); }},
      {"near", [&] { window.library_panel().search().setText("car paint"); }},
      {"preview", [&] { emit window.library_panel().looked_at("copper"); }},
      {"findings", [&] { show_findings(window); }},
      {"pack",
       [&] {
         window.use_library_material("copper");
         window.use_library_material("pmma");
         window.pack_to(own_files().filePath(QStringLiteral("atlas-%1").arg(next_press_id())));
       }},
      {"picture",
       [&] {
         for (QAction* each : window.findChildren<QAction*>())
           if (each->text() == "Save pic&ture\u2026") each->trigger();
       }},
      {"keys", [&] { (new ShortcutsDialog(window, &window))->show(); }},
      {"problem", [&] { window.open("a project that is gone.json"); }},
  };
  if (const auto found = states.find(state); found != states.end()) found->second();
  show_light_state(window, state);
}

}  // namespace

QString bring_into_state(Window& window, const QString& material, const QString& model,
                         const QString& state) {
  settle(window);
  if (!material.isEmpty()) {
    if (QFileInfo::exists(material) || is_pipe(material)) {
      bool well = false;
      QObject scope;  // ends the connection with this block
      QObject::connect(&window, &Window::opened, &scope, [&well](bool ok) { well = ok; });
      window.open(material);
      settle(window);
      if (!well) {
        const QString told = window.problems().text().section('\n', 1);
        return told.isEmpty() ? QObject::tr("%1 could not be opened").arg(material) : told;
      }
    } else if (!window.use_library_material(material)) {
      return QObject::tr("%1 is no file, and no material of the library").arg(material);
    }
  }
  if (!model.isEmpty())
    edit_material(window, [&](ProjectMaterial& m) { m.specular_model = model.toStdString(); });
  show_state(window, state);
  window.look_changed();
  settle(window);
  return {};
}

QPixmap picture_of(Window& window) {
  QPixmap out = window.grab();
  QPainter painter(&out);
  for (QDialog* dialog : window.findChildren<QDialog*>()) {
    if (!dialog->isVisible()) continue;
    const QRect place(
        QPoint((window.width() - dialog->width()) / 2, (window.height() - dialog->height()) / 2),
        dialog->size());
    painter.drawPixmap(place.topLeft(), dialog->grab());
    painter.setPen(window.palette().color(QPalette::Shadow));
    painter.drawRect(place.adjusted(-1, -1, 0, 0));
  }
  return out;
}

int take_screenshot(Window& window, const Options& options) {
  window.resize(options.size);
  window.show();
  // The layout does not let a panel become smaller than its content.
  if (window.size() != options.size) {
    std::fprintf(stderr,
                 "etak-editor: --size: %dx%d is less than the window needs; expected at least %dx%d\n",
                 options.size.width(), options.size.height(), window.minimumSizeHint().width(),
                 window.minimumSizeHint().height());
    return 2;
  }
  const QString problem = bring_into_state(window, options.subjects.value(0), options.model, options.state);
  if (!problem.isEmpty()) {
    std::fprintf(stderr, "etak-editor: %s\n", qPrintable(problem));
    return 2;
  }
  const QString error = save_png(picture_of(window).toImage(), options.screenshot);
  if (!error.isEmpty()) std::fprintf(stderr, "etak-editor: %s\n", qPrintable(error));
  return error.isEmpty() ? 0 : 2;
}

}  // namespace etak::editor
