// SPDX-License-Identifier: Apache-2.0
// bench_editor editor_times: prints how long the editor takes from a change to the picture that shows it, with OpenGL where there is one:
// the gloss of a material with textures of 4096 x 4096 texels, an environment of 1024 x 512 pixels, a slider that is dragged, a dropped set
// of three pictures of 4096 x 4096 and its reload, and the longest stall of the window with 1,000 materials.
#include <QAbstractButton>
#include <QSlider>
#include <algorithm>
#include <ctime>

#include "app/editor/panels/drop_table.h"
#include "app/editor/panels/inspector/inspector.h"
#include "app/editor/panels/inspector/texture_section.h"
#include "app/editor/panels/project_panel.h"
#include "app/editor/start_time.h"
#include "tests/gui/editor_hands.h"
#include "tests/gui/gui_test.h"

using namespace etak;
using namespace etak::editor;

namespace {

constexpr int most_ms = 120000;

// Milliseconds until the picture of a state for which `shown` holds is on the screen; -1 where none comes.
template <class Shown>
double until_drawn(TestWindow& window, QElapsedTimer& timer, Shown shown) {
  if (!QTest::qWaitFor([&] { return shown() && !window->viewport().is_drawing(); }, most_ms)) return -1;
  QCoreApplication::processEvents();  // paints what the thread has drawn
  return static_cast<double>(timer.nsecsElapsed()) * 1e-6;
}

// A picture of 4096 x 4096 texels of a dropped set, with the noise that pictures of surfaces have. A normal map leans by
// the slopes of waves and noise.
void save_texels(const QString& file, int shade) {
  const bool normal = file.contains(QLatin1String("normal"));
  QImage tiles(4096, 4096, QImage::Format_RGB32);
  std::uint32_t noise = 7;
  for (int y = 0; y < tiles.height(); ++y) {
    auto* const row = reinterpret_cast<QRgb*>(tiles.scanLine(y));
    for (int x = 0; x < tiles.width(); ++x) {
      noise = noise * 1664525U + 1013904223U;
      const auto a = static_cast<int>(noise >> 28), b = static_cast<int>(noise >> 24 & 15);
      const int u = normal ? 64 - std::abs(x % 256 - 128) : x / 64 % 60,
                v = normal ? 64 - std::abs(y % 256 - 128) : y / 32 % 50;
      row[x] = normal ? qRgb(128 + u / 2 + a - 8, 128 + v / 2 + b - 8, 250 - (u * u + v * v) / 300)
                      : qRgb(shade + u + a, shade + v + a, shade + b);
    }
  }
  QVERIFY(tiles.save(file, "PNG", 60));
}

double thread_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

// The longest that the event loop did not come round while it lives, by the clock and by the work of its thread.
class Stalls : public QObject {
 public:
  Stalls() {
    timer_.setInterval(0);
    connect(&timer_, &QTimer::timeout, this, [this] { look(); });
    forget();
    timer_.start();
  }
  void forget() {
    clock_.start();
    work_ = thread_ms();
    most_clock = most_work = 0;
  }
  double most_clock = 0, most_work = 0;

 private:
  void look() {
    most_clock = std::max(most_clock, static_cast<double>(clock_.nsecsElapsed()) * 1e-6);
    const double now = thread_ms();
    most_work = std::max(most_work, now - work_);
    clock_.start();
    work_ = now;
  }
  QTimer timer_;
  QElapsedTimer clock_;
  double work_ = 0;
};

}  // namespace

class EditorTimes : public QObject {
  Q_OBJECT

