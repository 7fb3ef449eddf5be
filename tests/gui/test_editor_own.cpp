// SPDX-License-Identifier: Apache-2.0
// Materials across windows and projects: copied and pasted, kept as the user's own, favourites; search and order in the
// project's list; the look around has undo of its own, and typed paths are looked at.
#include <QClipboard>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>

#include "app/document/own_materials.h"
#include "app/editor/panels/inspector/inspector.h"
#include "app/editor/panels/library_panel.h"
#include "app/editor/panels/project_panel.h"
#include "tests/gui/editor_hands.h"
#include "tests/gui/gui_test.h"

using namespace etak;
using namespace etak::editor;

namespace {

QStringList names_in_list(TestWindow& window) {
  QStringList out;
  const QAbstractItemModel& rows = *window->project_panel().list().model();
  for (int row = 0; row < rows.rowCount(); ++row) out << rows.index(row, 0).data().toString();
  return out;
}

void add_named(TestWindow& window, const QStringList& names) {
  for (const QString& name : names) {
    ProjectMaterial m;
    m.name = name.toStdString();
    m.diffuse = {0.2, 0.3, 0.4};
    window->document().add({m}, {}, QStringLiteral("add"));
  }
}

}  // namespace

class EditorOwn : public QObject {
  Q_OBJECT

