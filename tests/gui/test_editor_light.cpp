// SPDX-License-Identifier: Apache-2.0
// How a material is shown in the editor: environments, backdrop, exposure, and textures whose numbers change.
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QToolButton>
#include <filesystem>
#include <random>

#include "app/document/look.h"
#include "app/editor/panels/inspector/inspector.h"
#include "app/editor/panels/inspector/texture_section.h"
#include "app/editor/panels/texture_view.h"
#include "app/editor/panels/view_panel.h"
#include "app/fields/color_field.h"
#include "app/fields/number_field.h"
#include "tests/gui/editor_hands.h"
#include "tests/gui/gui_test.h"

using namespace etak;
using namespace etak::editor;

namespace {

constexpr int long_ms = 60000;

const ProjectView& view_of(TestWindow& window) {
  return window->document().project().view;
}

QString picture_of_tiles(TestWindow& window, const QString& name, int side) {
  QImage out(side, side, QImage::Format_RGB32);
  out.fill(QColor(90, 120, 150));
  const QString file = window.file(name);
  out.save(file);
  return file;
}

void set_gloss(TestWindow& window, double gloss) {
  ProjectMaterial next = *window->document().material();
  next.gloss = gloss;
  window->document().edit(window->document().current(), next, QStringLiteral("gloss"), 0);
}

// The gloss of the textured surface that the viewport shows; -1 while it shows none.
double gloss_shown(TestWindow& window) {
  const ViewSide& side = window->viewport().state().a;
  if (!side.textures) return -1;
  return side.textures->has.gloss ? double{side.textures->gloss.at(0, 0)[3]} : double{side.surface.gloss};
}

bool finds(TestWindow& window, const char* rule) {
  const auto& all = window->validator().findings();
  const auto of_material = all.find(window->document().material()->name);
  return of_material != all.end() && std::any_of(of_material->second.begin(), of_material->second.end(),
                                                 [&](const Finding& each) { return each.rule == rule; });
}

}  // namespace

class EditorLight : public QObject {
  Q_OBJECT

 private slots:
  void the_strip_shows_five_environments_and_chooses_one_in_one_step() {
    TestWindow window(true);
    window->show();
    window->inspector_tabs().setCurrentIndex(1);
    ProjectView lit = view_of(window);
    lit.lights = default_lights();
    window->document().edit_view(lit, QStringLiteral("lights of the sources"), 0);
    QVERIFY(view_of(window).lights.hemispheres);
    const LightSetup before = view_of(window).lights;
    std::set<QByteArray> pictures;
    for (const NamedStudio& each : named_studios()) {
      auto* button = named<QToolButton>(*window.window,
                                        QStringLiteral("Environment ") + QString::fromUtf8(each.name.data()));
      QVERIFY(button != nullptr);
      const QImage icon = button->icon().pixmap(button->iconSize()).toImage();
      QVERIFY(!icon.isNull());
      pictures.insert(QByteArray(reinterpret_cast<const char*>(icon.constBits()), icon.sizeInBytes()));
      QTest::mouseClick(button, Qt::LeftButton);
      QCOMPARE(QString::fromStdString(view_of(window).lights.environment),
               QString::fromUtf8(each.name.data()));
      QVERIFY(!view_of(window).lights.hemispheres);
      QVERIFY(button->isChecked());
      QTest::mouseClick(button, Qt::LeftButton);  // the one that is chosen already stays so
      QVERIFY(button->isChecked());
      while (view_of(window).lights != before) window->document().undo_stack().undo();
      QVERIFY(!button->isChecked());
    }
    QCOMPARE(pictures.size(), named_studios().size());
    QVERIFY(window.settle());
  }

