// SPDX-License-Identifier: Apache-2.0
// Lists and the rest of the window under the hands of a user: what is marked, previewed, named, folded and told.
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QSettings>
#include <QTabWidget>
#include <QToolButton>

#include "app/editor/panels/inspector/inspector.h"
#include "app/editor/panels/preview_bar.h"
#include "app/editor/panels/project_panel.h"
#include "app/editor/panels/view_panel.h"
#include "app/fields/color_field.h"
#include "app/fields/number_field.h"
#include "tests/gui/editor_hands.h"
#include "tests/gui/gui_test.h"

using namespace etak;
using namespace etak::editor;

class EditorMarks : public QObject {
  Q_OBJECT

 private slots:
  void messages_stand_in_one_strip_that_leaves_the_focus_and_esc_closes() {
    TestWindow window(true);
    show_active(window);
    QListView& list = window->project_panel().list();
    list.setFocus();
    QSignalSpy opened(window.window.get(), &Window::opened);
    window->open(window.file(QStringLiteral("first.json")));
    window->open(window.file(QStringLiteral("second.json")));
    QVERIFY(QTest::qWaitFor([&] { return opened.count() == 2; }, 20000));
    const QString text = window->problems().text();
    QVERIFY2(text.contains(QLatin1String("first.json")) && text.contains(QLatin1String("second.json")) &&
                 text.count(QLatin1String("This could not be opened")) == 1,
             qPrintable(text));
    QVERIFY(window->problems().isVisible() && list.hasFocus() &&
            QApplication::activeModalWidget() == nullptr);
    QTest::keyClick(&list, Qt::Key_Escape);
    QVERIFY(!window->problems().isVisible());
  }