 private slots:
  void materials_are_copied_from_one_window_into_another_with_their_spectra() {
    TestWindow from(true), to(true);
    show_active(from);
    write(from.file(QStringLiteral("glass.yml")), glass_page);
    from->import({from.file(QStringLiteral("glass.yml"))});
    QVERIFY(from.settle());
    QVERIFY(from->use_library_material(QStringLiteral("gold")));
    from->project_panel().list().selectAll();
    from->project_panel().list().setFocus();
    QTest::keyClick(&from->project_panel().list(), Qt::Key_C, Qt::ControlModifier);
    show_active(to);
    to->project_panel().list().setFocus();
    QTest::keyClick(&to->project_panel().list(), Qt::Key_V, Qt::ControlModifier);
    const Project &a = from->document().project(), &b = to->document().project();
    QCOMPARE(b.materials.size(), std::size_t{2});
    QVERIFY(b.materials == a.materials);
    QVERIFY(b.spectra == a.spectra);
    to->document().undo_stack().undo();
    QVERIFY(to->document().project().materials.empty());
    // What holds no materials is told and changes nothing.
    QApplication::clipboard()->setText(QStringLiteral("no project"));
    QTest::keyClick(&to->project_panel().list(), Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(told(to), QStringLiteral("The clipboard holds no materials"));
    QApplication::clipboard()->setText(QStringLiteral("{\"schema\": \"etak-project/1\", \"materials\": 3}"));
    QTest::keyClick(&to->project_panel().list(), Qt::Key_V, Qt::ControlModifier);
    QVERIFY(shown_message(to).contains(QStringLiteral("clipboard#/")));
    QVERIFY(to->document().project().materials.empty());
  }

  void own_materials_and_favourites_are_there_in_the_next_project() {
    QTemporaryDir folder;
    WindowOptions options;
    options.cpu_viewport = true;
    options.remember = false;
    options.data_folder = options.cache_folder = folder.path();
    {
      Window window(options);
      ProjectMaterial m;
      m.name = "50% grey / \xc3\xa4";
      m.specular = {0.05, 0.05, 0.05};
      window.document().add({m}, {}, QStringLiteral("add"));
      action_named(window, QStringLiteral("Keep as my materials"))->trigger();
      LibraryPanel& library = window.library_panel();
      library.list().setCurrentIndex(library_row(library, QStringLiteral("copper")));
      QTest::mouseClick(named<QToolButton>(library, QStringLiteral("Favourite")), Qt::LeftButton);
    }
    QCOMPARE(own_materials(folder.path()), QStringList{QString::fromUtf8("50% grey / \xc3\xa4")});
    Window next(options);
    auto* menu = qobject_cast<QMenu*>(named<QMenu>(next, QStringLiteral("Add one of mine")));
    QVERIFY(menu != nullptr);
    emit menu->aboutToShow();
    QCOMPARE(menu->actions().size(), 1);
    menu->actions().front()->trigger();
    QVERIFY(QTest::qWaitFor([&] { return next.document().project().materials.size() == 1; }, 20000));
    QCOMPARE(next.document().project().materials[0].specular, (LinearRgb{0.05, 0.05, 0.05}));
    auto* only = named<QToolButton>(next.library_panel(), QStringLiteral("Favourites only"));
    only->click();
    QCOMPARE(next.library_panel().list().model()->rowCount(), 1);
    QVERIFY(library_row(next.library_panel(), QStringLiteral("copper")).isValid());
    only->click();
    QVERIFY(next.library_panel().list().model()->rowCount() > 100);
    QVERIFY(QTest::qWaitFor([&] { return !next.is_busy() && next.validator().is_idle(); }, 60000));
  }

  void the_project_is_searched_and_shown_by_name_and_stays_as_it_is() {
    TestWindow window(true);
    show_active(window);
    add_named(window, {QStringLiteral("wood"), QStringLiteral("Steel"), QStringLiteral("brass"),
                       QStringLiteral("old wood")});
    const Project before = window->document().project();
    auto* sort = named<QToolButton>(window->project_panel(), QStringLiteral("Sort by name"));
    sort->click();
    QCOMPARE(names_in_list(window), (QStringList{QStringLiteral("brass"), QStringLiteral("old wood"),
                                                 QStringLiteral("Steel"), QStringLiteral("wood")}));
    QTest::keyClicks(&window->project_panel().search(), QStringLiteral("WOOD"));
    QCOMPARE(names_in_list(window), (QStringList{QStringLiteral("old wood"), QStringLiteral("wood")}));
    QVERIFY(window->document().project() == before);
    QCOMPARE(window->document().material()->name, std::string("old wood"));
    // Rows of the list are those of the project, wherever they stand: Del removes the one that is marked.
    QListView& list = window->project_panel().list();
    click_row(list, list.model()->index(1, 0));
    QCOMPARE(window->document().material()->name, std::string("wood"));
    QTest::keyClick(&list, Qt::Key_Delete);
    QCOMPARE(window->document().project().materials.size(), std::size_t{3});
    QCOMPARE(window->document().project().materials[0].name, std::string("Steel"));
    // A current material that the search hides is not removed by a key.
    window->document().set_current(0);
    QTest::keyClick(&list, Qt::Key_Delete);
    QCOMPARE(window->document().project().materials.size(), std::size_t{3});
    window->project_panel().search().clear();
    sort->click();
    QCOMPARE(names_in_list(window),
             (QStringList{QStringLiteral("Steel"), QStringLiteral("brass"), QStringLiteral("old wood")}));
    QVERIFY(window.settle());
  }

  void undo_of_a_material_leaves_the_look_and_the_look_has_keys_of_its_own() {
    TestWindow window(true);
    show_active(window);
    add_named(window, {QStringLiteral("wood")});
    Document& document = window->document();
    document.change_view(QStringLiteral("exposure"), 1, [](ProjectView& v) { v.exposure = 2; });
    document.change_material(QStringLiteral("gloss"), 2, [](ProjectMaterial& m) { m.gloss = 0.2; });
    document.change_view(QStringLiteral("compare"), 3, [](ProjectView& v) { v.compare.on = true; });
    QVERIFY(!document.is_saved());
    QTest::keyClick(window.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(double{document.material()->gloss}, 0.75);
    QVERIFY(document.project().view.compare.on);
    QCOMPARE(document.project().view.exposure, 2.0);
    const auto look_key = [&](Qt::Key key) {
      QTest::keyClick(window.window.get(), key, Qt::ControlModifier | Qt::AltModifier);
    };
    look_key(Qt::Key_Z);
    QVERIFY(!document.project().view.compare.on);
    look_key(Qt::Key_Z);
    QCOMPARE(document.project().view.exposure, new_project().view.exposure);
    look_key(Qt::Key_Y);
    QCOMPARE(document.project().view.exposure, 2.0);
    // A light is an edit; taking it back leaves the look that was chosen after it.
    document.change_view(QStringLiteral("turn"), 4, [](ProjectView& v) { v.environment_turn_deg = 40; });
    document.change_view(QStringLiteral("exposure"), 5, [](ProjectView& v) { v.exposure = 3; });
    QTest::keyClick(window.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(document.project().view.environment_turn_deg, 0.0);
    QCOMPARE(document.project().view.exposure, 3.0);
    QVERIFY(window.settle());
  }

  void a_typed_path_is_looked_at_before_it_is_taken() {
    TestWindow window(true);
    show_active(window);
    add_named(window, {QStringLiteral("wood")});
    auto* line = named<QLineEdit>(window->inspector(), QStringLiteral("Diffuse texture, file"));
    const auto type = [&](const QString& path) {
      line->setFocus();
      line->selectAll();
      QTest::keyClicks(line, path);
      QTest::keyClick(line, Qt::Key_Return);
      QVERIFY(window.settle());
    };
    type(window.file(QStringLiteral("gone.png")));
    QVERIFY(shown_message(window).contains(QStringLiteral("gone.png")));
    QVERIFY(!window->document().material()->texture(Channel::diffuse));
    QVERIFY(line->text().isEmpty());
    const QString good = grey_picture(window, QStringLiteral("good.png"));
    type(good);
    QCOMPARE(window->document().material()->texture(Channel::diffuse)->path, good.toStdString());
    write(window.file(QStringLiteral("broken.png")), bytes_of(good).left(40));
    type(window.file(QStringLiteral("broken.png")));
    QVERIFY(shown_message(window).contains(QStringLiteral("broken.png")));
    QCOMPARE(line->text(), good);
  }
};

ETAK_GUI_TEST(EditorOwn, "editor_own")
#include "test_editor_own.moc"
