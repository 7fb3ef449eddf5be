// SPDX-License-Identifier: Apache-2.0
// Faults from outside: broken files, folders that cannot be written, a run that is killed, thousands of
// materials, pictures that are too large. No work is lost, and the user-interface thread never waits.
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMessageBox>
#include <QToolTip>

#include "app/document/press_id.h"
#include "app/editor/panels/findings_panel.h"
#include "app/editor/panels/inspector/inspector.h"
#include "app/editor/panels/library_panel.h"
#include "app/editor/panels/pack_dialog.h"
#include "app/editor/panels/project_panel.h"
#include "app/editor/panels/texture_view.h"
#include "app/fields/number_field.h"
#include "core/base/files/file.h"
#include "core/image/files/png.h"
#include "tests/gui/editor_support.h"
#include "tests/gui/gui_test.h"
#include "tests/gui/watchdog.h"

using namespace etak;
using namespace etak::editor;

namespace {

void close_messages() {
  for (QWidget* each : QApplication::topLevelWidgets())
    if (auto* box = qobject_cast<QMessageBox*>(each)) box->close();
}

Project many(int count) {
  Project out;
  const MaterialLibrary library = MaterialLibrary::builtin();
  for (int i = 0; i < count; ++i) {
    ProjectMaterial m;
    m.name = "material " + std::to_string(i);
    m.gloss = (i % 100) / 100.0;
    if (i % 3 == 0)
      m.measured = MeasuredF0{library.ids()[static_cast<std::size_t>(i) % library.ids().size()], "", "", {}};
    m.diffuse = {0.2, 0.3, 0.001 * i};
    out.materials.push_back(m);
  }
  return out;
}

// A black PNG of one bit per texel, or only the header of one.
QByteArray grey_png(int side, bool whole) {
  const auto number = [](quint32 value) {
    QByteArray out;
    for (const int shift : {24, 16, 8, 0}) out += static_cast<char>(value >> shift & 0xff);
    return out;
  };
  const auto chunk = [&](const QByteArray& type, const QByteArray& data) {
    const QByteArray checked = type + data;
    quint32 crc = 0xffffffff;
    for (const char c : checked) {
      crc ^= static_cast<quint8>(c);
      for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? 0xedb88320 ^ (crc >> 1) : crc >> 1;
    }
    return number(static_cast<quint32>(data.size())) + checked + number(~crc);
  };
  const auto wide = static_cast<quint32>(side);
  QByteArray out = QByteArray("\x89PNG\r\n\x1a\n", 8) +
                   chunk("IHDR", number(wide) + number(wide) + QByteArray("\1\0\0\0\0", 5));
  if (!whole) return out;
  // qCompress puts four bytes with the length before the zlib stream that PNG needs.
  const QByteArray rows((side / 8 + 1) * side, '\0');
  return out + chunk("IDAT", qCompress(rows, 1).mid(4)) + chunk("IEND", {});
}

// The gloss that the child process of the test of killed runs sets in its n-th edit; before the first edit it
// is that of many().
double gloss_of_round(int round) {
  return round < 1 ? 0 : 0.001 * (1 + round % 900);
}

}  // namespace