 private slots:
  void gloss_of_large_textures() {
    TestWindow window;
    window->show();
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    QImage tiles(4096, 4096, QImage::Format_RGB32);
    for (int y = 0; y < tiles.height(); ++y)
      for (int x = 0; x < tiles.width(); ++x)
        tiles.setPixel(x, y, qRgb(90 + x / 64 % 100, 60 + y / 32 % 120, 100));
    const QString file = window.file(QStringLiteral("wood_diffuse.png"));
    QVERIFY(tiles.save(file, "PNG", 90));
    QElapsedTimer timer;
    timer.start();
    put_texture(window, Channel::diffuse, file);
    const auto textures = [&] { return window->viewport().state().a.textures; };
    const double first = until_drawn(window, timer, [&] { return textures() != nullptr; });
    QVERIFY(first > 0);
    QVERIFY(window.settle(most_ms));
    std::vector<double> times, work;
    QSignalSpy drawn(&window->viewport(), &Viewport::frame_drawn);
    for (int i = 0; i < 11; ++i) {
      const double gloss = 0.2 + 0.05 * i;
      ProjectMaterial next = *window->document().material();
      next.gloss = gloss;
      const qsizetype before = drawn.count();
      const double worked = since_start().work_ms;
      timer.restart();
      window->document().edit(window->document().current(), next, QStringLiteral("gloss"), 1);
      times.push_back(until_drawn(window, timer, [&] {
        const ViewSide& side = window->viewport().state().a;
        return side.textures && !side.textures->has.gloss && side.surface.gloss == gloss &&
               drawn.count() > before;
      }));
      QVERIFY(times.back() > 0);
      work.push_back(since_start().work_ms - worked);
    }
    std::sort(times.begin(), times.end());
    std::sort(work.begin(), work.end());
    qInfo(
        "gloss of 4096 x 4096 texels: files read in %.0f ms; then %.1f ms least, %.1f median to the screen, %.1f of processors",
        first, times.front(), times[times.size() / 2], work[work.size() / 2]);
    // Files of this size are not read in that time. A hundred by the clock is wanted; on a busy machine the clock
    // runs on while the editor waits, so the work of all processors counts where it is less.
    QVERIFY(std::min(times.front(), work.front()) < 200);
  }

  void large_environment() {
    TestWindow window;
    window->show();
    QVERIFY(window.settle(most_ms));
    std::vector<double> firsts, sharps;
    for (int i = 0; i < 5; ++i) {
      const QString file = window.file(QStringLiteral("room %1.hdr").arg(i));
      write(file, radiance_room(1024, 512, 700 + i));
      const auto seen = [&] { return window->viewport().state().environment; };
      const auto before = seen();
      QElapsedTimer timer;
      timer.start();
      QVERIFY(drop(*window.window, {file}));
      firsts.push_back(until_drawn(window, timer, [&] { return seen() != before; }));
      const auto first = seen();
      sharps.push_back(until_drawn(window, timer, [&] { return seen() != first; }));
      QVERIFY(firsts.back() > 0);
      QVERIFY(sharps.back() > 0);
      QVERIFY(window.settle(most_ms));
    }
    std::sort(firsts.begin(), firsts.end());
    std::sort(sharps.begin(), sharps.end());
    qInfo("environment of 1024 x 512: first picture after %.0f ms least, %.0f median; sharp after %.0f, %.0f",
          firsts.front(), firsts[2], sharps.front(), sharps[2]);
    QVERIFY(firsts.front() < sharps.front());
  }