  void new_projects_begin_with_look_and_measure_is_one_click_away() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("chalk")));
    show_active(window);
    const ProjectView look = view_of(window);
    QVERIFY((look.backdrop == Backdrop{true, 0.3, true}) && look.tone == Tone::neutral);
    auto* look_button = named<QToolButton>(*window.window, QStringLiteral("Look"));
    auto* measure_button = named<QToolButton>(*window.window, QStringLiteral("Measure"));
    QVERIFY(look_button != nullptr && measure_button != nullptr);
    QVERIFY(look_button->isVisible() && look_button->isChecked() && !measure_button->isChecked());
    const auto shown = [&] {
      return window->viewport().state().backdrop == view_of(window).backdrop && !window->is_busy();
    };
    QVERIFY(QTest::qWaitFor(shown, long_ms));
    // The ball's share that is white, at most: of every pixel of the picture, which has the bright lamps behind it.
    const QImage picture = window->viewport().grab_picture();
    int white = 0, ball = 0;
    const auto is_ball = [&](int x, int y) {
      const auto patch = window->viewport().patch_at(QPointF(x, y) / window->viewport().devicePixelRatioF());
      return patch && patch->on_object;
    };
    for (int y = 0; y < picture.height(); y += 4)
      for (int x = 0; x < picture.width(); x += 4) {
        if (!is_ball(x, y)) continue;
        ++ball;
        const QColor c = picture.pixelColor(x, y);
        white += c.red() == 255 || c.green() == 255 || c.blue() == 255;
      }
    qInfo("%d of %d points of chalk have a channel of 255", white, ball);
    QVERIFY(ball > 500);
    QVERIFY(white < 0.02 * ball);

    QTest::mouseClick(measure_button, Qt::LeftButton);
    QVERIFY(measure_button->isChecked() && !look_button->isChecked());
    QVERIFY(view_of(window) == ProjectView());  // as projects had it that were saved without these settings
    QTest::mouseClick(measure_button, Qt::LeftButton);
    QVERIFY(measure_button->isChecked());
    QTest::mouseClick(look_button, Qt::LeftButton);
    QVERIFY(view_of(window) == look && look_button->isChecked());
    // What a saved project says is kept.
    Project old;
    old.materials = window->document().project().materials;
    const QString file = window.file(QStringLiteral("old.json"));
    write(file, QByteArray::fromStdString(format_project(old, file.toStdString())));
    QSignalSpy opened(window.window.get(), &Window::opened);
    window->open(file);
    if (QMessageBox* box = window->document().is_saved() ? nullptr : open_message(window, 2000))
      if (auto* discard = box->button(QMessageBox::Discard)) discard->click();
    QVERIFY(QTest::qWaitFor([&] { return opened.count() == 1; }, long_ms));
    QVERIFY(view_of(window) == ProjectView() && measure_button->isChecked());
    QVERIFY(window.settle());
  }

  void the_light_tab_begins_with_what_is_used_most() {
    TestWindow window(true);
    show_active(window);
    window->inspector_tabs().setCurrentIndex(1);
    QTest::qWait(50);
    const QWidget& page = *window->inspector_tabs().currentWidget();
    const auto top = [&](const char* field) {
      const auto* found = named<QWidget>(page, QLatin1String(field));
      return found == nullptr ? -1 : found->mapTo(&page, QPoint()).y();
    };
    int before = 0;
    for (const char* field : {"Environment studio", "Environment turn, field", "Environment scale, field",
                              "Exposure of the light, field", "Light in hand", "Two hemispheres on"}) {
      QVERIFY2(top(field) > before, field);
      before = top(field);
    }
    // The hemispheres are folded while they are off.
    auto* upper = named<ColorField>(page, QStringLiteral("Upper hemisphere, colour"));
    QVERIFY(upper != nullptr && !upper->isVisible());
    named<QCheckBox>(page, QStringLiteral("Two hemispheres on"))->click();
    QTRY_VERIFY(upper->isVisible());
    QVERIFY(window.settle());
  }

  void exposure_is_in_stops_and_false_colours_are_a_view() {
    TestWindow window(true);
    auto* exposure = named<NumberField>(*window.window, QStringLiteral("Exposure, field"));
    QVERIFY(exposure != nullptr);
    emit exposure->edited(1, 1);
    QCOMPARE(view_of(window).exposure, 2.0);
    QCOMPARE(exposure->value(), 1.0);
    emit exposure->edited(-2, 2);
    QCOMPARE(view_of(window).exposure, 0.25);
    auto* view = named<QComboBox>(*window.window, QStringLiteral("View of the display"));
    QVERIFY(view != nullptr);
    const int row = view->findText(QStringLiteral("false colours of exposure"));
    QVERIFY(row >= 0);
    view->setCurrentIndex(row);
    emit view->activated(row);
    QVERIFY(view_of(window).tone == Tone::false_color);
    QVERIFY(QTest::qWaitFor([&] { return window->viewport().state().tone == Tone::false_color; }, long_ms));
    QVERIFY(window.settle());
  }

  void the_backdrop_is_the_environment_blurred_a_colour_or_a_ground_and_is_saved() {
    TestWindow window(true);
    auto* behind = named<QComboBox>(*window.window, QStringLiteral("Behind the object"));
    auto* blur = named<NumberField>(*window.window, QStringLiteral("Blur, field"));
    auto* ground = named<QCheckBox>(*window.window, QStringLiteral("ground with contact shadow"));
    QVERIFY(behind != nullptr && blur != nullptr && ground != nullptr);
    QVERIFY(blur->isEnabled() && ground->isChecked());
    behind->setCurrentIndex(0);
    emit behind->activated(0);
    QVERIFY(!blur->isEnabled());
    behind->setCurrentIndex(1);
    emit behind->activated(1);
    emit blur->edited(0.6, 3);
    QVERIFY((view_of(window).backdrop == Backdrop{true, 0.6, true}));
    QVERIFY(blur->isEnabled());
    QVERIFY(QTest::qWaitFor([&] { return window->viewport().state().backdrop == view_of(window).backdrop; },
                            long_ms));
    const Project& project = window->document().project();
    QVERIFY(parse_project(format_project(project, {}), "saved.json").view == project.view);
    for (int i = 0; i < 3; ++i) window->document().view_stack().undo();
    QVERIFY(view_of(window) == new_project().view);
    QVERIFY(window.settle());
  }

  void a_ground_of_the_light_setup_lights_the_object() {
    TestWindow window(true);
    const auto lowest = [&](std::size_t c) {
      const auto& around = window->viewport().state().environment;
      return around == nullptr ? 0.0f : around->map().at(0, around->map().height - 1)[c];
    };
    ProjectView view = view_of(window);
    QVERIFY(!view.lights.environment.empty());
    view.lights.ground = Vec3{0.8, 0.2, 0.2};
    window->document().edit_view(view, QStringLiteral("ground"), next_press_id());
    QVERIFY(QTest::qWaitFor([&] { return lowest(0) > 3 * lowest(1) && lowest(1) > 0; }, long_ms));
    window->document().undo_stack().undo();
    QVERIFY(QTest::qWaitFor([&] { return lowest(0) < 2 * lowest(1); }, long_ms));
    QVERIFY(window.settle());
  }

  void numbers_of_a_textured_material_change_without_its_files() {
    TestWindow window(true);
    window->show();
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    const QString file = picture_of_tiles(window, QStringLiteral("wood_diffuse.png"), 64);
    put_texture(window, Channel::diffuse, file);
    set_gloss(window, 0.4);
    QVERIFY(QTest::qWaitFor([&] { return std::abs(gloss_shown(window) - 0.4) < 0.01; }, long_ms));
    QVERIFY(window.settle());
    QVERIFY(!finds(window, "ETK001"));
    // The file is of the same size and age, but no picture any more: whoever reads it finds out.
    const std::filesystem::path path = file.toStdString();
    const auto age = std::filesystem::last_write_time(path);
    write(file, QByteArray(static_cast<qsizetype>(std::filesystem::file_size(path)), 'x'));
    std::filesystem::last_write_time(path, age);
    // The textures stay the same object, so that nothing of them is brought to the GPU again.
    const auto before = window->viewport().state().a.textures;
    set_gloss(window, 1);
    QVERIFY(QTest::qWaitFor([&] { return gloss_shown(window) == 1; }, long_ms));
    QVERIFY(window.settle());
    QVERIFY(window->viewport().state().a.textures == before);
    QVERIFY(window->texture_view().summary().startsWith(QLatin1String("64 x 64")));
    // The rules were asked about the number as it is now, and about the texels as they were read.
    QVERIFY(!finds(window, "ETK001"));
    // A file that was written anew is read.
    std::filesystem::last_write_time(path, age + std::chrono::seconds(10));
    set_gloss(window, 0.5);
    QVERIFY(QTest::qWaitFor(
        [&] { return !window->texture_view().summary().startsWith(QLatin1String("64 x 64")); }, long_ms));
    QVERIFY(window.settle());
    QVERIFY(finds(window, "ETK001"));
  }

  void a_textured_material_is_never_drawn_without_its_textures_and_read_once() {
    TestWindow window(true);
    show_active(window);
    std::vector<std::string> names;
    std::vector<QString> files;
    for (const char* name : {"wood_diffuse.png", "stone_diffuse.png"}) {
      files.push_back(picture_of_tiles(window, QLatin1String(name), 64));
      QVERIFY(window->use_library_material(QStringLiteral("pmma")));
      QVERIFY(window.settle(long_ms));
      // What is drawn of the dropped set is the old frame, then the textures.
      const auto bare = [&] { return window->viewport().state().a.textures == nullptr; };
      QVERIFY(bare());
      auto* work = named<QLabel>(*window.window, QStringLiteral("Work on pictures"));
      put_texture(window, Channel::diffuse, files.back());
      QCOMPARE(work->text(), QString::fromUtf8("reading 1 picture\u2026"));
      QVERIFY(QTest::qWaitFor([&] { return !bare(); }, long_ms));
      QVERIFY(work->text().isEmpty());
      names.push_back(window->document().material()->name);
    }
    QVERIFY(names[0] != names[1]);
    QVERIFY(window.settle(long_ms));
    // Every frame from now on has the textures of the material that it names.
    std::map<std::string, std::shared_ptr<const SurfaceTextures>> seen;
    int frames = 0;
    QStringList wrong;
    connect(&window->viewport(), &Viewport::frame_drawn, &window->viewport(), [&] {
      const ViewSide& side = window->viewport().state().a;
      const std::string name = side.label.substr(0, side.label.find(','));
      ++frames;
      if (!side.textures) wrong << QString::fromStdString(side.label) + QStringLiteral(" without textures");
      auto& known = seen[name];
      if (known && known != side.textures)
        wrong << QString::fromStdString(side.label) + QStringLiteral(" read anew");
      known = side.textures;
    });
    for (int visit = 0; visit < 6; ++visit) {
      const int before = frames;
      QTest::keyClick(window.window.get(), Qt::Key_Right);
      QVERIFY(QTest::qWaitFor([&] { return frames > before && !window->texture_view().is_busy(); }, long_ms));
      QVERIFY(window.settle(long_ms));
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1String("; "))));
    QCOMPARE(seen.size(), std::size_t{2});
    QVERIFY(seen[names[0]] != seen[names[1]]);
    // Pictures that cannot be read hold no frame back.
    put_texture(window, Channel::diffuse, window.file(QStringLiteral("gone.png")));
    QVERIFY(QTest::qWaitFor([&] { return window->viewport().state().a.textures == nullptr; }, long_ms));
    QVERIFY(!window->texture_view().is_waiting());
  }

  void textures_as_bc7_change_noise_and_no_flat_picture_and_are_gone_at_once() {
    TestWindow window(true);
    show_active(window);
    QVERIFY(window->use_library_material(QStringLiteral("chalk")));
    QVERIFY(window.settle(long_ms));
    auto* box = named<QCheckBox>(window->view_panel(), QStringLiteral("textures as BC7"));
    auto* told = named<QLabel>(*window.window, QStringLiteral("What BC7 changes"));
    QAction* action = action_named(*window.window, QStringLiteral("Textures as BC7"));
    const auto press = [&] { QTest::keyClick(window.window.get(), Qt::Key_5, Qt::ControlModifier); };
    press();
    QVERIFY(!window->look().in_blocks && !box->isEnabled() && !action->isEnabled());
    for (const QString& tip : {box->toolTip(), action->toolTip()})
      QVERIFY2(tip.contains(QLatin1String("has no picture")), qPrintable(tip));
    QImage noise(128, 128, QImage::Format_RGB32);
    std::mt19937 random(5);
    for (int y = 0; y < noise.height(); ++y)
      for (int x = 0; x < noise.width(); ++x)
        noise.setPixel(x, y, qRgb(random() % 256, random() % 256, random() % 256));
    noise.save(window.file(QStringLiteral("noise.png")));
    picture_of_tiles(window, QStringLiteral("flat.png"), 128);
    for (const QString& name : {QStringLiteral("flat.png"), QStringLiteral("noise.png")}) {
      put_texture(window, Channel::diffuse, window.file(name));
      const auto shown = [&] { return window->viewport().state().a.textures; };
      const auto before = shown();
      QVERIFY(QTest::qWaitFor([&] { return shown() != before; }, long_ms));
      QVERIFY(window.settle(long_ms));
      QVERIFY(box->isEnabled() && action->isEnabled() && !box->isChecked());
      QVERIFY2(!action->toolTip().contains(QLatin1String("has no picture")), qPrintable(action->toolTip()));
      const auto exact = shown();
      const QImage picture = window->viewport().grab_picture();
      press();
      QVERIFY(QTest::qWaitFor([&] { return shown() != exact; }, long_ms));
      QVERIFY(window.settle(long_ms));
      const bool flat = name.startsWith(QLatin1String("flat"));
      QVERIFY2(told->text().startsWith(flat ? QStringLiteral("BC7: diffuse \u0394E 0; ")
                                            : QStringLiteral("BC7 over its budget: diffuse \u0394E ")),
               qPrintable(told->text()));
      QCOMPARE(window->viewport().grab_picture() == picture, flat);
      QVERIFY(window->viewport().state().b.textures == exact);
      // Turned off and on, nothing is waited for.
      const auto held = shown();
      const auto turn = [&] {
        box->click();
        QTest::qWait(1);
        return shown();
      };
      QVERIFY(turn() == exact);
      QVERIFY(told->isHidden());
      QCOMPARE(window->viewport().grab_picture(), picture);
      QVERIFY(turn() == held);
      QVERIFY(turn() == exact);
      QVERIFY(window.settle(long_ms));
    }
  }

  void a_large_environment_is_shown_soon_and_sharper_later_with_a_sign_of_work() {
    TestWindow window(true);
    window->show();
    QVERIFY(window.settle(long_ms));
    auto* work = named<QLabel>(*window.window, QStringLiteral("Work on the environment"));
    QVERIFY(work != nullptr);
    QVERIFY(work->text().isEmpty());
    const QString file = window.file(QStringLiteral("room.hdr"));
    write(file, radiance_room(1024, 512, 700));
    const auto seen = [&] { return window->viewport().state().environment; };
    const auto before = seen();
    QElapsedTimer timer;
    timer.start();
    QVERIFY(drop(*window.window, {file}));
    QVERIFY(QTest::qWaitFor([&] { return !work->text().isEmpty(); }, long_ms));
    QVERIFY(QTest::qWaitFor([&] { return seen() != before; }, long_ms));
    const qint64 first_ms = timer.elapsed();
    const auto first = seen();
    QVERIFY(first->levels().front().map.width < 256);
    QVERIFY(!work->text().isEmpty());
    QVERIFY(QTest::qWaitFor([&] { return seen() != first; }, long_ms));
    QCOMPARE(seen()->levels().front().map.width, 256);
    QVERIFY(work->text().isEmpty());
    qInfo("first picture after %lld ms, the sharp one after %lld ms", first_ms, timer.elapsed());
    QVERIFY(window.settle());
  }

  void imported_metals_are_metals() {
    TestWindow window(true);
    const QString file = window.file(QStringLiteral("Au/nk/Yakubovsky-25nm.yml"));
    QVERIFY(QDir().mkpath(QFileInfo(file).path()));
    write(
        file,
        "REFERENCES: |\n    D. I. Yakubovsky. Optics of films. Opt. Express 25, 1 (2017)\nDATA:\n"
        "  - type: tabulated nk\n    data: |\n        0.3 1.5 1.9\n        0.5 0.9 1.9\n        0.55 0.4 2.4\n"
        "        0.7 0.2 4.1\n        0.9 0.2 5.9\n");
    QVERIFY(drop(*window.window, {file}));
    QVERIFY(QTest::qWaitFor([&] { return window->document().material() != nullptr; }, long_ms));
    const ProjectMaterial& material = *window->document().material();
    QCOMPARE(QString::fromStdString(material.name), QStringLiteral("Au, Yakubovsky 2017, 25 nm"));
    QVERIFY((material.diffuse == LinearRgb{0, 0, 0}));
    QVERIFY(material.specular.r > 0.5);
    QVERIFY(window.settle());
  }
};

ETAK_GUI_TEST(EditorLight, "editor_light")
#include "test_editor_light.moc"
