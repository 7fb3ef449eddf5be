// SPDX-License-Identifier: Apache-2.0
// Mouse and keys of the viewport, whichever device draws it.
#include <QMimeData>
#include <QtTest>
#include <ctime>

#include "core/render/view_moves.h"
#include "tests/gui/gui_test.h"
#include "tests/gui/view_states.h"
#include "tests/gui/watchdog.h"

using namespace etak;
using namespace etak::test;

namespace {

// Records the keys that the viewport does not handle.
class Window : public QWidget {
 public:
  QList<int> keys;

 protected:
  void keyPressEvent(QKeyEvent* event) override { keys << event->key(); }
};

// Processor time of this thread in seconds, which does not grow on a busy machine.
double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

class ViewportHands : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<Window> window;
  Viewport* viewport = nullptr;

  void drag(Qt::MouseButton button, Qt::KeyboardModifiers keys, const QPoint& from, const QPoint& to) {
    QTest::mousePress(viewport, button, keys, from);
    for (int i = 1; i <= 4; ++i) {
      const QPoint at = from + (to - from) * i / 4;
      QMouseEvent move(QEvent::MouseMove, QPointF(at), viewport->mapToGlobal(QPointF(at)), Qt::NoButton,
                       Qt::MouseButtons(button), keys);
      QApplication::sendEvent(viewport, &move);
    }
    QTest::mouseRelease(viewport, button, keys, to);
  }

  void wheel(const QPoint& at, int notches, Qt::KeyboardModifiers keys = Qt::NoModifier) {
    QWheelEvent event(QPointF(at), viewport->mapToGlobal(QPointF(at)), {}, QPoint(0, 120 * notches),
                      Qt::NoButton, keys, Qt::NoScrollPhase, false);
    QApplication::sendEvent(viewport, &event);
  }

  ViewPlace place(const QPoint& at) const {
    return place_under(viewport->state(), viewport->width(), viewport->height(), at.x(), at.y()).place;
  }

