// SPDX-License-Identifier: Apache-2.0
// The OpenGL viewport shows the picture of core: frame buffers are compared with core's CPU renderer.
#include <QtTest>

#include "app/viewport/display.h"
#include "app/viewport/gl_view.h"
#include "tests/gui/gui_test.h"
#include "tests/gui/view_states.h"

using namespace etak;
using namespace etak::test;

class ViewportGl : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<Viewport> viewport;

  bool drawn() {
    return QTest::qWaitFor([this] { return !viewport->is_drawing(); }, patience_ms);
  }

  // The picture that the window shows, grabbed from the frame buffer by Qt.
  QImage on_screen() { return drawn() ? viewport->findChild<GlView*>()->grabFramebuffer() : QImage(); }

  std::shared_ptr<const Environment> environment =
      std::make_shared<const Environment>(environment_picture(*find_studio("studio"), 128), 1, "studio", 2);

  static std::shared_ptr<const SurfaceTextures> some_textures() {
    Image body(8, 8, 4), gloss(8, 4, 4);
    for (std::size_t i = 0; i < body.values.size(); ++i) body.values[i] = static_cast<float>(i % 7) / 8;
    for (std::size_t i = 0; i < gloss.values.size(); ++i)
      gloss.values[i] = 0.2F + static_cast<float>(i % 5) / 8;
    const Image emission(3, 5, 3, 0.3F);
    return surface_textures({&body, &gloss, &emission});
  }

  //   beside   what lies beside the object is compared, too
  void check(const ViewState& state, const QByteArray& what, const ViewDisplay& display = {},
             bool beside = false) {
    viewport->set_state(state);
    compare(state, on_screen(), what, display, beside);
    if (!has_refined(state)) return;
    QVERIFY(QTest::qWaitFor([this] { return !viewport->is_refining(); }, patience_ms));
    ViewState refined = state;
    refined.refined = true;
    compare(refined, on_screen(), what + ", refined", display, beside);
  }

  static void compare(const ViewState& state, const QImage& picture, const QByteArray& what,
                      const ViewDisplay& display, bool beside) {
    Image linear = draw_view(state, picture.width(), picture.height(), 2);
    for (std::size_t i = 3; beside && i < linear.values.size(); i += 4)
      if (linear.values[i] == 0) linear.values[i] = 1;
    const QImage expected = shown(linear, display, 2);
    const Apart found = apart(picture, expected, linear);
    QVERIFY2(found.pixels > 1000, what + " covers nothing");
    QVERIFY2(found.codes <= 2, what + ": " + QByteArray::number(found.codes) + " codes at column " +
                                   QByteArray::number(found.x) + ", row " + QByteArray::number(found.y));
    QVERIFY2(found.delta_e <= 0.3, what + ": mean Delta E " + QByteArray::number(found.delta_e));
  }

 private slots:
  void initTestCase() {
    viewport = std::make_unique<Viewport>();
    viewport->resize(360, 300);
    viewport->show();
    QVERIFY(QTest::qWaitForWindowExposed(viewport.get()));
    if (!viewport->uses_gl()) QSKIP(qPrintable("skipped: no OpenGL here: " + viewport->fallback_reason()));
    qInfo("%s", qPrintable(viewport->gl_name()));
  }

  // Tests of many states draw them smaller, because most of their time goes into pixels.
  void init() {
    const QByteArray test = QTest::currentTestFunction();
    const bool many = test == "every_model" || test == "backdrop_beside_and_behind_the_object";
    viewport->resize(many ? QSize(240, 200) : QSize(360, 300));
  }

  void every_model_data() {
    QTest::addColumn<int>("index");
    for (std::size_t i = 0; i < models().size(); ++i)
      QTest::newRow(std::string(models()[i].id).c_str()) << static_cast<int>(i);
  }
  void every_model() {
    QFETCH(int, index);
    const Model& model = models()[static_cast<std::size_t>(index)];
    const QByteArray id(std::string(model.id).c_str());
    check(state_with(model), id);
    ViewState state = state_with(model);
    state.lights.hemispheres = Hemispheres{};
    state.environment = environment;
    state.environment_turn_deg = 40;
    check(state, id + " under two hemispheres in an environment");
    state.a.textures = some_textures();
    check(state, id + " with textures under two hemispheres in an environment");
  }

  void a_perspective_camera_is_that_of_the_cpu() {
    ViewState state = state_with(*find_model("ggx-schlick"));
    state.environment = environment;
    state.backdrop = {true, 0.3, true};
    state.perspective = true;
    state.camera = {20, 15, 0.1, 0, 1.2};
    check(state, "perspective");
    state.shape = ViewShape::quad;
    state.backdrop = {};
    check(state, "perspective quad");
    state.shape = ViewShape::sphere;
    state.split = true;
    check(state, "perspective split");
  }

  void textures_that_hold_a_part_of_the_quantities() {
    ViewState state = state_with(*find_model("ggx-schlick"));
    state.environment = environment;
    state.a.surface.opacity = 0.8;
    const SurfaceTextures all = *some_textures();
    // Every combination, down to textures that hold nothing.
    for (int bits = 0; bits < 16; ++bits) {
      SurfaceTextures part = all;
      state.a.surface.emission = {0.2, 0, 0.1 * (bits % 3)};
      part.has = {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0,
                  (bits & 8) != 0, bits % 3 != 1,   bits % 5 < 3};
      state.a.textures = std::make_shared<const SurfaceTextures>(part);
      check(state, "textures with the quantities " + QByteArray::number(bits));
    }
  }

  void microfacet_of_three_terms() {
    const Model* model = find_model("microfacet:ggx,schlick,smith-ggx-height");
    QVERIFY(model != nullptr);
    check(state_with(*model), "microfacet:ggx,schlick,smith-ggx-height");
  }

  void camera_goes_around() {
    for (const char* id : {"schueler-optimized-bounded", "ashikhmin-shirley", "ggx-schlick"}) {
      const Model* model = find_model(id);
      if (model == nullptr) continue;
      ViewState state = state_with(*model);
      for (const View& view :
           {View{40, 20, 0, 0, 1}, View{-150, -70, 0.3, -0.2, 2.5}, View{90, 90, 0, 0, 0.6}}) {
        state.camera = view;
        check(state, QByteArray(id) + " turned by " + QByteArray::number(view.turn_deg));
      }
    }
  }

  void quad_from_all_sides() {
    ViewState state = state_with(*find_model("ggx-schlick"));
    state.shape = ViewShape::quad;
    for (const View& view : {View{}, View{40, 20, 0, 0, 1}, View{160, -30, 0.1, 0, 1.2}}) {
      state.camera = view;
      check(state, "quad turned by " + QByteArray::number(view.turn_deg));
    }
  }

  void lights_of_all_kinds_and_environment() {
    ViewState state = state_with(*find_model("schueler-optimized-bounded"));
    Light point;
    point.kind = LightKind::point;
    point.position = {1.5, 1, 2};
    point.intensity = 4;
    Light spot = point;
    spot.kind = LightKind::spot;
    spot.position = {-1.5, 1.5, 2};
    spot.direction = {0.514495755427527, -0.514495755427527, -0.6859943405700353};
    state.lights.lights.push_back(point);
    state.lights.lights.push_back(spot);
    check(state, "lights");
    state.environment = environment;
    state.environment_turn_deg = 70;
    state.exposure = 0.6;
    state.a.surface.opacity = 0.5;
    check(state, "environment");
  }

  void backdrop_beside_and_behind_the_object() {
    ViewState state = state_with(*find_model("ggx-schlick"));
    state.environment = environment;
    state.environment_turn_deg = 20;
    for (const ViewShape shape : {ViewShape::sphere, ViewShape::quad, ViewShape::wedge})
      for (const Backdrop& backdrop : {Backdrop{true, 0.3, true}, Backdrop{false, 0, true}})
        for (const double opacity : {1.0, 0.4})
          for (const View& view :
               {View{}, View{40, 20, 0.4, -0.3, 1.6}, View{-150, -70, 1.5, 0.2, 0.5}, View{0, 0, 0, 0, 20}}) {
            state.shape = shape;
            state.backdrop = backdrop;
            state.a.surface.opacity = opacity;
            state.camera = view;
            state.split = shape != ViewShape::wedge && opacity < 1;
            check(state,
                  "backdrop behind shape " + QByteArray::number(static_cast<int>(shape)) + " at zoom " +
                      QByteArray::number(view.zoom),
                  {}, true);
          }
  }

  void split_and_wedge() {
    ViewState state = gold_state();
    state.b.specular = find_model("ggx-schlick");
    state.split = true;
    state.separator = 0.37;
    check(state, "split");
    state.shape = ViewShape::wedge;
    check(state, "wedge of both");
    state.split = false;
    state.wedge_parameter = "K";
    check(state, "wedge of K");
  }

  void textures() {
    ViewState state = gold_state();
    const auto pair = some_textures();
    for (const char* id :
         {"schueler-optimized-bounded", "ggx-schlick", "phong", "ashikhmin-shirley", "abc-schlick"}) {
      state.a = state_with(*find_model(id)).a;
      state.a.textures = pair;
      for (const ViewShape shape : {ViewShape::quad, ViewShape::sphere}) {
        state.shape = shape;
        check(state, QByteArray("textured ") + id);
        state.zone_overlay = state.energy_overlay = true;
        check(state, QByteArray("textured, with stripes, ") + id);
        state.zone_overlay = state.energy_overlay = false;
      }
    }
  }

  void stripes() {
    ViewState state = state_with(*find_model("schueler-optimized"));
    state.zone_overlay = true;
    state.a.surface.f0 = {0.3, 0.3, 0.3};
    check(state, "zone");
    const QImage marked = viewport->grab_picture();
    state.zone_overlay = false;
    viewport->set_state(state);
    QVERIFY(marked != viewport->grab_picture());
    state.energy_overlay = true;
    state.a.surface.f0 = {0.9, 0.9, 0.9};
    state.a.surface.diffuse = {0.9, 0.9, 0.9};
    state.exposure = 2;
    check(state, "energy");
    state.energy_overlay = false;
    viewport->set_state(state);
    const QImage plain = viewport->grab_picture();
    state.angle_overlay = true;
    check(state, "zones of angle");
    // Up to 45 degrees the ball is as it was; beyond, it is tinted.
    const QImage tinted = viewport->grab_picture();
    const QPoint middle = plain.rect().center();
    QCOMPARE(tinted.pixel(middle), plain.pixel(middle));
    int changed = 0;
    for (int y = 0; y < plain.height(); ++y)
      changed += tinted.pixel(middle.x(), y) != plain.pixel(middle.x(), y);
    QVERIFY(changed > 0);
    state.energy_overlay = true;
    check(state, "zones of angle and stripes");
  }

  void by_open_color_io() {
    ViewState state = gold_state();
    const ViewDisplay all = open_display("", "sRGB - Display", "");
    state.ocio_display = "sRGB - Display";
    check(state, "OpenColorIO sRGB", all);
  }

  // Writes pictures for people to look at into the build folder.
  void pictures_to_look_at() {
    const QDir folder(QStringLiteral(ETAK_BUILD_FOLDER "/screenshots"));
    QVERIFY(folder.mkpath("."));
    const auto save = [&](const ViewState& state, const char* name) {
      viewport->set_state(state);
      QVERIFY(drawn());
      QVERIFY(viewport->grab().save(folder.filePath(QStringLiteral("viewport-%1.png").arg(name))));
    };
    viewport->resize(640, 560);
    ViewState state = gold_state();
    state.split = true;
    state.environment = environment;
    QTest::keyPress(viewport.get(), Qt::Key_Shift);
    save(state, "split-lights");
    QTest::keyRelease(viewport.get(), Qt::Key_Shift);
    state.shape = ViewShape::wedge;
    save(state, "wedge");
    state = state_with(*find_model("schueler-optimized-bounded"));
    state.a.surface.f0 = {0.3, 0.3, 0.3};
    state.zone_overlay = true;
    state.shape = ViewShape::quad;
    state.camera = {35, 20, 0, 0, 1};
    save(state, "zone");
    viewport->resize(360, 300);
  }

  void grabbed_picture_is_the_windows() {
    viewport->set_state(gold_state());
    QVERIFY(drawn());
    QCOMPARE(viewport->grab_picture().convertToFormat(QImage::Format_RGB888),
             on_screen().convertToFormat(QImage::Format_RGB888));
  }

  void shader_tells_what_was_left_out() {
    ViewState state = gold_state();
    viewport->set_state(state);
    QVERIFY(drawn());
    const QString text = viewport->shader_text();
    QVERIFY(text.contains("// Left out:"));
    QVERIFY(text.contains("diffuse: K_d is 0"));
    QVERIFY(text.contains("void main()"));
    QVERIFY(viewport->compile_ms() > 0);
  }

  void values_compile_nothing() {
    ViewState state = gold_state();
    viewport->set_state(state);
    QVERIFY(drawn());
    const double before = viewport->compile_ms();
    const QString text = viewport->shader_text();
    state.a.surface.gloss = 0.31;
    state.a.surface.f0 = {0.2, 0.3, 0.4};
    state.camera = {33, 12, 0.1, 0.2, 1.4};
    state.exposure = 1.7;
    state.lights.lights[0].intensity *= 2;
    viewport->set_state(state);
    QVERIFY(drawn());
    QCOMPARE(viewport->shader_text(), text);
    QCOMPARE(viewport->compile_ms(), before);
  }

  // For a model that was not shown before, the last picture stays until its shader is compiled.
  void the_last_picture_stays_until_the_next_is_there() {
    auto fresh = std::make_unique<Viewport>();
    fresh->resize(360, 300);
    fresh->show();
    QSignalSpy frames(fresh.get(), &Viewport::frame_drawn);
    fresh->set_state(gold_state());
    QTRY_VERIFY_WITH_TIMEOUT(!frames.isEmpty(), patience_ms);
    QVERIFY(QTest::qWaitFor([&] { return !fresh->is_drawing(); }, patience_ms));
    auto* view = fresh->findChild<GlView*>();
    QVERIFY2(view->is_threaded(), "contexts cannot share here");
    const QImage before = view->grabFramebuffer();
    for (const char* id : {"cook-torrance", "ashikhmin-shirley", "ggx-exact"}) {
      if (find_model(id) == nullptr) continue;
      ViewState state = state_with(*find_model(id));
      fresh->set_state(state);
      QVERIFY(fresh->is_drawing());
      QCOMPARE(view->grabFramebuffer(), before);
      fresh->set_state(gold_state());
      QVERIFY(QTest::qWaitFor([&] { return !fresh->is_drawing(); }, patience_ms));
      QCOMPARE(view->grabFramebuffer(), before);
    }
    // The viewport is deleted while a shader is compiled.
    fresh->set_state(state_with(*find_model("schueler-full")));
    fresh.reset();
  }

  // Drawing in the user-interface thread, as where contexts cannot share, gives the same pictures.
  void without_a_thread_of_its_own() {
    Viewport plain(nullptr, Viewport::Backend::gl_one_thread);
    plain.resize(360, 300);
    QSignalSpy frames(&plain, &Viewport::frame_drawn);
    plain.set_state(gold_state());
    plain.show();
    QTRY_VERIFY_WITH_TIMEOUT(!frames.isEmpty(), patience_ms);
    auto* view = plain.findChild<GlView*>();
    QVERIFY(!view->is_threaded());
    viewport->set_state(gold_state());
    const auto both_refined = [&] { return !plain.is_refining() && !viewport->is_refining(); };
    QVERIFY(QTest::qWaitFor(both_refined, patience_ms));
    QCOMPARE(view->grabFramebuffer(), on_screen());
    QCOMPARE(plain.grab_picture(), viewport->grab_picture());
    QVERIFY(plain.compile_ms() > 0);
    frames.clear();
    const QImage before = view->grabFramebuffer();
    plain.set_state(state_with(*find_model("ggx-schlick")));
    QCOMPARE(view->grabFramebuffer(), before);  // begins the frame, and does not wait for it
    QVERIFY(plain.is_drawing());
    viewport->set_state(state_with(*find_model("ggx-schlick")));
    QTRY_VERIFY_WITH_TIMEOUT(!frames.isEmpty(), patience_ms);
    QVERIFY(QTest::qWaitFor(both_refined, patience_ms));
    QCOMPARE(view->grabFramebuffer(), on_screen());
  }

  // Qt makes another context where a widget moves to another window.
  void another_window_and_the_whole_screen() {
    auto moved = std::make_unique<Viewport>();
    moved->resize(360, 300);
    QSignalSpy frames(moved.get(), &Viewport::frame_drawn);
    moved->set_state(gold_state());
    moved->show();
    QTRY_VERIFY_WITH_TIMEOUT(!frames.isEmpty(), patience_ms);
    const QImage before = moved->grab_picture();
    QWidget window;
    window.resize(400, 400);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    moved->setParent(&window);
    moved->setGeometry(10, 10, 360, 300);
    frames.clear();
    moved->show();
    QTRY_VERIFY_WITH_TIMEOUT(!frames.isEmpty(), patience_ms);
    QVERIFY(moved->uses_gl());
    QCOMPARE(moved->grab_picture(), before);
    window.showFullScreen();
    moved->set_state(state_with(*find_model("ggx-schlick")));
    moved->setParent(nullptr);
    frames.clear();
    moved->showFullScreen();
    QTRY_VERIFY_WITH_TIMEOUT(!frames.isEmpty(), patience_ms);
    moved->showNormal();
    QVERIFY(QTest::qWaitFor([&] { return !moved->is_drawing(); }, patience_ms));
    QVERIFY(moved->uses_gl() && moved->message().isEmpty());
  }

  void context_loss_is_survived() {
    viewport->set_state(gold_state());
    const QImage before = viewport->grab_picture();
    viewport->recover_from_lost_context();
    QVERIFY(viewport->uses_gl());
    QSignalSpy frames(viewport.get(), &Viewport::frame_drawn);
    QTRY_VERIFY_WITH_TIMEOUT(!frames.isEmpty(), patience_ms);
    QCOMPARE(viewport->grab_picture(), before);
    viewport->recover_from_lost_context();
    QVERIFY(!viewport->uses_gl());
    QVERIFY(viewport->message().contains("context"));
    QTRY_VERIFY_WITH_TIMEOUT(!frames.isEmpty(), patience_ms);
    const QImage after = viewport->grab_picture();
    const Image linear = draw_view(gold_state(), after.width(), after.height(), 2);
    QVERIFY(apart(after, before, linear).codes <= 2);
  }

  void cleanupTestCase() { viewport.reset(); }
};

ETAK_GUI_TEST(ViewportGl, "viewport_gl")
#include "test_viewport_gl.moc"
