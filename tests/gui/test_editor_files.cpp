// SPDX-License-Identifier: Apache-2.0
// Files and values that the window reads and writes: the question before changes are lost, exports, copied
// values, dropped files, recent files, and the settings that are kept from run to run.
#include <sys/stat.h>
#include <unistd.h>
#include <QAbstractButton>
#include <QAction>
#include <QClipboard>
#include <QDockWidget>
#include <QFileDialog>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QSettings>
#include <QXmlStreamReader>
#include <thread>

#include "app/editor/document/files.h"
#include "app/editor/fields/press_id.h"
#include "app/editor/panels/inspector.h"
#include "app/editor/panels/texture_section.h"
#include "app/editor/panels/texture_view.h"
#include "core/exchange/engine_values.h"
#include "core/material/json.h"
#include "tests/gui/editor_hands.h"
#include "tests/gui/gui_test.h"

using namespace etak;
using namespace etak::editor;

namespace {

QByteArray read(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

// The text of the window's message box, which is closed.
QString message(TestWindow& window) {
  QString out;
  const auto box = [&] {
    for (QMessageBox* each : window->findChildren<QMessageBox*>())
      if (each->isVisible()) return each;
    return static_cast<QMessageBox*>(nullptr);
  };
  (void)QTest::qWaitFor([&] { return box() != nullptr; }, 5000);
  if (QMessageBox* found = box()) {
    out = found->text() + QLatin1Char('\n') + found->informativeText();
    found->close();
  }
  return out;
}

QWidget* texture_row(TestWindow& window, Channel channel) {
  for (QWidget* each : window->inspector().textures().findChildren<QWidget*>())
    if (each->property("channel").isValid() && each->property("channel").toInt() == static_cast<int>(channel))
      return each;
  return nullptr;
}

QString picture(TestWindow& window, const QString& name) {
  QImage out(8, 8, QImage::Format_RGB32);
  out.fill(QColor(120, 130, 140));
  const QString file = window.file(name);
  out.save(file);
  return file;
}

constexpr const char* page =
    "REFERENCES: |\n    A. Tester. Test data. J. Tests 1, 2 (2001)\nDATA:\n  - type: tabulated nk\n"
    "    data: |\n        0.3 1.6 0\n        0.5 1.55 0\n        0.9 1.5 0\n";

}  // namespace

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
    const QByteArray before = read(file);
    answer(QMessageBox::Discard);
    QVERIFY(window->close());
    QCOMPARE(read(file), before);
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
    window->document().remove(0);
    answer(QMessageBox::Save);
    QVERIFY(!window->close());
    QVERIFY(message(window).contains(QLatin1String("not saved")));
    QVERIFY(!window->document().is_saved());
  }

  void every_export_writes_its_file() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    const auto exported = [&](const QString& name, const QString& file) {
      choose_file(window.file(file));
      action_named(*window, name)->trigger();
      if (!QTest::qWaitFor([&] { return QFile::exists(window.file(file)); }, 20000)) return QByteArray();
      return read(window.file(file));
    };
    const QByteArray mtlx = exported(QStringLiteral("MaterialX"), QStringLiteral("gold.mtlx"));
    // Gold's red is above 1, which the format cannot hold: a message tells that it was clamped.
    QVERIFY(message(window).contains(QLatin1String("clamp")));
    QXmlStreamReader xml(mtlx);
    bool surface = false;
    while (!xml.atEnd())
      if (xml.readNext() == QXmlStreamReader::StartElement)
        surface = surface || xml.name() == QLatin1String("open_pbr_surface");
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    QVERIFY(surface);
    const QByteArray gltf = exported(QStringLiteral("glTF"), QStringLiteral("gold.gltf"));
    QVERIFY(QJsonDocument::fromJson(gltf).object().contains(QLatin1String("materials")));
    (void)message(window);
    QVERIFY(exported(QStringLiteral("glTF, binary"), QStringLiteral("gold.glb")).startsWith("glTF"));
    (void)message(window);
    QVERIFY(exported(QStringLiteral("Save material as"), QStringLiteral("one.json")).contains("\"Gold\""));
    QVERIFY(exported(QStringLiteral("Save picture"), QStringLiteral("one.png")).startsWith("\x89PNG"));
  }

  void every_form_of_a_value_is_copied() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    const ExportSurface surface =
        export_surface(*window->document().material(), *window->document().library());
    QVERIFY(engine_targets().size() >= 10);
    for (const EngineTarget& target : engine_targets()) {
      QApplication::clipboard()->setText(QStringLiteral("nothing"));
      const auto title = QString::fromUtf8(target.title.data(), static_cast<qsizetype>(target.title.size()));
      QAction* copy = action_named(*window, title);
      QVERIFY2(copy != nullptr, qPrintable(title));
      copy->trigger();
      QCOMPARE(QApplication::clipboard()->text(),
               QString::fromStdString(copy_text(engine_values(target, surface))));
    }
    const EngineTarget* hexadecimal = engine_target("hex");
    QVERIFY(QString::fromStdString(copy_text(engine_values(*hexadecimal, surface)))
                .contains(QLatin1String("#ffe49c"), Qt::CaseInsensitive));
  }

  void dropped_spectra_become_measured_materials() {
    TestWindow window(true);
    QSignalSpy opened(window.window.get(), &Window::opened);
    write(window.file(QStringLiteral("glass.yml")), page);
    QVERIFY(drop(window->viewport(), {window.file(QStringLiteral("glass.yml"))}));
    QVERIFY(QTest::qWaitFor([&] { return opened.count() == 1; }, 20000));
    QCOMPARE(window->document().project().materials.size(), std::size_t{1});
    QVERIFY(window->document().material()->measured.has_value());

    write(window.file(QStringLiteral("Steel.CSV")), "nm,n,k\n380,2,3\n500,2.2,3.1\n780,2.5,3.4\n");
    QVERIFY(drop(*window, {window.file(QStringLiteral("Steel.CSV"))}));
    QVERIFY(QTest::qWaitFor([&] { return opened.count() == 2; }, 20000));
    QVERIFY2(opened.back().front().toBool(), qPrintable(message(window)));
    QCOMPARE(window->document().material()->name, std::string("Steel"));
    QVERIFY(window->document().material()->specular.g > 0.4);
    window->document().undo_stack().undo();
    QCOMPARE(window->document().project().materials.size(), std::size_t{1});
  }

  void an_imported_record_never_takes_the_place_of_another() {
    const TestWindow window(true);
    const MaterialLibrary library = MaterialLibrary::builtin();
    QStringList files;
    for (const char* folder : {"a", "b"}) {
      QVERIFY(QDir(window.file(QString())).mkpath(QLatin1String(folder)));
      files << window.file(QLatin1String(folder) + QStringLiteral("/Gold.csv"));
      write(files.back(), QByteArray("nm,n,k\n380,2,3\n780,2.5,") + (*folder == 'a' ? "3\n" : "4\n"));
    }
    const Opened both = import_files(files, library);
    QVERIFY2(both.error.isEmpty() && both.problems.isEmpty(),
             qPrintable(both.problems.join(QLatin1Char('\n'))));
    QCOMPARE(both.project.spectra.size(), std::size_t{2});
    QCOMPARE(both.project.spectra[0].id, std::string("gold_2"));
    QCOMPARE(both.project.spectra[1].id, std::string("gold_3"));
    QVERIFY(both.project.materials[0].specular != both.project.materials[1].specular);
    // The same file imported again gives the same record.
    write(window.file(QStringLiteral("glass.yml")), page);
    const Opened first = import_files({window.file(QStringLiteral("glass.yml"))}, library);
    const Opened again =
        import_files({window.file(QStringLiteral("glass.yml"))}, library_of(first.project, library));
    QVERIFY(again.project.spectra == first.project.spectra);
  }

  void a_table_that_contradicts_itself_is_refused_as_by_the_command_line() {
    const TestWindow window(true);
    const QString file = window.file(QStringLiteral("twice.csv"));
    write(file, "nm,n,k\n380,2,3\n500,2.2,3\n500,2.3,3\n780,2.5,3\n");
    QVERIFY(import_files({file}, MaterialLibrary::builtin()).error.contains(QLatin1String("500 nm again")));
    write(file, "nm,n,k\n380,2,3\n500,2.2,3\n500,2.2,3\n780,2.5,3\n");
    QVERIFY(import_files({file}, MaterialLibrary::builtin()).error.isEmpty());
  }

  void a_dropped_environment_lights_the_scene() {
    TestWindow window(true);
    window->show();
    const QString file = window.file(QStringLiteral("sky.hdr"));
    QByteArray hdr("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 4\n");
    for (int i = 0; i < 8; ++i) hdr += QByteArray("\x80\x90\xa0\x81", 4);
    write(file, hdr);
    const LightSetup before = window->document().project().view.lights;
    const auto seen = [&] { return window->viewport().state().environment; };
    QVERIFY(QTest::qWaitFor([&] { return seen() != nullptr && !window->is_busy(); }, 20000));
    const auto standard = seen();
    for (QWidget* target :
         {static_cast<QWidget*>(&window->viewport()), static_cast<QWidget*>(window.window.get())}) {
      QVERIFY(drop(*target, {file}));
      QCOMPARE(window->document().project().view.lights.environment, file.toStdString());
      QVERIFY(QTest::qWaitFor([&] { return seen() != nullptr && seen() != standard; }, 20000));
      window->document().undo_stack().undo();
      QVERIFY(window->document().project().view.lights == before);
      QVERIFY(QTest::qWaitFor([&] { return seen() == standard; }, 20000));
    }
  }

  void pictures_go_to_the_channel_they_are_dropped_on_or_named_for() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    window->show();
    const QString wood = picture(window, QStringLiteral("wood.png"));
    const QString gloss = picture(window, QStringLiteral("wood_gloss.png"));
    QWidget* row = texture_row(window, Channel::specular);
    QVERIFY(row != nullptr);
    QVERIFY(drop(*row, {wood}));
    QCOMPARE(window->document().material()->texture(Channel::specular)->path, wood.toStdString());
    QVERIFY(drop(window->viewport(), {wood, gloss}));
    QCOMPARE(window->document().material()->texture(Channel::diffuse)->path, wood.toStdString());
    QCOMPARE(window->document().material()->texture(Channel::gloss)->path, gloss.toStdString());
    QVERIFY(QTest::qWaitFor([&] { return window->texture_view().textures() != nullptr; }, 20000));
    QVERIFY2(window->texture_view().summary().startsWith(QLatin1String("8 x 8")),
             qPrintable(window->texture_view().summary()));
    window->document().undo_stack().undo();
    window->document().undo_stack().undo();
    QVERIFY(!window->document().material()->texture(Channel::specular));
  }

  void files_of_other_kinds_are_refused_with_a_message() {
    TestWindow window(true);
    window->show();
    write(window.file(QStringLiteral("letter.docx")), "x");
    write(window.file(QStringLiteral("page.yml")), page);
    const QString wood = picture(window, QStringLiteral("wood.png"));
    // A texture is dropped where the project has no material.
    QVERIFY(drop(window->viewport(), {wood}));
    QVERIFY(message(window).contains(QLatin1String("needs a material")));
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    const Project before = window->document().project();
    for (QWidget* target :
         {static_cast<QWidget*>(&window->viewport()), static_cast<QWidget*>(window.window.get())}) {
      // A drag without a file that can be taken is not accepted, and the status bar tells why.
      QVERIFY(!drop(*target, {window.file(QStringLiteral("letter.docx"))}));
      QVERIFY2(
          told(window).contains(QLatin1String("letter.docx")) && told(window).contains(QLatin1String(".csv")),
          qPrintable(told(window)));
      QVERIFY(window->document().project() == before);
      // Beside a file that can be taken, the refused one is named in a message.
      QVERIFY(drop(*target, {window.file(QStringLiteral("letter.docx")), wood}));
      const QString refused = message(window);
      QVERIFY2(refused.contains(QLatin1String("letter.docx")) && refused.contains(QLatin1String(".csv")),
               qPrintable(refused));
      QVERIFY(window->document().material()->texture(Channel::diffuse));
      window->document().undo_stack().undo();
    }
    QWidget& row = *texture_row(window, Channel::gloss);
    QVERIFY(!drop(row, {window.file(QStringLiteral("letter.docx"))}));
    QVERIFY(drop(row, {window.file(QStringLiteral("page.yml")), wood}));
    QVERIFY(message(window).contains(QLatin1String("no picture")));
    window->document().undo_stack().undo();
    QVERIFY(window->document().project() == before);
    // A file with the ending of a page that holds no page.
    QSignalSpy opened(window.window.get(), &Window::opened);
    write(window.file(QStringLiteral("page.yml")), "no: page");
    QVERIFY(drop(window->viewport(), {window.file(QStringLiteral("page.yml"))}));
    QVERIFY(QTest::qWaitFor([&] { return opened.count() == 1; }, 20000));
    QVERIFY(message(window).contains(QLatin1String("page.yml")));
    QVERIFY(window->document().project() == before);
  }

  void a_comparison_and_a_wedge_come_back_with_the_project() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    action_named(*window, QStringLiteral("Pin as B"))->trigger();
    QVERIFY(window->use_library_material(QStringLiteral("copper")));
    Comparison compare = window->document().project().view.compare;
    QVERIFY(compare.on && compare.pinned && compare.pinned->name == "Gold");
    compare.model = "ggx-f82";
    window->document().edit_compare(compare, QStringLiteral("model of B"));
    window->document().edit_wedge({true, "gloss", 5}, QStringLiteral("wedge"), next_press_id());
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
    QCOMPARE(other->viewport().state().b.label, std::string("Gold, ggx-f82"));
    QVERIFY(other->viewport().state().shape == ViewShape::wedge);
    QCOMPARE(other->viewport().state().wedge_steps, 5);
    other->document().edit_compare({}, QStringLiteral("compare"));
    other->document().undo_stack().undo();
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
    QVERIFY(open(pipe_of(read(file))));
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
    QVERIFY(message(window).contains(QLatin1String("holds a glTF scene; expected a project or a material")));
    QVERIFY(!open(pipe_of("nm,n,k\n400,1,0\n700,1,0\n")));
    QVERIFY(message(window).contains(QLatin1String("holds a page or a table")));
    QVERIFY(!open(QStringLiteral("/dev/zero")));
    QVERIFY(
        message(window).contains(QLatin1String("/dev/zero: is a device; expected a regular file, a pipe")));
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