  void what_is_folded_stays_folded_in_the_next_run() {
    const QTemporaryDir folder;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder.path());
    QCoreApplication::setOrganizationName(QStringLiteral("etak-test"));
    WindowOptions options;
    options.cpu_viewport = true;
    options.data_folder = options.cache_folder = folder.path();
    for (const bool first : {true, false}) {
      Window window(options);
      QVERIFY(window.use_library_material(QStringLiteral("gold")));
      window.show();
      auto* fold = named<QToolButton>(window.inspector(),
                                      QStringLiteral("Show or hide what is to be said of the measurement"));
      QCOMPARE(fold->isChecked(), first);
      if (first) QTest::keyClick(fold, Qt::Key_Space);
      QVERIFY(!fold->isChecked());
      window.document().mark_saved(folder.filePath(QStringLiteral("p.json")));
      QVERIFY(window.close());
    }
    QSettings().clear();
  }

  void space_shows_side_b_where_no_field_takes_it() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    emit window->view_panel().pin_asked();
    QVERIFY(window->use_library_material(QStringLiteral("chromium")));
    show_active(window);
    window->setFocus();
    QTRY_VERIFY(!window->is_busy());
    const QImage a = window->viewport().grab_picture();
    QTest::keyPress(window.window.get(), Qt::Key_Space);
    const QImage b = window->viewport().grab_picture();
    QTest::keyRelease(window.window.get(), Qt::Key_Space);
    QVERIFY(a != b);
    QCOMPARE(window->viewport().grab_picture(), a);
  }

  void a_preview_is_marked_read_and_ended() {
    TestWindow window(true);
    window->resize(1280, 800);
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    show_active(window);
    LibraryPanel& library = window->library_panel();
    const Project before = window->document().project();
    const auto* bar = window->findChild<PreviewBar*>();
    QVERIFY(bar != nullptr && !bar->isVisible());
    // Neither the focus that comes by Tab nor a search starts a preview.
    library.list().setFocus(Qt::TabFocusReason);
    QVERIFY(!window->look().preview);
    library.search().setFocus();
    QTest::keyClicks(&library.search(), QStringLiteral("co"));
    library.search().clear();
    QVERIFY(!window->look().preview);

    click_row(library.list(), library_row(library, QStringLiteral("gold")));
    QVERIFY(window->look().preview);
    QVERIFY(bar->isVisible());
    const auto* text = named<QLabel>(*bar, QStringLiteral("What is looked at"));
    QVERIFY(text->text().contains(QLatin1String("Gold\nnot in the project")));
    // It covers neither the ball nor the name in the middle.
    const QRectF view = window->viewport().rect();
    const QPointF apart = view.center() - QPointF(bar->geometry().bottomRight());
    QVERIFY2(std::hypot(apart.x(), apart.y()) > std::min(view.width(), view.height()) / 2.2 && apart.x() > 90,
             qPrintable(QStringLiteral("%1 %2").arg(apart.x()).arg(apart.y())));
    // The inspector shows the numbers and the citation of the previewed material, which cannot be edited.
    QCOMPARE(named<QLineEdit>(window->inspector(), QStringLiteral("Name of the material"))->text(),
             QStringLiteral("Gold"));
    QVERIFY(window->inspector().specular().color().r > 1);
    QVERIFY(!window->inspector().specular().isEnabled());
    const auto* citation = named<QLabel>(window->inspector(), QStringLiteral("Citation"));
    QTRY_VERIFY(citation->text().contains(QLatin1String("Johnson")) || citation->text().size() > 20);
    QVERIFY(citation->isEnabled() && citation->isVisible());
    QVERIFY(window->document().project() == before);

    QTest::keyClick(&library.list(), Qt::Key_Escape);
    QVERIFY(!window->look().preview && !bar->isVisible());
    QVERIFY(window->inspector().specular().isEnabled());
    QCOMPARE(named<QLineEdit>(window->inspector(), QStringLiteral("Name of the material"))->text(),
             QString::fromStdString(window->document().material()->name));

    // A click on the same row starts the preview again; a click on the current row of the project ends it.
    click_row(library.list(), library_row(library, QStringLiteral("gold")));
    QVERIFY(window->look().preview);
    QListView& project = window->project_panel().list();
    click_row(project, project.model()->index(0, 0));
    QVERIFY(!window->look().preview);

    // Add puts the previewed material into the project.
    click_row(library.list(), library_row(library, QStringLiteral("gold")));
    QTest::mouseClick(
        named<QToolButton>(*bar, QStringLiteral("Add the material that is looked at to the project")),
        Qt::LeftButton);
    QVERIFY(!window->look().preview && !bar->isVisible());
    QCOMPARE(window->document().material()->name, std::string("Gold"));
  }

  void the_selection_never_grows_by_itself() {
    TestWindow window(true);
    show_active(window);
    QListView& list = window->project_panel().list();
    list.setFocus();
    for (std::size_t count = 1; count <= 4; ++count) {
      QTest::keyClick(window.window.get(), Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
      QCOMPARE(window->document().project().materials.size(), count);
      QCOMPARE(window->project_panel().selected(), std::vector<int>{static_cast<int>(count) - 1});
    }
    QTest::keyClick(window.window.get(), Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(window->project_panel().selected(), std::vector<int>{4});
  }

  void del_copy_and_edits_act_on_what_is_marked() {
    TestWindow window(true);
    for (const char* id : {"gold", "copper", "silver", "brick", "water"})
      QVERIFY(window->use_library_material(QLatin1String(id)));
    show_active(window);
    const Project before = window->document().project();
    QListView& list = window->project_panel().list();
    const auto* note = named<QLabel>(window->project_panel(), QStringLiteral("Marked materials"));
    QVERIFY(note != nullptr);
    const auto mark_three = [&] {
      click_row(list, list.model()->index(0, 0));
      QVERIFY(!note->isVisible());
      click_row(list, list.model()->index(3, 0), Qt::ControlModifier);
      click_row(list, list.model()->index(1, 0), Qt::ControlModifier);
      QCOMPARE(window->project_panel().selected(), (std::vector<int>{0, 1, 3}));
      QVERIFY(note->isVisible() && note->text().startsWith(QLatin1String("3 marked")));
    };
    mark_three();
    list.setFocus();
    QTest::keyClick(&list, Qt::Key_Delete);
    QCOMPARE(window->document().project().materials,
             (std::vector<ProjectMaterial>{before.materials[2], before.materials[4]}));
    QVERIFY(window->document().current() >= 0 && window->document().current() < 2);
    QTest::keyClick(&list, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(window->document().project() == before);

    mark_three();
    QTest::keyClick(&list, Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(window->document().project().materials.size(), std::size_t{8});
    QVERIFY(window->document().project().materials[7].measured == before.materials[3].measured);
    QTest::keyClick(&list, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(window->document().project() == before);

    mark_three();
    FineSpinBox& gloss = window->inspector().gloss().box();
    gloss.setFocus();
    gloss.selectAll();
    QTest::keyClicks(&gloss, QStringLiteral("0.42"));
    QTest::keyClick(&gloss, Qt::Key_Return);
    for (const std::size_t row : {0u, 1u, 3u})
      QCOMPARE(double{window->document().project().materials[row].gloss}, 0.42);
    QCOMPARE(window->project_panel().selected(), (std::vector<int>{0, 1, 3}));
    for (const std::size_t row : {2u, 4u})
      QVERIFY(window->document().project().materials[row] == before.materials[row]);
    // Each gets its own measurement back, not that of the material that is shown.
    auto* red = named<FineSpinBox>(window->inspector(), QStringLiteral("Specular, red, linear"));
    red->setFocus();
    red->selectAll();
    QTest::keyClicks(red, QStringLiteral("0.6"));
    QTest::keyClick(red, Qt::Key_Return);
    QVERIFY(!window->document().project().materials[0].measured);
    QTest::mouseClick(named<QToolButton>(window->inspector(), QStringLiteral("Reset Specular")),
                      Qt::LeftButton);
    for (const std::size_t row : {0u, 1u})
      QVERIFY(window->document().project().materials[row].specular == before.materials[row].specular);
    for (int i = 0; i < 3; ++i) QTest::keyClick(&list, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(window->document().project() == before);
    // A drag of the slider over three materials is one step of undo.
    mark_three();
    const int steps = steps_of(window);
    FieldSlider& slider = window->inspector().gloss().slider();
    drag(slider, QPoint(slider.width() / 2, slider.height() / 2),
         QPoint(slider.width() / 4, slider.height() / 2));
    QCOMPARE(steps_of(window), steps + 1);
    QCOMPARE(double{window->document().project().materials[0].gloss},
             double{window->document().project().materials[3].gloss});
  }

  void sentences_go_when_they_are_true_no_more() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    show_active(window);
    LibraryPanel& library = window->library_panel();
    click_row(library.list(), library_row(library, QStringLiteral("gold")));
    QVERIFY2(told(window).contains(QLatin1String("Esc ends the preview")), qPrintable(told(window)));
    QTest::keyClick(&library.list(), Qt::Key_Return);
    QCOMPARE(window->document().material()->name, std::string("Gold"));
    QVERIFY2(!told(window).contains(QLatin1String("preview")), qPrintable(told(window)));

    auto* red = named<FineSpinBox>(window->inspector(), QStringLiteral("Specular, red, linear"));
    red->setFocus();
    red->selectAll();
    QTest::keyClicks(red, QStringLiteral("0.5"));
    QTest::keyClick(red, Qt::Key_Return);
    QVERIFY2(told(window).contains(QLatin1String("measured no longer")), qPrintable(told(window)));
    QTest::keyClick(red, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(window->document().material()->measured);
    QVERIFY2(told(window).isEmpty(), qPrintable(told(window)));
  }

  void arrow_keys_change_the_material_from_viewport_and_list_alone() {
    TestWindow window(true);
    for (const char* id : {"gold", "copper", "silver"})
      QVERIFY(window->use_library_material(QLatin1String(id)));
    show_active(window);
    window->inspector_tabs().setCurrentIndex(0);
    auto* reset = named<QToolButton>(window->inspector(), QStringLiteral("Reset Gloss"));
    QVERIFY(reset != nullptr);
    reset->setFocus();
    QTest::keyClick(reset, Qt::Key_Down);
    QTest::keyClick(reset, Qt::Key_Right);
    QCOMPARE(window->document().current(), 2);
    window->viewport().setFocus();
    QTest::keyClick(&window->viewport(), Qt::Key_Right);
    QCOMPARE(window->document().current(), 0);
  }

  void a_name_is_edited_by_f2_or_a_double_click_only() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    show_active(window);
    QListView& list = window->project_panel().list();
    const QModelIndex row = list.model()->index(0, 0);
    const auto editor = [&] { return list.viewport()->findChild<QLineEdit*>(); };
    click_row(list, row);
    QTest::qWait(QApplication::doubleClickInterval() + 100);
    click_row(list, row);
    QTest::qWait(QApplication::doubleClickInterval() + 100);
    QVERIFY(editor() == nullptr);
    QTest::keyClick(&list, Qt::Key_F2);
    QVERIFY(editor() != nullptr);
    QTest::keyClick(editor(), Qt::Key_Escape);
    QTRY_VERIFY(editor() == nullptr);
    QTest::mouseDClick(list.viewport(), Qt::LeftButton, {}, list.visualRect(row).center());
    QVERIFY(editor() != nullptr);
    editor()->selectAll();
    QTest::keyClicks(editor(), QStringLiteral("Dore"));
    QTest::keyClick(editor(), Qt::Key_Return);
    QTRY_COMPARE(QString::fromStdString(window->document().material()->name), QStringLiteral("Dore"));
  }

  void a_typed_f0_is_asked_for_its_material_which_becomes_the_record() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    show_active(window);
    ColorField& field = window->inspector().specular();
    QLineEdit* hexadecimal = nullptr;
    for (auto* each : field.findChildren<QLineEdit*>())
      if (each->accessibleName().endsWith(QLatin1String(", hexadecimal"))) hexadecimal = each;
    QVERIFY(hexadecimal != nullptr);
    hexadecimal->setFocus();
    hexadecimal->selectAll();
    QTest::keyClicks(hexadecimal, QStringLiteral("#ffe49c"));
    QTest::keyClick(hexadecimal, Qt::Key_Return);
    QVERIFY(!window->document().material()->measured);
    auto* ask =
        named<QToolButton>(field, QStringLiteral("What is this? Which measured materials have this F0"));
    QVERIFY(ask != nullptr);
    QTest::keyClick(ask, Qt::Key_Space);
    const auto menu = [&] {
      for (QMenu* each : window->findChildren<QMenu*>())
        if (each->accessibleName() == QLatin1String("What this could be")) return each;
      return static_cast<QMenu*>(nullptr);
    };
    QTRY_VERIFY_WITH_TIMEOUT(menu() != nullptr, 60000);
    const QList<QAction*> rows = menu()->actions();
    QVERIFY(rows.size() > 2 && !rows[0]->isEnabled());
    QVERIFY2(rows[1]->text().startsWith(QLatin1String("Gold")), qPrintable(rows[1]->text()));
    QCOMPARE(rows[1]->data().toString(), QStringLiteral("gold"));
    QTest::keyClick(menu(), Qt::Key_Down);
    QTest::keyClick(menu(), Qt::Key_Return);
    QTRY_VERIFY(window->document().material()->measured);
    QCOMPARE(window->document().material()->measured->material, std::string("gold"));
    window->document().undo_stack().undo();
    QVERIFY(!window->document().material()->measured);
  }

  void a_slider_that_is_dragged_thins_the_pictures() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    show_active(window);
    QVERIFY(window.settle());
    FieldSlider& slider = window->inspector().gloss().slider();
    const QPoint from(slider.width() / 2, slider.height() / 2), to(slider.width() / 4, slider.height() / 2);
    QTest::mousePress(&slider, Qt::LeftButton, {}, from);
    QMouseEvent move(QEvent::MouseMove, to, slider.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&slider, &move);
    QTRY_VERIFY(window->viewport().is_hurried());
    QTest::mouseRelease(&slider, Qt::LeftButton, {}, to);
    QVERIFY(!window->viewport().is_hurried());
    QVERIFY(window.settle());
  }
};

ETAK_GUI_TEST(EditorMarks, "editor_marks")
#include "test_editor_marks.moc"