  void slider_drag_at_900_pixels() {
    TestWindow window;
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    window->viewport().setFixedSize(900, 900);
    window->show();
    QVERIFY(window.settle(most_ms));
    auto* slider = named<QSlider>(window->inspector(), QStringLiteral("Gloss, slider"));
    QVERIFY(slider != nullptr && slider->width() > 20);
    QSignalSpy drawn(&window->viewport(), &Viewport::frame_drawn);
    const int y = slider->height() / 2, least = 8, most = slider->width() - 8;
    QTest::mousePress(slider, Qt::LeftButton, {}, QPoint(least, y));
    drawn.clear();
    const double worked = since_start().work_ms;
    QElapsedTimer timer;
    timer.start();
    for (int i = 0; timer.elapsed() < 4000; ++i) {
      const int way = i % (2 * (most - least));
      const QPointF at(way < most - least ? least + way : 2 * most - least - way, y);
      QMouseEvent move(QEvent::MouseMove, at, slider->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
      QCoreApplication::sendEvent(slider, &move);
      QTest::qWait(4);
    }
    const double seconds = static_cast<double>(timer.elapsed()) * 1e-3, work = since_start().work_ms - worked;
    const auto pictures = static_cast<double>(drawn.count());
    QTest::mouseRelease(slider, Qt::LeftButton, {}, QPoint(most, y));
    qInfo("slider at %d x %d: %.1f pictures a second, %.1f ms of processors each", window->viewport().width(),
          window->viewport().height(), pictures / seconds, work / pictures);
    QVERIFY(pictures > 0);
  }

  void a_dropped_set_of_three_large_pictures() {
    TestWindow window;
    window->show();
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    QVERIFY(window.settle(most_ms));
    QStringList files;
    for (const char* name : {"wall_basecolor.png", "wall_orm.png", "wall_normal.png"}) {
      files << window.file(QLatin1String(name));
      save_texels(files.back(), 40 + 60 * static_cast<int>(files.size()));
    }
    // A user drops pictures onto a picture that has been refined.
    QVERIFY(QTest::qWaitFor([&] { return !window->viewport().is_refining(); }, most_ms));
    const auto textures = [&] { return window->viewport().state().a.textures; };
    QElapsedTimer timer;
    timer.start();
    double worked = since_start().work_ms;
    QVERIFY(drop(window->viewport(), files));
    DropTable* table = nullptr;
    QVERIFY(QTest::qWaitFor([&] { return (table = window->findChild<DropTable*>()) && table->isVisible(); },
                            most_ms));
    const auto asked = static_cast<double>(timer.elapsed());
    QTest::keyClick(table, Qt::Key_Return);
    const double shown = until_drawn(window, timer, [&] { return textures() != nullptr; });
    qint64 bytes = 0;
    for (const QString& file : files) bytes += QFileInfo(file).size();
    qInfo(
        "a set of three PNG of 4096 x 4096, %lld MB: table after %.0f ms, shown after %.0f, with %.0f of processors",
        static_cast<long long>(bytes >> 20), asked, shown, since_start().work_ms - worked);
    QVERIFY(shown > 0);
    QVERIFY(window.settle(most_ms));
    const auto before = textures();
    QVERIFY(QTest::qWaitFor([&] { return !window->viewport().is_refining(); }, most_ms));
    save_texels(files.front(), 140);
    timer.restart();
    worked = since_start().work_ms;
    const double again = until_drawn(window, timer, [&] { return textures() && textures() != before; });
    qInfo("one of them saved anew: shown after %.0f ms, with %.0f of processors", again,
          since_start().work_ms - worked);
    QVERIFY(again > 0);
  }

  void a_thousand_materials() {
    TestWindow window;
    show_active(window);
    QVERIFY(window.settle(most_ms));
    Project project;
    for (int i = 0; i < 1000; ++i) {
      ProjectMaterial m;
      m.name = "material " + std::to_string(i);
      m.diffuse = {0.001 * i, 0.4, 0.2};
      m.alpha_mode = AlphaMode::opaque;
      project.materials.push_back(m);
    }
    const QString file = window.file(QStringLiteral("many.json"));
    write(file, QByteArray::fromStdString(format_project(project, file.toStdString())));
    Stalls stalls;
    const auto tell = [&](const char* what) {
      QTest::qWait(300);
      qInfo("1,000 materials, %s: longest stall %.0f ms by the clock, %.0f of work", what, stalls.most_clock,
            stalls.most_work);
      stalls.forget();
    };
    QSignalSpy opened(window.window.get(), &Window::opened);
    window->open(file);
    QVERIFY(QTest::qWaitFor([&] { return opened.count() == 1; }, most_ms));
    tell("opened");
    QVERIFY(window.settle(most_ms));
    tell("checked and drawn");
    QListView& list = window->project_panel().list();
    for (int i = 0; i < 40; ++i) {
      QTest::keyClick(&list, i % 5 == 4 ? Qt::Key_PageDown : Qt::Key_Down);
      QTest::qWait(20);
    }
    tell("stepped through");
    for (int i = 0; i < 20; ++i) {
      window->document().change_material(QStringLiteral("gloss"), i + 1,
                                         [&](ProjectMaterial& m) { m.gloss = 0.2 + 0.03 * i; });
      QTest::qWait(20);
    }
    tell("one edited");
    QTest::keyClick(&list, Qt::Key_A, Qt::ControlModifier);
    tell("all marked");
    QVERIFY(window.settle(most_ms));
  }
};

ETAK_GUI_TEST(EditorTimes, "editor_times")
#include "bench_editor_times.moc"