class EditorFaults : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { close_messages(); }

  void broken_files_are_told_and_change_nothing() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    const Project before = window->document().project();
    QSignalSpy opened(window.window.get(), &Window::opened);
    int count = 0;
    const std::pair<const char*, QByteArray> files[]{{"empty.json", ""},
                                                     {"cut.json", "{\"schema\": \"etak-project/1\", \"mat"},
                                                     {"other.json", "{\"a\": 1}"},
                                                     {"deep.json", QByteArray(100000, '[')},
                                                     {"bytes.json", QByteArray(1000, '\xff')}};
    for (const auto& [name, bytes] : files) {
      write(window.file(QLatin1String(name)), bytes);
      window->open(window.file(QLatin1String(name)));
      QVERIFY(QTest::qWaitFor([&] { return opened.count() > count; }, 20000));
      QCOMPARE(opened[count++].front().toBool(), false);
      close_messages();
    }
    window->import({window.file(QStringLiteral("bytes.json")), window.file(QStringLiteral("missing.yml"))});
    QVERIFY(QTest::qWaitFor([&] { return opened.count() > count; }, 20000));
    QVERIFY(window->document().project() == before);
  }

  void names_are_no_html() {
    TestWindow window(true);
    QSignalSpy opened(window.window.get(), &Window::opened);
    const QString file = window.file(QStringLiteral("<b>bold.json"));
    write(file, "{");
    window->open(file);
    QVERIFY(QTest::qWaitFor([&] { return opened.count() == 1; }, 20000));
    QToolTip::showText(QPoint(10, 10), QStringLiteral("<b>bold</b>"));
    int labels = 0;
    for (QWidget* each : QApplication::allWidgets()) {
      auto* const label = qobject_cast<QLabel*>(each);
      if (label == nullptr || !label->text().contains(QStringLiteral("<b>bold"))) continue;
      QCOMPARE(label->textFormat(), Qt::PlainText);
      ++labels;
    }
    QVERIFY(labels >= 2);  // the labels of the message and of the tooltip
    QToolTip::hideText();
    close_messages();
  }

  void a_folder_that_cannot_be_written_loses_nothing() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    QSignalSpy saved(window.window.get(), &Window::saved);
    // Even root cannot write to these places: below a file as if it were a folder, and in /proc.
    write(window.file(QStringLiteral("file")), "x");
    int tried = 0;
    for (const QString& place :
         {window.file(QStringLiteral("file/project.json")), QStringLiteral("/proc/project.json")}) {
      window->save_to(place);
      QVERIFY(QTest::qWaitFor([&] { return saved.count() == tried + 1; }, 20000));
      QCOMPARE(saved[tried++].front().toBool(), false);
      QVERIFY(!window->document().is_saved());
    }
    if (::geteuid() != 0) {
      const QString folder = window.file(QStringLiteral("read only"));
      QVERIFY(QDir().mkpath(folder));
      ::chmod(folder.toStdString().c_str(), 0555);
      window->save_to(folder + QStringLiteral("/project.json"));
      QVERIFY(QTest::qWaitFor([&] { return saved.count() == tried + 1; }, 20000));
      QCOMPARE(saved.back().front().toBool(), false);
      ::chmod(folder.toStdString().c_str(), 0755);
    }
    QVERIFY(window->document().material() != nullptr);
    QVERIFY(QFile::exists(window->autosave().file()));
  }

  // A child process edits and saves again and again until it is killed; the next run offers its last state.
  void a_run_killed_while_saving_is_recovered() {
    QTemporaryDir folder;
    const QString project = folder.filePath(QStringLiteral("project.json"));
    write_file(project.toStdString(), format_project(many(300), project.toStdString()), true);
    for (const int after_ms : {5, 20, 60}) {
      QProcess child;
      QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
      environment.insert(QStringLiteral("ETAK_TEST_SAVE_FOREVER"), folder.path());
      environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
      child.setProcessEnvironment(environment);
      child.start(QCoreApplication::applicationFilePath(), {QStringLiteral("save_forever")});
      QVERIFY(child.waitForStarted());
      QVERIFY(
          QTest::qWaitFor([&] { return QFile::exists(folder.filePath(QStringLiteral("saving"))); }, 60000));
      QTest::qWait(after_ms);
      ::kill(static_cast<pid_t>(child.processId()), SIGKILL);
      QVERIFY(child.waitForFinished());
      QFile::remove(folder.filePath(QStringLiteral("saving")));
      // The file holds a complete project, of whichever edit.
      const Project on_disk = parse_project(read_file(project.toStdString()), project.toStdString());
      QCOMPARE(on_disk.materials.size(), std::size_t{300});

      WindowOptions options;
      options.cpu_viewport = true;
      options.remember = false;
      options.data_folder = options.cache_folder = folder.path();
      Window window(options);
      int asked = 0;
      window.offer_recovery([&](const Recovery& each) {
        ++asked;
        return each.path == project ? RecoveryChoice::recover : RecoveryChoice::discard;
      });
      QVERIFY(asked <= 1);
      QVERIFY(QTest::qWaitFor([&] { return !window.is_busy(); }, 60000));
      // The last state is the one that is offered, or that of the file where it had just been saved.
      const Project& last = asked == 1 ? window.document().project() : on_disk;
      QCOMPARE(last.materials.size(), std::size_t{300});
      if (asked == 1) {
        QVERIFY(!window.document().is_saved());
        QCOMPARE(window.document().path(), project);
      }
      // The state may be that of the edit before, because the kill can come in the middle of an edit.
      const int round = std::stoi(read_file(folder.filePath(QStringLiteral("round")).toStdString()));
      QVERIFY2(last.materials[0].gloss == gloss_of_round(round) ||
                   last.materials[0].gloss == gloss_of_round(round - 1),
               qPrintable(
                   QStringLiteral("gloss %1 after edit %2").arg(double{last.materials[0].gloss}).arg(round)));
      QVERIFY(!QFile::exists(window.autosave().file()) || asked == 1);
    }
  }

  void a_thousand_materials_stay_fluid() {
    TestWindow window(true);
    window->resize(1000, 700);
    window->show();
    const QString file = window.file(QStringLiteral("many.json"));
    write_file(file.toStdString(), format_project(many(1000), file.toStdString()), true);
    QVERIFY(window.settle());
    QTest::qWait(300);

    Watchdog watchdog;
    QSignalSpy opened(window.window.get(), &Window::opened);
    window->open(file);
    QVERIFY(QTest::qWaitFor([&] { return opened.count() == 1; }, 60000));
    QCOMPARE(window->document().project().materials.size(), std::size_t{1000});
    for (int i = 0; i < 40; ++i) {
      window->document().set_current((i * 37) % 1000);
      window->inspector().gloss().box().setValue(0.01 * (i % 100));
      QTest::qWait(2);
    }
    window->library_panel().search().setText(QStringLiteral("gl"));
    QTest::qWait(20);
    window->library_panel().search().clear();
    window->project_panel().list().scrollToBottom();
    QTest::qWait(20);
    QSignalSpy saved(window.window.get(), &Window::saved);
    window->save_to(window.file(QStringLiteral("many 2.json")));
    QVERIFY(QTest::qWaitFor([&] { return saved.count() == 1; }, 60000));
    PackDialog* dialog = window->pack_to(window.file(QStringLiteral("atlas")));
    QSignalSpy packed(dialog, &PackDialog::finished_packing);
    QVERIFY(QTest::qWaitFor([&] { return packed.count() == 1; }, 120000));
    QVERIFY(window.settle(120000));
    watchdog.stop();
    qInfo("most work of the UI thread at once: %.1f ms", watchdog.work_ms());
    QVERIFY2(watchdog.work_ms() <= most_work_ms(), qPrintable(QString::number(watchdog.work_ms())));
  }

  void a_huge_texture_is_told_and_does_not_stop_the_window_data() {
    QTest::addColumn<int>("side");
    QTest::addColumn<bool>("whole");
    QTest::addColumn<QString>("expected");
    QTest::newRow("16384, all there") << 16384 << true << QStringLiteral("16384 x 16384");
    QTest::newRow("16384, nothing behind the head") << 16384 << false << QStringLiteral("huge_gloss.png");
    QTest::newRow("a head that asks for 40 GB") << 100000 << false << QStringLiteral("huge_gloss.png");
  }

  void a_huge_texture_is_told_and_does_not_stop_the_window() {
    QFETCH(int, side);
    QFETCH(bool, whole);
    QFETCH(QString, expected);
    TestWindow window(true);
    window->show();
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    QVERIFY(window.settle());
    const QString picture = window.file(QStringLiteral("huge_gloss.png"));
    write(picture, grey_png(side, whole));
    ProjectMaterial m = *window->document().material();
    m.texture(Channel::gloss) = ImageSource{picture.toStdString(), {}, {}};
    Watchdog watchdog;
    window->document().edit(0, m, QStringLiteral("texture"), next_press_id());
    QVERIFY(window.settle());
    QVERIFY(QTest::qWaitFor([&] { return !window->texture_view().is_busy(); }, 60000));
    watchdog.stop();
    QVERIFY2(watchdog.work_ms() <= most_work_ms(), qPrintable(QString::number(watchdog.work_ms())));
    // The pictures are not shown, and the text in their place tells why.
    QVERIFY(window->texture_view().textures() == nullptr);
    const QString summary = window->texture_view().summary();
    QVERIFY2(summary.contains(expected), qPrintable(summary));
    if (whole) return;
    const auto& findings = window->validator().findings();
    QVERIFY(findings.contains("Gold"));
    QVERIFY(std::any_of(findings.at("Gold").begin(), findings.at("Gold").end(),
                        [](const Finding& f) { return f.rule == "ETK001"; }));
  }

  void without_a_place_for_copies_one_can_work_and_save() {
    QTemporaryDir folder;
    write(folder.filePath(QStringLiteral("file")), "x");
    WindowOptions options;
    options.cpu_viewport = true;
    options.remember = false;
    options.data_folder = options.cache_folder = folder.filePath(QStringLiteral("file"));
    Window window(options);
    window.show();
    QVERIFY(window.use_library_material(QStringLiteral("gold")));
    QSignalSpy saved(&window, &Window::saved);
    window.save_to(folder.filePath(QStringLiteral("p.json")));
    QVERIFY(QTest::qWaitFor([&] { return saved.count() == 1; }, 20000));
    QCOMPARE(saved.front().front().toBool(), true);
    QVERIFY(window.document().is_saved());
  }

  void an_atlas_that_cannot_be_written_is_told() {
    TestWindow window(true);
    window->show();
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    PackDialog* dialog = window->pack_to(QStringLiteral("/proc/atlas"));
    QSignalSpy packed(dialog, &PackDialog::finished_packing);
    QVERIFY(QTest::qWaitFor([&] { return packed.count() == 1; }, 60000));
    QCOMPARE(packed.front().front().toBool(), false);
    QVERIFY2(dialog->result_text().contains(QLatin1String("/proc/atlas")), qPrintable(dialog->result_text()));
    dialog->reject();
  }
};

