// SPDX-License-Identifier: Apache-2.0
// Files that the window reads and writes: the question before changes are lost, pipes, recent files, and the
// settings that are kept from run to run.
#include <sys/stat.h>
#include <unistd.h>
#include <QAction>
#include <QDockWidget>
#include <QFileDialog>
#include <QMenu>
#include <QMessageBox>
#include <QSettings>
#include <thread>

#include "app/document/files.h"
#include "app/document/press_id.h"
#include "core/material/json.h"
#include "tests/gui/editor_hands.h"
#include "tests/gui/gui_test.h"

using namespace etak;
using namespace etak::editor;

class EditorFiles : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    QApplication::setQuitOnLastWindowClosed(false);
  }

  void closing_with_changes_asks_and_does_what_is_answered() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    window->show();
    answer(QMessageBox::Cancel);
    QVERIFY(!window->close());
    QVERIFY(window->isVisible() && window->document().material() != nullptr);

    // With Save but no name chosen, the window stays open.
    answer(QMessageBox::Save);
    when_asked<QFileDialog>([](QFileDialog& dialog) { dialog.reject(); });
    QVERIFY(!window->close());

    const QString file = window.file(QStringLiteral("p.json"));
    answer(QMessageBox::Save);
    choose_file(file);
    QVERIFY(window->close());
    const Opened opened = open_project(file, MaterialLibrary::builtin());
    QVERIFY2(opened.error.isEmpty(), qPrintable(opened.error));
    QCOMPARE(opened.project.materials.size(), std::size_t{1});

    // For a saved project there is no question. Discarding changes leaves the file as it was.
    window->show();
    QVERIFY(window->close());
    window->show();
    ProjectMaterial m = *window->document().material();
    m.gloss = 0.1;
    window->document().edit(0, m, QStringLiteral("gloss"), next_press_id());
    const QByteArray before = bytes_of(file);
    answer(QMessageBox::Discard);
    QVERIFY(window->close());
    QCOMPARE(bytes_of(file), before);
  }

  void a_new_project_asks_too() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    answer(QMessageBox::Cancel);
    action_named(*window, QStringLiteral("New project"))->trigger();
    QCOMPARE(window->document().project().materials.size(), std::size_t{1});
    answer(QMessageBox::Discard);
    action_named(*window, QStringLiteral("New project"))->trigger();
    QVERIFY(window->document().project().materials.empty());
    QVERIFY(window->document().is_saved());
  }

  void saving_where_nothing_can_be_written_keeps_the_window_open() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    window->show();
    // No user can write there, not even root.
    window->document().mark_saved(QStringLiteral("/proc/project.json"));
    window->document().remove({0});
    answer(QMessageBox::Save);
    QVERIFY(!window->close());
    QVERIFY(shown_message(window).contains(QLatin1String("not saved")));
    QVERIFY(!window->document().is_saved());
  }

  void a_comparison_and_a_wedge_come_back_with_the_project() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    action_named(*window, QStringLiteral("Pin as B"))->trigger();
    QVERIFY(window->use_library_material(QStringLiteral("copper")));
    Comparison compare = window->document().project().view.compare;
    QVERIFY(compare.on && compare.pinned && compare.pinned->name == "Gold");
    compare.model = "ggx-f82";
    window->document().change_view(QStringLiteral("model of B, wedge"), next_press_id(),
                                   [&](ProjectView& view) {
                                     view.compare = compare;
                                     view.wedge = {true, "gloss", 5};
                                   });
    const QString file = window.file(QStringLiteral("p.json"));
    QSignalSpy saved(window.window.get(), &Window::saved);
    window->save_to(file);
    QVERIFY(QTest::qWaitFor([&] { return saved.count() == 1; }, 20000));
    const ProjectView view = window->document().project().view;

    TestWindow other(true);
    QSignalSpy opened(other.window.get(), &Window::opened);
    other->open(file);
    QVERIFY(QTest::qWaitFor([&] { return opened.count() == 1; }, 20000));
    QVERIFY(other->document().project().view == view);
    QVERIFY(QTest::qWaitFor([&] { return other->viewport().state().split; }, 5000));
    QCOMPARE(other->viewport().state().b.label, std::string("B: Gold, GGX, F82, Smith height-correlated"));
    QVERIFY(other->viewport().state().shape == ViewShape::wedge);
    QCOMPARE(other->viewport().state().wedge_steps, 5);
    other->document().change_view(QStringLiteral("compare"), next_press_id(),
                                  [](ProjectView& v) { v.compare = {}; });
    other->document().view_stack().undo();
    QVERIFY(other->document().project().view.compare == compare);
  }

  void a_project_or_material_is_opened_from_a_pipe_and_is_not_saved_yet() {
    // A pipe as the <(...) of a shell makes it.
    const auto pipe_of = [](const QByteArray& bytes) {
      int ends[2] = {-1, -1};
      if (::pipe(ends) != 0) return QString();
      const bool whole =
          ::write(ends[1], bytes.constData(), static_cast<size_t>(bytes.size())) == bytes.size();
      ::close(ends[1]);
      return whole ? QStringLiteral("/dev/fd/%1").arg(ends[0]) : QString();
    };
    TestWindow window(true);
    const auto open = [&](const QString& typed) {
      QSignalSpy opened(window.window.get(), &Window::opened);
      window->open(accept_named(typed));
      return QTest::qWaitFor([&] { return opened.count() == 1; }, 20000) && opened.front().front().toBool();
    };
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    const QString file = window.file(QStringLiteral("p.json"));
    QVERIFY(save_project(window->document().project(), file).isEmpty());
    const Project before = window->document().project();
    QVERIFY(open(pipe_of(bytes_of(file))));
    QVERIFY(window->document().project() == before);
    QVERIFY(window->document().path().isEmpty() && !window->document().is_saved());

    const QString named = window.file(QStringLiteral("pipe"));
    QCOMPARE(::mkfifo(qPrintable(named), 0600), 0);
    const Material copper = *MaterialLibrary::builtin().find("copper");
    std::thread writer([&] { write(named, QByteArray::fromStdString(format_material(copper))); });
    QVERIFY(open(named));
    writer.join();
    QVERIFY(window->document().path().isEmpty());
    QCOMPARE(window->document().material()->name, std::string("Copper"));

    // For a file that is no project, the message tells its kind, and the present project stays.
    QVERIFY(!open(pipe_of(R"({"asset": {"version": "2.0"}, "meshes": []})")));
    QVERIFY(shown_message(window).contains(
        QLatin1String("holds a glTF scene; expected a project or a material")));
    QVERIFY(!open(pipe_of("nm,n,k\n400,1,0\n700,1,0\n")));
    QVERIFY(shown_message(window).contains(QLatin1String("holds a page or a table")));
    QVERIFY(!open(QStringLiteral("/dev/zero")));
    QVERIFY(shown_message(window).contains(
        QLatin1String("/dev/zero: is a device; expected a regular file, a pipe")));
    QCOMPARE(window->document().material()->name, std::string("Copper"));
  }

  void recent_files_the_layout_and_the_theme_are_remembered() {
    QTemporaryDir settings;
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
    QCoreApplication::setOrganizationName(QStringLiteral("etak test"));
    const auto made = [&] {
      WindowOptions options;
      options.cpu_viewport = true;
      options.data_folder = options.cache_folder = settings.path();
      return std::make_unique<Window>(options);
    };
    const QString file = settings.filePath(QStringLiteral("p.json"));
    {
      const auto window = made();
      window->show();
      QVERIFY(window->use_library_material(QStringLiteral("gold")));
      QSignalSpy saved(window.get(), &Window::saved);
      window->save_to(file);
      QVERIFY(QTest::qWaitFor([&] { return saved.count() == 1; }, 20000));
      window->resize(1111, 777);
      window->findChild<QDockWidget*>(QStringLiteral("project"))->hide();
      window->addDockWidget(Qt::RightDockWidgetArea,
                            window->findChild<QDockWidget*>(QStringLiteral("library")));
      action_named(*window, QStringLiteral("Light"))->trigger();
      QVERIFY(window->close());
    }
    const auto window = made();
    window->show();
    QCOMPARE(window->size(), QSize(1111, 777));
    QVERIFY(window->findChild<QDockWidget*>(QStringLiteral("project"))->isHidden());
    auto* library = window->findChild<QDockWidget*>(QStringLiteral("library"));
    QCOMPARE(window->dockWidgetArea(library), Qt::RightDockWidgetArea);
    QCOMPARE(QSettings().value(QStringLiteral("theme")).toString(), QStringLiteral("light"));
    action_named(*window, QStringLiteral("Reset the layout"))->trigger();
    QCOMPARE(window->dockWidgetArea(library), Qt::LeftDockWidgetArea);
    QVERIFY(!window->findChild<QDockWidget*>(QStringLiteral("project"))->isHidden());

    QMenu* recent = nullptr;
    for (QMenu* each : window->findChildren<QMenu*>())
      if (each->accessibleName() == QLatin1String("Recent files")) recent = each;
    QVERIFY(recent != nullptr);
    emit recent->aboutToShow();
    QCOMPARE(recent->actions().size(), 1);
    QCOMPARE(recent->actions().front()->text(), file);
    QSignalSpy opened(window.get(), &Window::opened);
    recent->actions().front()->trigger();
    QVERIFY(QTest::qWaitFor([&] { return opened.count() == 1; }, 20000));
    QCOMPARE(window->document().path(), file);
    // A message reports a file that no longer exists, and it is removed from the list.
    QFile::remove(file);
    emit recent->aboutToShow();
    recent->actions().front()->trigger();
    QVERIFY(QTest::qWaitFor([&] { return opened.count() == 2; }, 20000));
    QCOMPARE(opened.back().front().toBool(), false);
    emit recent->aboutToShow();
    QVERIFY(!recent->actions().front()->isEnabled());
  }
};

ETAK_GUI_TEST(EditorFiles, "editor_files")
#include "test_editor_files.moc"
