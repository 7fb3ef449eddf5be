// SPDX-License-Identifier: Apache-2.0
// Prints frame times of the OpenGL viewport at 900 x 900 under three lights.
#include <QtTest>
#include <algorithm>
#include <ctime>

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
      for (int i = 0; i < 25; ++i) {
        state.a.surface.gloss = 0.3 + 0.02 * i;  // as if a slider were dragged
        drawn.clear();
        const double before = process_seconds();
        viewport.set_state(state);
        QTRY_VERIFY_WITH_TIMEOUT(!drawn.isEmpty(), patience_ms);
        times.push_back(viewport.frame_ms());
        work.push_back(1e3 * (process_seconds() - before));
      }
      std::sort(times.begin() + 1, times.end());
      std::sort(work.begin() + 1, work.end());
      const double least = times[1], median = times[12];
      worst = std::max(worst, std::min(least, work[12] / 2));
      qInfo("%-30s %6.2f ms least, %6.2f median; %.2f ms of processors; compiled in %.1f ms", id.c_str(),
            least, median, work[12], viewport.compile_ms());
    }
    // There is no limit here, because a busy machine would exceed it. On two free cores 33 ms are wanted.
    qInfo("slowest: %.1f ms by the clock or by half the processor time, whichever is less", worst);
  }
};

ETAK_GUI_TEST(ViewportFrames, "viewport_frames")
#include "test_viewport_frames.moc"
