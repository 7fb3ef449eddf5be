// SPDX-License-Identifier: Apache-2.0
#include <QAbstractSlider>
#include <QAction>
#include <QLabel>
#include <QPlainTextEdit>
#include <QTabWidget>

#include "app/curves/curves_panel.h"
#include "app/document/file_watch.h"
#include "app/document/files.h"
#include "app/document/pictures.h"
#include "app/document/press_id.h"
#include "app/editor/panels/inspector/inspector.h"
#include "app/editor/panels/preview_bar.h"
#include "app/editor/panels/texture_view.h"
#include "app/editor/panels/view_panel.h"
#include "app/editor/window.h"
#include "app/viewport/background.h"
#include "core/atlas/sources/floats.h"
#include "core/base/error.h"
#include "core/image/load.h"
#include "core/project/project_pictures.h"
#include "core/render/engines.h"
#include "core/render/ground_bounce.h"

namespace etak::editor {
namespace {

struct LoadedEnvironment {
  std::shared_ptr<const Environment> environment;
  std::shared_ptr<const Image> picture;  // of a file
  QString error;
};

constexpr unsigned prefilter_threads = 2;

// The environment of the lights, made by a worker.
//   picture     the file's picture, where it has been read; null: a file is read
//   prefilter   quick for the environment that is shown first, full for the one that stays
LoadedEnvironment load(const LightSetup& lights, std::shared_ptr<const Image> picture,
                       Environment::Prefilter prefilter) {
  LoadedEnvironment out;
  const std::string& name = lights.environment;
  const double scale = lights.environment_scale;
  const bool quick = prefilter == Environment::Prefilter::quick;
  const auto work = [&] {
    if (find_studio(name) != nullptr) {
      out.environment = quick ? quick_studio_environment(name, scale, prefilter_threads)
                              : studio_environment(name, scale, prefilter_threads);
    } else {
      out.picture = picture ? std::move(picture)
                            : std::make_shared<const Image>(fractions(load_picture(name, picture_door())));
      out.environment =
          std::make_shared<const Environment>(*out.picture, scale, name, prefilter_threads, prefilter);
    }
    out.environment = with_ground(lights, std::move(out.environment), prefilter_threads, prefilter);
    // Samples for refined pictures are made here, so that the thread that draws does not wait for them.
    if (!quick && out.environment)
      for (const bool bright_apart : {false, true})
        (void)out.environment->samples(bright_apart, prefilter_threads);
  };
  out.error = failure_of(work, QObject::tr("not enough memory for the environment"));
  return out;
}

QString told_of(const SurfaceInBlocks& made) {
  const SurfaceTextures::Quantities& has = made.textures->has;
  QStringList changes;
  const auto add = [&](bool there, const QString& text, double change) {
    if (there) changes << text.arg(change, 0, 'g', 3);
  };
  std::size_t bytes = 0, texels = 0;
  bool met = true, smaller_met = true;  // the budget
  for (const BlockLevel& each : made.levels) {
    bytes += each.bytes;
    texels += each.texels;
    const BlockMaterial& change = each.materials[0];
    (each.level > 0 ? smaller_met : met) &= change.met;
    if (each.level > 0) continue;
    const bool body = each.texture == Texture::diffuse_alpha;
    add(body ? has.diffuse : has.f0, body ? QObject::tr("diffuse \u0394E %1") : QObject::tr("F0 \u0394E %1"),
        change.colour_p99);
    add(body ? has.opacity : has.gloss, body ? QObject::tr("alpha %1 %") : QObject::tr("gloss %1 %"),
        change.fourth_p99);
  }
  const auto size = [](std::size_t of) { return QLocale::c().formattedDataSize(static_cast<qint64>(of)); };
  return (!met           ? QObject::tr("BC7 over its budget: %1; %2 of %3")
          : !smaller_met ? QObject::tr("BC7: %1, small levels over its budget; %2 of %3")
                         : QObject::tr("BC7: %1; %2 of %3"))
      .arg(changes.join(QLatin1String(", ")), size(bytes), size(4 * texels));
}

QString preview_told(const QString& name) {
  return QObject::tr("%1 of the library: Return adds it to the project, Esc ends the preview").arg(name);
}

}  // namespace

void Window::connect_viewport() {
  // The timer draws the picture once for all changes of one turn of the event loop.
  refresh_timer_.setSingleShot(true);
  refresh_timer_.setInterval(0);
  connect(&refresh_timer_, &QTimer::timeout, this, &Window::refresh);
  connect_comparison();
  const auto soon = [this] { refresh_timer_.start(); };
  const auto in_hand = [this] {
    end_preview();
    refresh_timer_.start();
  };
  viewport_->set_drop_filter([this](const QStringList& files) { return can_take(files); });
  preview_bar_ = new PreviewBar(viewport_);
  connect(preview_bar_, &PreviewBar::add_asked, this, [this] { use_library_material(previewed_); });
  connect(preview_bar_, &PreviewBar::end_asked, this, &Window::end_preview);
  connect(&document_, &Document::material_changed, this, in_hand);
  connect(&document_, &Document::current_changed, this, in_hand);
  connect(&document_, &Document::replaced, this, in_hand);
  connect(&document_, &Document::spectra_changed, this, soon);
  connect(&document_, &Document::view_changed, this, soon);
  connect(&document_, &Document::view_changed, this, &Window::drop_old_patch);
  connect(&document_, &Document::replaced, this, &Window::drop_old_patch);
  connect(&document_, &Document::current_changed, view_panel_, &ViewPanel::show_look);
  connect(texture_view_, &TextureView::textures_changed, this, &Window::look_changed);
  connect(texture_view_, &TextureView::reading, this,
          [this](const QString& what) { pictures_->setText(what); });
  connect(new FileWatch(document_, this), &FileWatch::changed, this, [this](const QStringList& materials) {
    texture_view_->read_again();
    validator_->check(materials);
    tell(tr("pictures of %1 have changed").arg(materials.join(QLatin1String(", "))));
  });
  connect(view_panel_, &ViewPanel::look_changed, this, [this, soon] {
    show_switches();
    soon();
  });

  connect(viewport_, &Viewport::state_edited, this, [this](const ViewState& state, int press_id) {
    look_.camera = state.camera;
    look_.separator = state.separator;
    if (document_.project().view.compare.on) difference_timer_.start();
    document_.change_view(tr("light in the viewport"), press_id, [&](ProjectView& view) {
      LightSetup lights = state.lights;
      lights.environment = view.lights.environment;
      lights.environment_scale = view.lights.environment_scale;
      view.lights = lights;
      view.environment_turn_deg = state.environment_turn_deg;
    });
  });
  connect(viewport_, &Viewport::frame_drawn, this, [this] {
    if (!seen_frame_) {
      seen_frame_ = true;
      emit first_frame();
    }
    backend_->setText(viewport_->uses_gl() ? tr("OpenGL") : tr("CPU renderer"));
    backend_->setToolTip(viewport_->uses_gl() ? viewport_->gl_name() : viewport_->fallback_reason());
    show_shader();
  });
  connect(viewport_, &Viewport::hovered, this, &Window::show_patch);
  connect(viewport_, &Viewport::hover_ended, this, [this] { patch_->clear(); });
  connect(viewport_, &Viewport::environment_dropped, this, &Window::set_environment);
  connect(viewport_, &Viewport::textures_dropped, this, &Window::take_files);
  connect(viewport_, &Viewport::material_dropped, this, &Window::use_library_material);
  connect(tabs_, &QTabWidget::currentChanged, this, [this] {
    show_shader();
    show_curves();
  });
}

void Window::connect_comparison() {
  difference_timer_.setSingleShot(true);
  difference_timer_.setInterval(150);
  connect(&difference_timer_, &QTimer::timeout, this, &Window::show_difference);
  connect(inspector_tabs_, &QTabWidget::currentChanged, &difference_timer_, qOverload<>(&QTimer::start));
  connect(view_panel_, &ViewPanel::mesh_asked, this, &Window::choose_mesh);
  connect(view_panel_, &ViewPanel::photograph_asked, this, &Window::choose_photograph);
  connect(view_panel_, &ViewPanel::photograph_ended, this, [this] { show_photograph({}, {}); });
  connect(view_panel_, &ViewPanel::pin_asked, this, [this] {
    if (document_.material() == nullptr) return;
    show_photograph({}, {});
    document_.change_view(tr("pin as B"), next_press_id(), [this](ProjectView& view) {
      view.compare.pinned = *document_.material();
      view.compare.on = true;
    });
  });
}

void Window::preview(const QString& id) {
  const auto record = document_.library()->find(id.toStdString());
  if (!record) return;
  const QString failure =
      failure_of([&] { look_.preview = with_measured(material_of(*record), *document_.library()); });
  if (!failure.isEmpty()) {
    end_preview();
    return tell(failure);
  }
  previewed_ = id;
  const QString name = QString::fromStdString(record->name);
  tell(preview_told(name));
  preview_bar_->show_name(name);
  inspector_->show_preview(look_.preview);
  end_preview_->setEnabled(true);
  refresh_timer_.start();
}

void Window::end_preview() {
  if (!look_.preview) return;
  untell(preview_told(QString::fromStdString(look_.preview->name)));
  look_.preview.reset();
  preview_bar_->hide();
  inspector_->show_preview({});
  end_preview_->setEnabled(false);
  refresh_timer_.start();
}

void Window::look_changed() {
  view_panel_->show_look();
  show_switches();
  refresh_timer_.start();
}

void Window::refresh() {
  load_environment();
  load_mesh();
  // A mesh is there soon: rather the last picture until then than one of the sphere.
  if (mesh_coming_) return;
  // A studio is there soon: rather the last picture until then than one in the dark.
  if (environment_coming_ && !environment_ &&
      find_studio(document_.project().view.lights.environment) != nullptr)
    return;
  const auto in_blocks = textures_in_blocks();
  // A textured material is not drawn without its textures: the last picture stays until they are read.
  if (!texture_view_->is_waiting() || !look_.textured || look_.preview)
    viewport_->set_state(view_state_of(document_, look_, environment_, texture_view_->textures(), in_blocks),
                         qobject_cast<const QAbstractSlider*>(focusWidget()));
  // While the user drags, the processors draw pictures.
  if (viewport_->is_hurried())
    difference_timer_.start();
  else
    show_difference();
  show_curves();
}

std::shared_ptr<const SurfaceTextures> Window::textures_in_blocks() {
  const auto& exact = texture_view_->textures();
  const bool wanted = look_.in_blocks && look_.textured && !look_.preview && exact && exact->has.values();
  blocks_->setVisible(wanted);
  if (!wanted || exact == compressed_) return wanted ? in_blocks_ : nullptr;
  compressor_.clear();
  compressed_ = exact;
  in_blocks_.reset();
  blocks_coming_ = true;
  blocks_->setText(tr("compressing the textures\u2026"));
  in_background(
      compressor_, this,
      [exact, m = *document_.material()] {
        let_others_go_first();
        std::pair<SurfaceInBlocks, QString> out;
        out.second = failure_of([&] { out.first = surface_in_blocks(*exact, m); },
                                tr("not enough memory for textures in blocks"));
        if (out.second.isEmpty()) out.second = told_of(out.first);
        return out;
      },
      [this, exact](const std::pair<SurfaceInBlocks, QString>& made) {
        if (exact != compressed_) return;
        blocks_coming_ = false;
        in_blocks_ = made.first.textures;
        blocks_->setText(made.second);
        refresh_timer_.start();
      });
  return nullptr;
}

// Of several requests in a row, the last one counts.
void Window::show_difference() {
  comparer_.clear();
  ++comparison_;
  comparing_ = 0;
  const ProjectView& view = document_.project().view;
  if (const Engine* engine = find_engine(look_.engine); engine != nullptr) {
    Look own = look_;
    own.engine.clear();
    ViewState state = view_state_of(document_, own, environment_, texture_view_->textures());
    state.split = false;
    state.tone = engine->tone;
    if (state.shape == ViewShape::wedge) state.shape = ViewShape::sphere;
    constexpr int side = 160;
    compare(
        [engine, state] {
          const Scene scene = view_tiles(state, side, side).front().scene;
          return engine_difference(*engine, scene, state.environment.get(), 1);
        },
        [this](const DifferencePicture* found) { view_panel_->show_difference(found); });
  } else {
    view_panel_->show_difference(nullptr);
  }
  constexpr int width = 240;
  if (!view.compare.on || view.wedge.on)
    view_panel_->show_sides(nullptr);
  else if (inspector_tabs_->currentWidget() == view_panel_)
    compare(viewport_->difference_work(width),
            [this](const DifferencePicture* found) { view_panel_->show_sides(found); });
}

void Window::compare(const std::function<DifferencePicture()>& work,
                     const std::function<void(const DifferencePicture*)>& show) {
  ++comparing_;
  in_background(
      comparer_, this,
      [work] {
        DifferencePicture out;
        (void)failure_of([&] { out = work(); });
        return out;
      },
      [this, number = comparison_, show](const DifferencePicture& difference) {
        if (number != comparison_) return;
        --comparing_;
        show(difference.map.width > 0 ? &difference : nullptr);
      });
}

void Window::set_environment(const QString& path) {
  document_.change_view(tr("environment"), next_press_id(),
                        [&](ProjectView& view) { choose_environment(view.lights, path.toStdString()); });
}

void Window::load_environment() {
  const LightSetup& lights = document_.project().view.lights;
  // All lights light a ground, which is a part of the environment then.
  const std::string key = lights.environment.empty() ? ""
                          : lights.ground
                              ? format_lights(lights)
                              : lights.environment + '|' + std::to_string(lights.environment_scale);
  if (key == environment_key_) return;
  environment_key_ = key;
  show_environment_work(false);
  auto known =
      lights.ground ? nullptr : known_studio_environment(lights.environment, lights.environment_scale);
  if (key.empty() || known) {
    environment_ = std::move(known);
    return;
  }
  // The old environment stays until the new one is loaded. Of several requests in a row, the last one counts.
  heavy_.clear();
  show_environment_work(true);
  const auto show = [this](const LoadedEnvironment& loaded) {
    environment_ = loaded.environment;
    if (!loaded.error.isEmpty()) tell(loaded.error);
    refresh_timer_.start();
  };
  using Prefilter = Environment::Prefilter;
  const auto begin = [this, lights](const std::shared_ptr<const Image>& picture, Prefilter prefilter,
                                    auto done) {
    in_background(
        heavy_, this, [=] { return load(lights, picture, prefilter); }, done);
  };
  begin(nullptr, Prefilter::quick, [this, key, show, begin](const LoadedEnvironment& loaded) {
    if (key != environment_key_) return;
    show(loaded);
    if (!loaded.environment) return show_environment_work(false);
    const auto sharpen = [this, key, show, begin, picture = loaded.picture] {
      if (key != environment_key_) return;
      begin(picture, Prefilter::full, [this, key, show](const LoadedEnvironment& sharp) {
        if (key != environment_key_) return;
        show_environment_work(false);
        show(sharp);
      });
    };
    // The picture is drawn first, which needs the processors too.
    constexpr int drawn_ms = 200;
    QTimer::singleShot(drawn_ms, this, sharpen);
  });
}

void Window::show_environment_work(bool on) {
  environment_coming_ = on;
  work_->setText(on ? tr("sharpening the environment\u2026") : QString());
}

void Window::show_curves() {
  const ProjectMaterial* m = look_.preview ? &*look_.preview : document_.material();
  if (tabs_->currentWidget() != curves_) return;
  if (m == nullptr) return curves_->set_surface(tr("no material"), 0, nullptr, {});
  const Model* model = find_model(m->specular_model);
  const QString failure = failure_of([&] {
    SurfaceValues surface = document_.surface_of(*m);
    const FittedModels fitted = fit_models(model, find_model(m->diffuse_model), m->parameters, surface);
    if (!m->measured)
      return curves_->set_surface(QString::fromStdString(m->name), m->gloss, fitted.specular,
                                  fitted.specular_values);
    const FoundF0 found = find_f0(*m->measured, *document_.library());
    curves_->set_material(found.material, found.chosen(), f0_options(*m->measured, *document_.library()),
                          m->gloss, fitted.specular, fitted.specular_values);
  });
  if (!failure.isEmpty()) tell(failure);
}

void Window::show_shader() {
  if (tabs_->currentWidget() != shader_) return;
  const QString first_line = viewport_->uses_gl()
                                 ? tr("// compiled in %1 ms\n").arg(viewport_->compile_ms(), 0, 'f', 1)
                                 : tr("// not compiled: the CPU draws the same formulas\n");
  const QString text = viewport_->shader_text().isEmpty()
                           ? tr("No shader: %1").arg(viewport_->fallback_reason())
                           : first_line + viewport_->shader_text();
  if (shader_->toPlainText() != text) shader_->setPlainText(text);
}

// The difference to side B is told no longer than there is a side B.
void Window::drop_old_patch() {
  const bool compares = document_.project().view.compare.on;
  if (compares == patch_compares_) return;
  patch_compares_ = compares;
  patch_->clear();
  view_panel_->show_patch({});
}

void Window::show_patch(const PatchUnderCursor& patch) {
  const auto codes = [](const std::array<int, 3>& c) {
    return QStringLiteral("%1 %2 %3").arg(c[0]).arg(c[1]).arg(c[2]);
  };
  QString text = codes(patch.code_a);
  if (document_.project().view.compare.on)
    text = tr("A %1   B %2   B - A %3   \u0394E %4")
               .arg(codes(patch.code_a), codes(patch.code_b), codes(patch.difference))
               .arg(patch.delta_e, 0, 'f', 2);
  patch_->setText(text);
  view_panel_->show_patch(text);
}

}  // namespace etak::editor