 private slots:
  void init() {
    window = std::make_unique<Window>();
    window->resize(400, 320);
    viewport = new Viewport(window.get());
    viewport->setGeometry(window->rect());
    viewport->set_state(gold_state());
    QSignalSpy drawn(viewport, &Viewport::frame_drawn);
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window.get()));
    QTRY_VERIFY_WITH_TIMEOUT(!drawn.isEmpty(), patience_ms);
    viewport->setFocus();
  }
  void cleanup() { window.reset(); }

  void left_drag_orbits_as_one_edit() {
    QSignalSpy edits(viewport, &Viewport::state_edited);
    drag(Qt::LeftButton, Qt::NoModifier, {200, 160}, {240, 140});
    QVERIFY(viewport->state().camera.turn_deg < 0);  // the object follows the cursor
    QVERIFY(viewport->state().camera.rise_deg < 0);
    QVERIFY(edits.size() >= 2);
    const int press = edits.first().at(1).toInt();
    for (const auto& edit : edits) QCOMPARE(edit.at(1).toInt(), press);
    QCOMPARE(edits.last().at(0).value<ViewState>(), viewport->state());
    drag(Qt::LeftButton, Qt::AltModifier, {200, 160}, {190, 160});
    QVERIFY(edits.last().at(1).toInt() != press);
  }

  void middle_drag_pans_the_picture_along() {
    const ViewPlace held = place({200, 160});
    drag(Qt::MiddleButton, Qt::NoModifier, {200, 160}, {250, 130});
    const ViewPlace now = place({250, 130});
    QVERIFY(std::abs(now.x - held.x) < 1e-9 && std::abs(now.y - held.y) < 1e-9);
  }

  void wheel_zooms_about_the_cursor() {
    const ViewPlace held = place({260, 100});
    wheel({260, 100}, 3);
    QVERIFY(viewport->state().camera.zoom > 1.2);
    const ViewPlace now = place({260, 100});
    QVERIFY(std::abs(now.x - held.x) < 1e-9 && std::abs(now.y - held.y) < 1e-9);
    wheel({260, 100}, -3);
    QVERIFY(std::abs(viewport->state().camera.zoom - 1) < 1e-9);
  }

  void alt_and_right_drag_zooms() {
    drag(Qt::RightButton, Qt::AltModifier, {200, 160}, {200, 100});
    QVERIFY(viewport->state().camera.zoom > 1.1);
    QCOMPARE(viewport->state().camera.pan_x, 0.0);
  }

  void control_drag_turns_the_environment() {
    drag(Qt::LeftButton, Qt::ControlModifier, {200, 160}, {250, 160});
    QVERIFY(viewport->state().environment_turn_deg > 10);
    QCOMPARE(viewport->state().camera, View{});
  }

  void shift_drag_takes_a_light_along() {
    const std::vector<LightMark> marks = light_marks(viewport->state().lights, View{});
    const QPoint from(200 + qRound(marks[0].place.x * 320 / 2.2), 160 - qRound(marks[0].place.y * 320 / 2.2));
    drag(Qt::LeftButton, Qt::ShiftModifier, from, {230, 190});
    const ViewPlace cursor = place({230, 190});
    const ViewPlace now = light_marks(viewport->state().lights, View{})[0].place;
    QVERIFY(std::hypot(now.x - cursor.x, now.y - cursor.y) < 0.02);
    QCOMPARE(viewport->state().lights.lights[1], gold_state().lights.lights[1]);
  }

  void shift_drag_takes_the_hemispheres_along() {
    ViewState state = gold_state();
    state.lights.lights.clear();
    viewport->set_state(state);
    drag(Qt::LeftButton, Qt::ShiftModifier, {200, 60}, {260, 130});
    QVERIFY(viewport->state().lights.hemispheres->axis != state.lights.hemispheres->axis);
    wheel({200, 100}, 2, Qt::ShiftModifier);
    QVERIFY(viewport->state().lights.hemispheres->upper[0] > state.lights.hemispheres->upper[0]);
  }

  void separator_is_dragged() {
    ViewState state = gold_state();
    state.split = true;
    viewport->set_state(state);
    drag(Qt::LeftButton, Qt::NoModifier, {200, 30}, {100, 40});
    QCOMPARE(viewport->state().separator, 0.25);
    QCOMPARE(viewport->state().camera, View{});
  }

  void f_frames_and_double_click_resets() {
    ViewState state = gold_state();
    state.camera = {30, 20, 0.5, 0.2, 3};
    viewport->set_state(state);
    QTest::keyClick(viewport, Qt::Key_F);
    QCOMPARE(viewport->state().camera, (View{30, 20, 0, 0, 1}));
    QTest::mouseDClick(viewport, Qt::LeftButton, Qt::NoModifier, {200, 160});
    QCOMPARE(viewport->state().camera, View{});
  }

  void arrows_are_the_windows() {
    for (const Qt::Key key : {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down})
      QTest::keyClick(viewport, key);
    QCOMPARE(window->keys.size(), 4);
  }

  void keys_orbit_zoom_and_turn_the_environment() {
    QSignalSpy edits(viewport, &Viewport::state_edited);
    QTest::keyClick(viewport, Qt::Key_Right, Qt::AltModifier);
    QTest::keyClick(viewport, Qt::Key_Up, Qt::AltModifier);
    QVERIFY(std::abs(viewport->state().camera.turn_deg + 5) < 1e-9);
    QVERIFY(std::abs(viewport->state().camera.rise_deg + 5) < 1e-9);
    QTest::keyClick(viewport, Qt::Key_Plus);
    QVERIFY(std::abs(viewport->state().camera.zoom - 1.1) < 1e-9);
    QTest::keyClick(viewport, Qt::Key_Minus);
    QVERIFY(std::abs(viewport->state().camera.zoom - 1) < 1e-9);
    const ViewState before = viewport->state();
    QTest::keyClick(viewport, Qt::Key_Left, Qt::ControlModifier);
    QTest::keyClick(viewport, Qt::Key_Left, Qt::ControlModifier);
    QVERIFY(viewport->state().environment_turn_deg != 0);
    QCOMPARE(viewport->state().camera, before.camera);
    QCOMPARE(edits.size(), 6);
    QCOMPARE(edits[5].at(1).toInt(), edits[4].at(1).toInt());  // steps of one key are one press
    QVERIFY(edits[4].at(1).toInt() != edits[3].at(1).toInt());
    QVERIFY(!window->keys.contains(Qt::Key_Left) && !window->keys.contains(Qt::Key_Right));
  }

  void keys_move_the_light_that_l_chooses() {
    const LightSetup before = viewport->state().lights;
    QTest::keyClick(viewport, Qt::Key_Right, Qt::ShiftModifier);
    QVERIFY(viewport->state().lights.lights[0] != before.lights[0]);
    QCOMPARE(viewport->state().lights.lights[1], before.lights[1]);
    viewport->set_state(gold_state());
    QTest::keyClick(viewport, Qt::Key_L);
    QTest::keyClick(viewport, Qt::Key_Up, Qt::ShiftModifier);
    QCOMPARE(viewport->state().lights.lights[0], before.lights[0]);
    QVERIFY(viewport->state().lights.lights[1] != before.lights[1]);
  }

  void keys_move_the_separator_of_a_comparison() {
    QTest::keyClick(viewport, Qt::Key_Comma);
    QCOMPARE(viewport->state().separator, 0.5);
    ViewState state = gold_state();
    state.split = true;
    viewport->set_state(state);
    QTest::keyClick(viewport, Qt::Key_Comma);
    QVERIFY(viewport->state().separator < 0.5);
    QTest::keyClick(viewport, Qt::Key_Period);
    QCOMPARE(viewport->state().separator, 0.5);
  }

  void held_space_shows_the_other_side() {
    const QImage a = viewport->grab_picture();
    QTest::keyPress(viewport, Qt::Key_Space);
    const QImage b = viewport->grab_picture();
    QVERIFY(a != b);
    QTest::keyRelease(viewport, Qt::Key_Space);
    QCOMPARE(viewport->grab_picture(), a);
    QCOMPARE(viewport->state(), gold_state());
  }

  void patch_under_the_cursor_is_the_pictures() {
    ViewState state = gold_state();
    state.b = state.a;
    viewport->set_state(state);
    const QImage picture = viewport->grab_picture();
    auto patch = viewport->patch_at({210, 230});
    QVERIFY(patch && patch->on_object);
    QCOMPARE(patch->delta_e, 0.0);
    const QColor color = picture.pixelColor(210, 230);
    QVERIFY(std::abs(color.red() - patch->code_a[0]) <= 2 && std::abs(color.blue() - patch->code_a[2]) <= 2);
    state.b.surface.f0 = {0.95, 0.93, 0.88};
    viewport->set_state(state);
    patch = viewport->patch_at({210, 230});
    QVERIFY(patch->delta_e > 1);
    QVERIFY(patch->difference[2] > 0);
    QVERIFY(!viewport->patch_at({3, 3})->on_object);
    QSignalSpy hovered(viewport, &Viewport::hovered);
    QMouseEvent move(QEvent::MouseMove, QPointF(210, 200), viewport->mapToGlobal(QPointF(210, 200)),
                     Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(viewport, &move);
    QTRY_VERIFY_WITH_TIMEOUT(!hovered.isEmpty(), patience_ms);
  }

  void drops_are_told_apart() {
    QSignalSpy environments(viewport, &Viewport::environment_dropped);
    QSignalSpy textures(viewport, &Viewport::textures_dropped);
    QSignalSpy materials(viewport, &Viewport::material_dropped);
    const auto drop = [&](const QMimeData& data) {
      QDragEnterEvent enter({20, 20}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
      QApplication::sendEvent(viewport, &enter);
      QDropEvent event({20, 20}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
      QApplication::sendEvent(viewport, &event);
    };
    QMimeData sky, pair, gold;
    sky.setUrls({QUrl::fromLocalFile("/some/sky.HDR")});
    pair.setUrls({QUrl::fromLocalFile("/some/a.png"), QUrl::fromLocalFile("/some/b.png")});
    gold.setData(Viewport::material_mime, "gold");
    drop(sky);
    drop(pair);
    drop(gold);
    QCOMPARE(environments.at(0).at(0).toString(), "/some/sky.HDR");
    QCOMPARE(textures.at(0).at(0).toStringList().size(), 2);
    QCOMPARE(materials.at(0).at(0).toString(), "gold");
  }

  void object_keeps_its_proportions() {
    for (const QSize& size : {QSize(600, 200), QSize(200, 300), QSize(301, 301)}) {
      const Image picture = draw_view(gold_state(), size.width(), size.height(), 2);
      int across = 0, down = 0;
      for (int x = 0; x < size.width(); ++x) across += picture.at(x, size.height() / 2)[3] > 0.5;
      for (int y = 0; y < size.height(); ++y) down += picture.at(size.width() / 2, y)[3] > 0.5;
      QVERIFY(std::abs(across - down) <= 1);
      QVERIFY(across < size.width() && down < size.height());
    }
  }

  void state_that_cannot_be_drawn_says_so() {
    ViewState bad = gold_state();
    bad.a.overrides = {{"no-such-parameter", 1}};
    QSignalSpy messages(viewport, &Viewport::message_changed);
    viewport->set_state(bad);
    QTRY_VERIFY_WITH_TIMEOUT(viewport->message().contains("no-such-parameter"), patience_ms);
    QVERIFY(!viewport->grab_picture().isNull());
    drag(Qt::LeftButton, Qt::NoModifier, {200, 160}, {240, 140});
    viewport->set_state(gold_state());
    QTRY_VERIFY_WITH_TIMEOUT(!viewport->message().contains("no-such-parameter"), patience_ms);
    bad = gold_state();
    bad.ocio_config = "/no/such/config.ocio";
    viewport->set_state(bad);
    QTRY_VERIFY_WITH_TIMEOUT(viewport->message().contains("no such file"), patience_ms);
  }

  void a_huge_texture_is_shrunk_or_refused() {
    ViewState state = gold_state();
    const Image huge(5000, 40, 3, 0.5F);
    state.a.textures = surface_textures({.body = &huge});
    QCOMPARE(state.a.textures->body.width, 1024);
    viewport->set_state(state);
    QVERIFY(!viewport->grab_picture().isNull());
    QVERIFY(!viewport->message().contains("texture"));
    state.a.textures =
        std::make_shared<const SurfaceTextures>(SurfaceTextures{Image(5000, 1, 4), Image(1, 1, 4)});
    viewport->set_state(state);
    (void)viewport->grab_picture();
    QVERIFY(viewport->message().contains("5000"));
  }

  void thread_of_windows_is_never_held_up() {
    // The work is measured by the processor time of the thread, to which other programs add only by slowing the
    // processor down for a while. What the viewport itself does comes again in each of three rounds, so that the
    // round with the least is its own.
    ViewState state = gold_state();
    state.a.surface.diffuse = {0.2, 0.2, 0.2};
    double least = 1;
    for (int round = 0; round < 3; ++round) {
      window->resize(1400 - 50 * round, 1000);
      viewport->setGeometry(window->rect());
      double most = 0;
      for (int i = 0; i < 12; ++i) {
        state.a.surface.gloss = 0.2 + 0.05 * i + 0.01 * round;
        const double before = thread_seconds();
        viewport->set_state(state);
        QApplication::processEvents();
        most = std::max(most, thread_seconds() - before);
        QTest::qWait(20);
      }
      least = std::min(least, most);
    }
    qInfo("most work at once: %.1f ms%s", 1e3 * least, viewport->uses_gl() ? ", with OpenGL" : "");
    QVERIFY(1e3 * least < most_work_ms());
  }

  void people_without_eyes_or_mouse() {
    QCOMPARE(viewport->accessibleName(), "Viewport");
    QVERIFY(!viewport->accessibleDescription().isEmpty());
    QVERIFY(viewport->focusPolicy() & Qt::TabFocus);
    if (!viewport->uses_gl()) QVERIFY(viewport->message().contains("CPU"));
  }
};

ETAK_GUI_TEST(ViewportHands, "viewport_hands")
#include "test_viewport_hands.moc"
