// SPDX-License-Identifier: Apache-2.0
// The user-interface thread never works for more than 50 ms without answering, whatever the user does.
#include <QListView>
#include <QPlainTextEdit>
#include <QTabWidget>
#include <algorithm>

#include "app/document/files.h"
#include "app/document/press_id.h"
#include "app/editor/panels/findings_panel.h"
#include "app/editor/panels/inspector/inspector.h"
#include "app/editor/panels/library_panel.h"
#include "app/editor/panels/pack_dialog.h"
#include "app/editor/panels/project_panel.h"
#include "app/editor/panels/view_panel.h"
#include "app/fields/number_field.h"
#include "core/base/files/file.h"
#include "tests/gui/editor_support.h"
#include "tests/gui/gui_test.h"
#include "tests/gui/watchdog.h"

using namespace etak;
using namespace etak::editor;

namespace {

constexpr int patience_ms = 120000;

}  // namespace

class EditorWatch : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<TestWindow> window;

  Window& w() { return **window; }

  bool settle() {
    return QTest::qWaitFor(
        [this] { return !w().is_busy() && w().validator().is_idle() && w().thumbnails().is_idle(); },
        patience_ms);
  }

  void edit(const std::function<void(ProjectMaterial&)>& change) {
    w().document().change_material(QStringLiteral("edit"), next_press_id(), change);
  }

  // Calls `act` and waits for its end, while the event loop is watched.
  void watch(const char* what, const std::function<void()>& act) {
    Watchdog watchdog;
    act();
    const bool settled = settle();
    watchdog.stop();
    qInfo("%s: %.1f ms of work at once, held for %.1f ms at most", what, watchdog.work_ms(),
          watchdog.held_ms());
    QVERIFY2(settled, what);
    QVERIFY2(watchdog.work_ms() <= most_work_ms(),
             qPrintable(QStringLiteral("%1: %2 ms").arg(QLatin1String(what)).arg(watchdog.work_ms())));
  }

 private slots:
  void initTestCase() {
    apply_theme(*qApp, Theme::dark);
    window = std::make_unique<TestWindow>();
    QSignalSpy first_frame(&w(), &Window::first_frame);
    w().show();
    QVERIFY(QTest::qWaitForWindowExposed(&w()));
    QVERIFY(QTest::qWaitFor([&] { return first_frame.count() > 0; }, patience_ms));
    qInfo("drawn by %s",
          qPrintable(w().viewport().uses_gl() ? w().viewport().gl_name() : w().viewport().fallback_reason()));
    QVERIFY(w().use_library_material(QStringLiteral("gold")));
  }

  void cleanupTestCase() { window.reset(); }

  void thumbnails_of_the_whole_library() {
    watch("thumbnails", [this] {
      QListView& list = w().library_panel().list();
      for (int row = 0; row < list.model()->rowCount(); row += 4) {
        list.scrollTo(list.model()->index(row, 0));
        QTest::qWait(5);
      }
    });
  }

  // The shaders of these models have not been compiled before.
  void every_model() {
    watch("models", [this] {
      for (const Model& model : models()) {
        edit([&](ProjectMaterial& m) {
          (model.kind == ModelKind::diffuse ? m.diffuse_model : m.specular_model) = std::string(model.id);
        });
        QTest::qWait(10);
        QVERIFY(QTest::qWaitFor([this] { return !w().viewport().is_drawing(); }, patience_ms));
      }
    });
  }

  void the_same_with_the_shaders_text_shown() {
    w().tabs().setCurrentWidget(w().tabs().findChild<QPlainTextEdit*>());
    w().document().change_view(QStringLiteral("compare"), next_press_id(), [this](ProjectView& view) {
      view.compare = {true, *w().document().material(), {}};
    });
    watch("models beside their text", [this] {
      for (const char* id : {"ggx-f82", "schueler-optimized-bounded", "cook-torrance", "ggx-schlick"}) {
        if (find_model(id) != nullptr) edit([&](ProjectMaterial& m) { m.specular_model = id; });
        QTest::qWait(50);
      }
    });
    w().tabs().setCurrentIndex(0);
  }

  void drags_in_the_viewport() {
    watch("drags", [this] {
      const QPoint middle = w().viewport().rect().center();
      drag(w().viewport(), middle, middle + QPoint(80, 40));
      drag(w().viewport(), middle, middle + QPoint(-60, 20), Qt::ShiftModifier);
      drag(w().viewport(), middle, middle + QPoint(30, 0), Qt::ControlModifier);
    });
  }

  void gloss_by_wheel() {
    watch("gloss", [this] {
      for (int i = 0; i < 20; ++i) {
        turn_wheel(w().inspector().gloss().box(), i < 10 ? -1 : 1);
        QTest::qWait(5);
      }
    });
  }

  void an_environment() {
    watch("environment", [this] {
      w().document().change_view(QStringLiteral("environment"), next_press_id(),
                                 [](ProjectView& view) { view.lights.environment = "overcast"; });
      QTest::qWait(50);
    });
  }

  void spectra_are_imported() {
    QStringList pages;
    for (int i = 0; i < 20; ++i) {
      std::string text =
          "REFERENCES: |\n    A. Tester. Test data. J. Tests 1, 2 (2001)\nDATA:\n"
          "  - type: tabulated nk\n    data: |\n";
      for (int row = 0; row < 2000; ++row)
        text +=
            "        " + std::to_string(0.3 + 0.0003 * row) + " " + std::to_string(1.3 + 0.01 * i) + " 0\n";
      pages << window->file(QStringLiteral("page %1.yml").arg(i));
      write_file(pages.back().toStdString(), text, true);
    }
    QSignalSpy opened(&w(), &Window::opened);
    watch("import", [&] {
      w().import(pages);
      QVERIFY(QTest::qWaitFor([&] { return opened.count() == 1; }, patience_ms));
    });
    QCOMPARE(opened.front().front().toBool(), true);
    QCOMPARE(w().document().project().spectra.size(), std::size_t{20});
  }

  void all_of_it_is_validated() {
    watch("validate", [this] {
      for (int i = 0; i < 20; ++i) {
        w().document().set_current(i);
        edit([&](ProjectMaterial& m) {
          m.measured.reset();
          m.specular = {0.3, 0.3, 0.3};
        });
        QTest::qWait(2);
      }
    });
    QVERIFY(w().findings().model().rowCount() > 0);
  }

  void saved_and_opened() {
    const QString file = window->file(QStringLiteral("project.json"));
    QSignalSpy saved(&w(), &Window::saved), opened(&w(), &Window::opened);
    watch("save and open", [&] {
      w().save_to(file);
      QVERIFY(QTest::qWaitFor([&] { return saved.count() == 1; }, patience_ms));
      w().open(file);
      QVERIFY(QTest::qWaitFor([&] { return opened.count() == 1; }, patience_ms));
    });
  }

  void the_atlas_is_packed() {
    watch("pack", [this] {
      PackDialog* dialog = w().pack_to(window->file(QStringLiteral("atlas")));
      QSignalSpy packed(dialog, &PackDialog::finished_packing);
      QVERIFY(QTest::qWaitFor([&] { return packed.count() == 1; }, patience_ms));
      QVERIFY2(packed.front().front().toBool(), qPrintable(dialog->result_text()));
      dialog->reject();
    });
  }
};

ETAK_GUI_TEST(EditorWatch, "editor_watch")
#include "test_editor_watch.moc"
