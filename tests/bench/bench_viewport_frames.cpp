// SPDX-License-Identifier: Apache-2.0
// bench_editor viewport_frames: prints frame times of the OpenGL viewport, at 900 x 900 under three lights and at two
// sizes in the studio. Begin it with tests/gui/under_xvfb.sh. ETAK_FRAMES says of how many frames the times are taken.
#include <QtTest>
#include <algorithm>
#include <ctime>
#include <functional>

#include "app/viewport/gl_view.h"
#include "tests/gui/gui_test.h"
#include "tests/gui/view_states.h"

using namespace etak;
using namespace etak::test;

namespace {

double process_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

int frames_wanted() {
  return std::max(3, qEnvironmentVariableIntValue("ETAK_FRAMES"));
}

}  // namespace

class ViewportFrames : public QObject {
  Q_OBJECT

 private slots:
  void schueler_and_ggx() {
    Viewport viewport;
    viewport.resize(900, 900);
    QElapsedTimer start;
    start.start();
    QSignalSpy drawn(&viewport, &Viewport::frame_drawn);
    viewport.set_state(gold_state());
    viewport.show();
    QVERIFY(QTest::qWaitForWindowExposed(&viewport));
    if (!viewport.uses_gl()) QSKIP(qPrintable("skipped: no OpenGL here: " + viewport.fallback_reason()));
    QTRY_VERIFY_WITH_TIMEOUT(!drawn.isEmpty(), patience_ms);
    qInfo("%s: first frame after %lld ms", qPrintable(viewport.gl_name()), start.elapsed());
    double worst = 0;
    for (const Model& model : models()) {
      const std::string id(model.id);
      if (!id.starts_with("schueler") && !id.starts_with("ggx")) continue;
      ViewState state = state_with(model);
      QVERIFY(state.lights.lights.size() == 3);
      std::vector<double> times, work;
      for (int i = 0; i <= frames_wanted(); ++i) {
        state.a.surface.gloss = 0.3 + 0.5 * i / frames_wanted();  // as if a slider were dragged
        drawn.clear();
        const double before = process_seconds();
        viewport.set_state(state);
        QTRY_VERIFY_WITH_TIMEOUT(!drawn.isEmpty(), patience_ms);
        times.push_back(viewport.frame_ms());
        work.push_back(1e3 * (process_seconds() - before));
      }
      // The first frame compiles.
      std::sort(times.begin() + 1, times.end());
      std::sort(work.begin() + 1, work.end());
      const std::size_t middle = 1 + (times.size() - 1) / 2;
      const double least = times[1], median = times[middle];
      worst = std::max(worst, std::min(least, work[middle] / 2));
      qInfo("%-30s %6.2f ms least, %6.2f median; %.2f ms of processors; compiled in %.1f ms", id.c_str(),
            least, median, work[middle], viewport.compile_ms());
    }
    // There is no limit here, because a busy machine would exceed it. On two free cores 33 ms are wanted.
    qInfo("slowest: %.1f ms by the clock or by half the processor time, whichever is less", worst);
  }

  void gold_and_glass_in_the_studio() {
    const auto studio = studio_environment("studio", studio_lights().environment_scale, 2);
    for (const QSize& size : {QSize(900, 900), QSize(1920, 1080)})
      for (const bool clear : {false, true})
        for (const bool backdrop : {false, true}) {
          Viewport viewport;
          viewport.resize(size);
          ViewState state = gold_state();
          state.lights = studio_lights();
          state.environment = studio;
          state.backdrop = {backdrop, 0.3, backdrop};
          if (clear) {
            state.a.surface.f0 = {0.04, 0.04, 0.04};
            state.a.surface.gloss = 1;
            state.a.surface.opacity = 0;
            state.a.surface.passing = Vec3{1, 1, 1};
          }
          viewport.set_state(state);
          viewport.show();
          QVERIFY(QTest::qWaitForWindowExposed(&viewport));
          if (!viewport.uses_gl())
            QSKIP(qPrintable("skipped: no OpenGL here: " + viewport.fallback_reason()));
          QTRY_VERIFY_WITH_TIMEOUT(!viewport.is_drawing() && viewport.frame_ms() > 0, patience_ms);
          const auto name = QStringLiteral("%1 x %2, %3%4")
                                .arg(size.width())
                                .arg(size.height())
                                .arg(clear ? QStringLiteral("glass") : QStringLiteral("gold"))
                                .arg(backdrop ? QStringLiteral(", backdrop and ground") : QString());
          const Times still = times_of(viewport, [&](int i) {
            state.environment_turn_deg = i + 1;
            viewport.set_state(state);
          });
          QTest::mousePress(&viewport, Qt::LeftButton, {}, viewport.rect().center());
          const Times moving = times_of(viewport, [&](int i) {
            const QPointF at = viewport.rect().center() + QPointF(2 * i + 2, i % 3);
            QMouseEvent move(QEvent::MouseMove, at, viewport.mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                             Qt::NoModifier);
            QCoreApplication::sendEvent(&viewport, &move);
          });
          const double share = viewport.findChild<GlView*>()->share();
          QTest::mouseRelease(&viewport, Qt::LeftButton, {}, viewport.rect().center());
          QTRY_VERIFY_WITH_TIMEOUT(!viewport.is_drawing(), patience_ms);
          QCOMPARE(viewport.findChild<GlView*>()->share(), 1.0);
          QVERIFY(still.least <= fluid_ms || share < 1);
          QVERIFY(still.median > 0);
          QVERIFY(moving.median > 0);
          qInfo(
              "%-40s whole frames %5.1f ms least, %5.1f median, %5.1f of processors; while moving %5.1f, %5.1f, %5.1f at %g of the size",
              qPrintable(name), still.least, still.median, still.work, moving.least, moving.median,
              moving.work, share);
        }
  }

 private:
  struct Times {
    double least = 0, median = 0, work = 0;
  };
  // Of frames that `change` asks for; `work` is the median of what all processors did for one.
  static Times times_of(Viewport& viewport, const std::function<void(int)>& change) {
    const int frames = frames_wanted();
    constexpr int warm = 3;
    std::vector<double> times, work;
    QSignalSpy drawn(&viewport, &Viewport::frame_drawn);
    for (int i = 0; i < frames + warm; ++i) {
      drawn.clear();
      const double before = process_seconds();
      change(i);
      if (!QTest::qWaitFor([&] { return !drawn.isEmpty() && !viewport.is_drawing(); }, patience_ms))
        return {};
      if (i < warm) continue;
      times.push_back(viewport.frame_ms());
      work.push_back(1e3 * (process_seconds() - before));
    }
    std::sort(times.begin(), times.end());
    std::sort(work.begin(), work.end());
    return {times.front(), times[times.size() / 2], work[work.size() / 2]};
  }
};

ETAK_GUI_TEST(ViewportFrames, "viewport_frames")
#include "bench_viewport_frames.moc"