// The child process of the test of killed runs, in the folder that the environment names: it edits and saves until it is killed.
static int save_forever(int argc, char** argv) {
  QApplication application(argc, argv);
  const QString folder = qEnvironmentVariable("ETAK_TEST_SAVE_FOREVER");
  WindowOptions options;
  options.cpu_viewport = true;
  options.remember = false;
  options.data_folder = options.cache_folder = folder;
  Window window(options);
  const QString project = folder + QStringLiteral("/project.json");
  int round = 0;
  const auto again = [&] {
    ProjectMaterial m = window.document().project().materials[0];
    m.gloss = gloss_of_round(++round);
    write_file((folder + QStringLiteral("/round")).toStdString(), std::to_string(round), true);
    window.document().edit(0, m, QStringLiteral("gloss"), next_press_id());
    window.save_to(project);
    if (round == 2) write_file((folder + QStringLiteral("/saving")).toStdString(), "", true);
  };
  QObject::connect(&window, &Window::saved, &window, again);
  QObject::connect(&window, &Window::opened, &window, again);
  window.open(project);
  return QApplication::exec();
}

static const etak::test::GuiTest registered_saving("save_forever", save_forever);
ETAK_GUI_TEST(EditorFaults, "editor_faults")
#include "test_editor_faults.moc"
