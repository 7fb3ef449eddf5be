// SPDX-License-Identifier: Apache-2.0
#include <QtTest>

#include "app/viewport/viewport.h"
#include "tests/gui/gui_test.h"

using namespace etak;

namespace {

ViewState gold() {
  ViewState out;
  out.a.surface.f0 = {1.0, 0.78, 0.34};
  out.a.specular = find_model(default_specular);
  out.a.diffuse = find_model(default_diffuse);
  out.b = out.a;
  out.lights = default_lights();
  return out;
}

}  // namespace

class ViewportCpu : public QObject {
  Q_OBJECT

 private slots:
  void draws_without_gl() {
    Viewport viewport(nullptr, Viewport::Backend::cpu);
    viewport.resize(200, 200);
    viewport.set_state(gold());
    const QImage picture = viewport.grab_picture();
    QCOMPARE(picture.size(), QSize(200, 200));
    QVERIFY(!viewport.uses_gl());
    QVERIFY(picture.pixelColor(100, 100) != picture.pixelColor(2, 2));
  }

  // Also run where OpenGL drivers are missing (ETAK_TEST_NO_GL): the picture is drawn, and a message tells
  // why the CPU draws it.
  void without_a_driver_people_are_told() {
    Viewport viewport;
    viewport.resize(200, 200);
    viewport.set_state(gold());
    QSignalSpy drawn(&viewport, &Viewport::frame_drawn);
    viewport.show();
    QVERIFY(QTest::qWaitFor([&] { return !drawn.isEmpty(); }, 20000));
    if (qEnvironmentVariableIsSet("ETAK_TEST_NO_GL")) QVERIFY(!viewport.uses_gl());
    if (viewport.uses_gl()) return;
    QVERIFY(!viewport.fallback_reason().isEmpty());
    QVERIFY(viewport.message().contains(viewport.fallback_reason()));
    const QImage picture = viewport.grab_picture();
    QVERIFY(picture.pixelColor(100, 100) != picture.pixelColor(2, 2));
    QCOMPARE(viewport.compile_ms(), 0.0);
  }

  void the_note_that_the_cpu_draws_fades() {
    Viewport viewport(nullptr, Viewport::Backend::cpu);
    viewport.resize(300, 300);
    viewport.set_state(gold());
    QSignalSpy drawn(&viewport, &Viewport::frame_drawn);
    viewport.show();
    QVERIFY(QTest::qWaitFor([&] { return !drawn.isEmpty() && !viewport.is_drawing(); }, 20000));
    const QRect note(50, 50, 200, 40);
    const QImage with_note = viewport.grab(note).toImage();
    QVERIFY(QTest::qWaitFor([&] { return viewport.grab(note).toImage() != with_note; },
                            Viewport::cpu_note_ms + 2000));
    QVERIFY(!viewport.message().isEmpty());
  }
};

ETAK_GUI_TEST(ViewportCpu, "viewport_cpu")
#include "test_viewport_cpu.moc"
