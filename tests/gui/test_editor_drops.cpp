// SPDX-License-Identifier: Apache-2.0
// Dropped and imported files: spectra, environments, projects, files that change, and what cannot be taken.
#include <QLineEdit>
#include <filesystem>

#include "app/document/files.h"
#include "app/editor/panels/inspector/inspector.h"
#include "app/editor/panels/texture_view.h"
#include "tests/gui/editor_hands.h"
#include "tests/gui/gui_test.h"

using namespace etak;
using namespace etak::editor;

class EditorDrops : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QApplication::setQuitOnLastWindowClosed(false); }

  void dropped_spectra_become_measured_materials() {
    TestWindow window(true);
    QSignalSpy opened(window.window.get(), &Window::opened);
    write(window.file(QStringLiteral("glass.yml")), glass_page);
    QVERIFY(drop(window->viewport(), {window.file(QStringLiteral("glass.yml"))}));
    QVERIFY(QTest::qWaitFor([&] { return opened.count() == 1; }, 20000));
    QCOMPARE(window->document().project().materials.size(), std::size_t{1});
    QVERIFY(window->document().material()->measured.has_value());

    write(window.file(QStringLiteral("Steel.CSV")), "nm,n,k\n380,2,3\n500,2.2,3.1\n780,2.5,3.4\n");
    QVERIFY(drop(*window, {window.file(QStringLiteral("Steel.CSV"))}));
    QVERIFY(QTest::qWaitFor([&] { return opened.count() == 2; }, 20000));
    QVERIFY2(opened.back().front().toBool(), qPrintable(shown_message(window)));
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
    write(window.file(QStringLiteral("glass.yml")), glass_page);
    const Opened first = import_files({window.file(QStringLiteral("glass.yml"))}, library);
    const Opened again =
        import_files({window.file(QStringLiteral("glass.yml"))}, library_of(first.project, library));
    QVERIFY(again.project.spectra == first.project.spectra);
  }

  void materials_of_material_x_are_imported() {
    const TestWindow window(true);
    const QString file = window.file(QStringLiteral("gold.mtlx"));
    write(file,
          "<materialx version=\"1.39\"><gltf_pbr name=\"Gold\" type=\"surfaceshader\">"
          "<input name=\"base_color\" type=\"color3\" value=\"1, 0.774, 0.335\"/></gltf_pbr></materialx>");
    QCOMPARE(kind_of_file(file), FileKind::spectra);
    const Opened gold = import_files({file}, MaterialLibrary::builtin());
    QVERIFY2(gold.error.isEmpty(), qPrintable(gold.error));
    QCOMPARE(gold.project.materials.size(), std::size_t{1});
    QCOMPARE(gold.project.materials[0].specular.g, 0.774);
    write(file, "<materialx");
    QVERIFY(!import_files({file}, MaterialLibrary::builtin()).error.isEmpty());
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
    write(file, radiance_picture(4, 2, [](int) { return QByteArray("\x80\x90\xa0\x81", 4); }));
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

  void a_file_that_changes_on_the_disk_is_shown_again() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    window->show();
    const QString wood = grey_picture(window, QStringLiteral("wood.png"));
    put_texture(window, Channel::diffuse, wood);
    QTRY_VERIFY(window->texture_view().textures() != nullptr && !window->texture_view().is_busy());
    const auto green = [&] { return window->texture_view().textures()->body.at(0, 0)[1]; };
    const float before = green();
    QTest::qWait(300);  // until the file is watched
    const auto paint = [&](const QColor& color) {
      QImage other(8, 8, QImage::Format_RGB32);
      other.fill(color);
      QVERIFY(other.save(wood + QStringLiteral(".new.png")));
      // Programs save a file by putting another one in its place.
      std::filesystem::rename((wood + QStringLiteral(".new.png")).toStdString(), wood.toStdString());
    };
    paint(Qt::green);
    QTRY_VERIFY_WITH_TIMEOUT(green() == 1.0F && before < 1.0F, 30000);
    QTest::qWait(300);
    paint(Qt::black);
    QTRY_VERIFY_WITH_TIMEOUT(green() == 0.0F, 30000);
    // One that was away and comes back is read again too.
    QVERIFY(QFile::remove(wood));
    QTest::qWait(600);
    paint(Qt::white);
    QTRY_VERIFY_WITH_TIMEOUT(window->texture_view().textures() != nullptr && green() == 1.0F, 30000);
  }

  void files_of_other_kinds_are_refused_with_a_message() {
    TestWindow window(true);
    window->show();
    write(window.file(QStringLiteral("letter.docx")), "x");
    write(window.file(QStringLiteral("page.yml")), glass_page);
    const QString wood = grey_picture(window, QStringLiteral("wood.png"));
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
      const QString refused = shown_message(window);
      QVERIFY2(refused.contains(QLatin1String("letter.docx")) && refused.contains(QLatin1String(".csv")),
               qPrintable(refused));
      QVERIFY(window.settle());
      QVERIFY(window->document().material()->texture(Channel::diffuse));
      window->document().undo_stack().undo();
    }
    QWidget& row = *texture_row(window, Channel::gloss);
    QVERIFY(!drop(row, {window.file(QStringLiteral("letter.docx"))}));
    QVERIFY(drop(row, {window.file(QStringLiteral("page.yml")), wood}));
    QVERIFY(shown_message(window).contains(QLatin1String("no picture")));
    QVERIFY(window.settle());
    window->document().undo_stack().undo();
    QVERIFY(window->document().project() == before);
    // A file with the ending of a page that holds no page.
    QSignalSpy opened(window.window.get(), &Window::opened);
    write(window.file(QStringLiteral("page.yml")), "no: page");
    QVERIFY(drop(window->viewport(), {window.file(QStringLiteral("page.yml"))}));
    QVERIFY(QTest::qWaitFor([&] { return opened.count() == 1; }, 20000));
    QVERIFY(shown_message(window).contains(QLatin1String("page.yml")));
    QVERIFY(window->document().project() == before);
  }

  void a_dropped_project_is_opened_or_added_as_is_answered() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("copper")));
    show_active(window);
    const QString file = window.file(QStringLiteral("dropped.json"));
    write(file, project_bytes("gold"));
    const Project before = window->document().project();
    QSignalSpy opened(window.window.get(), &Window::opened);
    const auto answered = [&](QWidget& target, const QString& button) {
      if (!drop(target, {file})) return false;
      QMessageBox* box = open_message(window);
      if (box == nullptr || button_of(*box, button) == nullptr) return false;
      button_of(*box, button)->click();
      return true;
    };
    QVERIFY(answered(*window, QStringLiteral("Cancel")));
    QTest::qWait(50);
    QVERIFY(window->document().project() == before);
    QVERIFY(answered(window->viewport(), QStringLiteral("Add")));
    QVERIFY(QTest::qWaitFor([&] { return opened.count() == 1; }, 20000));
    QCOMPARE(window->document().project().materials.size(), std::size_t{2});
    QVERIFY(window->document().path().isEmpty());
    // Opening it first asks what to do with the changes.
    answer(QMessageBox::Discard);
    QVERIFY(answered(*window, QStringLiteral("Open")));
    QVERIFY(QTest::qWaitFor([&] { return opened.count() == 2; }, 20000));
    QCOMPARE(window->document().project().materials.size(), std::size_t{1});
    QCOMPARE(window->document().path(), file);
  }

  void a_line_takes_no_files() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    window->show();
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(window.file(QStringLiteral("p.json")))});
    for (QLineEdit* each : window->findChildren<QLineEdit*>())
      if (!each->isReadOnly()) QVERIFY2(!each->acceptDrops(), qPrintable(each->accessibleName()));
    // The window does not take addresses of other machines either.
    data.setUrls({QUrl(QStringLiteral("https://example.org/a.json"))});
    for (QWidget* each :
         {static_cast<QWidget*>(&window->viewport()), static_cast<QWidget*>(window.window.get())}) {
      QDragEnterEvent enter(each->rect().center(), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
      QCoreApplication::sendEvent(each, &enter);
      QVERIFY(!enter.isAccepted());
    }
  }
};

ETAK_GUI_TEST(EditorDrops, "editor_drops")
#include "test_editor_drops.moc"
