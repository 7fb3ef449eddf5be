// SPDX-License-Identifier: Apache-2.0
// A session as a user has it: search, pick, turn, edit, undo, compare, import, save, open again, pack,
// validate.
#include <QDir>
#include <QLineEdit>
#include <QListView>
#include <QProgressBar>
#include <QTreeView>

#include "app/editor/panels/findings_panel.h"
#include "app/editor/panels/inspector/inspector.h"
#include "app/editor/panels/library_panel.h"
#include "app/editor/panels/pack_dialog.h"
#include "app/editor/panels/project_panel.h"
#include "app/editor/panels/view_panel.h"
#include "app/fields/color_field.h"
#include "app/fields/number_field.h"
#include "core/color/srgb.h"
#include "tests/gui/editor_support.h"
#include "tests/gui/gui_test.h"

using namespace etak;
using namespace etak::editor;

class EditorSession : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { apply_theme(*qApp, Theme::dark); }

  void a_whole_session() {
    TestWindow window;
    QSignalSpy first_frame(window.window.get(), &Window::first_frame);
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window.window.get()));
    QVERIFY(QTest::qWaitFor([&] { return first_frame.count() > 0; }, 20000));

    // Search the library and add a material.
    LibraryPanel& library = window->library_panel();
    library.search().setFocus();
    QTest::keyClicks(&library.search(), QStringLiteral("gold"));
    const int found = library.list().model()->rowCount();
    QVERIFY2(found >= 1 && found < 12, qPrintable(QString::number(found)));
    int row = 0;
    while (library.list().model()->index(row, 0).data(LibraryModel::id_role).toString() !=
           QLatin1String("gold"))
      ++row;
    library.list().setCurrentIndex(library.list().model()->index(row, 0));
    QVERIFY(window->look().preview.has_value());
    QCOMPARE(window->document().project().materials.size(), std::size_t{0});
    library.list().setFocus();
    QTest::keyClick(&library.list(), Qt::Key_Return);
    QCOMPARE(window->document().project().materials.size(), std::size_t{1});
    QCOMPARE(window->document().material()->name, std::string("Gold"));
    QVERIFY(window->document().material()->specular.r > 1);

    // Orbit the camera.
    QTest::qWait(100);
    Viewport& viewport = window->viewport();
    const View before = window->look().camera;
    const QPoint middle = viewport.rect().center();
    drag(viewport, middle, middle + QPoint(60, 30));
    QVERIFY(!(window->look().camera == before));
    QCOMPARE(window->document().undo_stack().count(), 1);  // the camera is no change of the project

    // Edit the gloss by the wheel: several turns are one step of undo.
    FineSpinBox& gloss = window->inspector().gloss().box();
    const double gloss_before = window->document().material()->gloss;
    QApplication::setActiveWindow(window.window.get());
    gloss.setFocus();
    for (int i = 0; i < 3; ++i) turn_wheel(gloss, -1);
    turn_wheel(gloss, -1, Qt::ShiftModifier);
    QCOMPARE(window->document().undo_stack().count(), 2);
    QVERIFY(std::abs(window->document().material()->gloss - (gloss_before - 0.031)) < 1e-9);
    window->document().undo_stack().undo();
    QCOMPARE(window->document().material()->gloss, gloss_before);
    QCOMPARE(gloss.value(), gloss_before);
    window->document().undo_stack().redo();

    // Move a light by a drag with Shift, which is one step of undo.
    const int steps = window->document().undo_stack().count();
    drag(viewport, middle, middle + QPoint(-40, 25), Qt::ShiftModifier);
    QCOMPARE(window->document().undo_stack().count(), steps + 1);
    QVERIFY(!(window->document().project().view.lights == studio_lights()));

    // Compare A and B.
    emit window->view_panel().pin_asked();
    QVERIFY(window->document().project().view.compare.on);
    QVERIFY(window->document().project().view.compare.pinned.has_value());
    QVERIFY(window->use_library_material(QStringLiteral("copper")));
    QTest::qWait(200);
    QVERIFY(viewport.state().split);
    QVERIFY(viewport.state().a.surface.f0 != viewport.state().b.surface.f0);
    QTest::mouseMove(&viewport, middle);
    QTest::qWait(100);

    // Import a page.
    const QString page = window.file(QStringLiteral("my glass.yml"));
    write(page,
          "REFERENCES: |\n    A. Tester. Test data. J. Tests 1, 2 (2001)\nDATA:\n  - type: tabulated nk\n"
          "    data: |\n        0.3 1.6 0\n        0.5 1.55 0\n        0.9 1.5 0\n");
    QSignalSpy opened(window.window.get(), &Window::opened);
    window->import({page});
    QVERIFY(QTest::qWaitFor([&] { return opened.count() == 1; }, 20000));
    QCOMPARE(opened.back().front().toBool(), true);
    QCOMPARE(window->document().project().materials.size(), std::size_t{3});
    QCOMPARE(window->document().project().spectra.size(), std::size_t{1});
    QVERIFY(window->document().material()->measured.has_value());

    // Type a colour in hexadecimal: the material is then no longer measured.
    auto* hexadecimal = window->inspector().specular().findChild<QLineEdit*>({}, Qt::FindDirectChildrenOnly);
    QVERIFY(hexadecimal != nullptr);
    hexadecimal->setFocus();
    hexadecimal->selectAll();
    QTest::keyClicks(hexadecimal, QStringLiteral("#404040"));
    QTest::keyClick(hexadecimal, Qt::Key_Return);
    QCOMPARE(hex(srgb_u8(window->document().material()->specular)), std::string("#404040"));
    QVERIFY(!window->document().material()->measured.has_value());

    // Validate: a typed F0 in the forbidden zone gives a finding.
    hexadecimal->selectAll();
    QTest::keyClicks(hexadecimal, QStringLiteral("#909090"));
    QTest::keyClick(hexadecimal, Qt::Key_Return);
    QVERIFY(window.settle());
    const auto& findings = window->validator().findings();
    const auto zone = findings.find(window->document().material()->name);
    QVERIFY(zone != findings.end());
    QVERIFY(std::any_of(zone->second.begin(), zone->second.end(),
                        [](const Finding& f) { return f.rule == "ETK101"; }));
    QVERIFY(window->findings().model().rowCount() > 0);

    // Save the project and open it again.
    const Project saved_project = window->document().project();
    const QString file = window.file(QStringLiteral("session.json"));
    QSignalSpy saved(window.window.get(), &Window::saved);
    window->save_to(file);
    QVERIFY(QTest::qWaitFor([&] { return saved.count() == 1; }, 20000));
    QVERIFY(window->document().is_saved());
    window->document().replace({}, {}, true);
    window->open(file);
    QVERIFY(QTest::qWaitFor([&] { return opened.count() == 2; }, 20000));
    QVERIFY(window->document().project() == saved_project);

    // Pack.
    const QString atlas = window.file(QStringLiteral("atlas"));
    PackDialog* dialog = window->pack_to(atlas);
    QSignalSpy packed(dialog, &PackDialog::finished_packing);
    QVERIFY(QTest::qWaitFor([&] { return packed.count() == 1; }, 60000));
    QVERIFY2(packed.front().front().toBool(), qPrintable(dialog->result_text()));
    QVERIFY(QFile::exists(atlas + QStringLiteral("/layout.json")));
    dialog->reject();
    QVERIFY(window.settle());
  }

  void packing_that_is_cancelled_leaves_the_folder_as_it_was() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    const QString atlas = window.file(QStringLiteral("atlas"));
    PackDialog dialog(window->document().project(), window->document().library(), QStringLiteral("p"), atlas);
    QSignalSpy packed(&dialog, &PackDialog::finished_packing);
    dialog.start();
    dialog.reject();
    QVERIFY(QTest::qWaitFor([&] { return packed.count() == 1; }, 60000));
    if (!packed.front().front().toBool()) QVERIFY(!QFile::exists(atlas + QStringLiteral("/layout.json")));
  }
};

ETAK_GUI_TEST(EditorSession, "editor_session")
#include "test_editor_session.moc"
