// SPDX-License-Identifier: Apache-2.0
#include <QtTest>

#ifdef __linux__
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

#include "app/viewport/background.h"
#include "app/viewport/frame_share.h"
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

#ifdef __linux__
  void work_that_nobody_waits_for_lets_others_go_first() {
    const int usual = ::getpriority(PRIO_PROCESS, 0);
    int lowered = usual;
    QThreadPool pool;
    run_in(pool, [&] {
      for (int i = 0; i < 2; ++i) let_others_go_first();
      lowered = ::getpriority(PRIO_PROCESS, static_cast<id_t>(::syscall(SYS_gettid)));
    });
    pool.waitForDone();
    QCOMPARE(lowered, std::min(usual + 10, 19));
    QCOMPARE(::getpriority(PRIO_PROCESS, 0), usual);
  }
#endif

  void frames_of_a_drag_get_smaller_until_they_are_fluid() {
    for (const double fixed_ms : {0.0, 5.0, 8.0})
      for (const double whole_ms : {4.0, 15.0, 40.0, 90.0, 200.0, 350.0}) {
        const auto ms = [&](double share) { return fixed_ms + whole_ms * share * share; };
        FrameShare shares;
        for (int i = 0; i < 2; ++i) shares.took(1, ms(1));
        for (int i = 0; i < 20; ++i) {
          const double share = shares.next();
          QVERIFY2(ms(share) <= fluid_ms || share == FrameShare::shares.back(),
                   qPrintable(QStringLiteral("%1 ms at %2").arg(ms(share)).arg(share)));
          shares.took(share, ms(share));
        }
        // A view that is drawn fast enough is drawn whole, and no view smaller than it must be.
        if (ms(1) < 20) QCOMPARE(shares.next(), 1.0);
        if (fixed_ms == 0 && whole_ms == 90) QCOMPARE(shares.next(), 0.5);
        // One frame during which another program had the processors changes nothing.
        const double before = shares.next();
        shares.took(before, 400);
        QCOMPARE(shares.next(), before);
        shares.took(before, ms(before));
        QCOMPARE(shares.next(), before);
      }
    QCOMPARE(FrameShare::size(QSize(1921, 3), 0.25), QSize(481, 1));
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
