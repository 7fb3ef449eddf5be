// SPDX-License-Identifier: Apache-2.0
// No work is lost: copies of unsaved work, edits while files are written or read, names of files.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QDir>
#include <QLineEdit>
#include <QListView>
#include <QProgressDialog>
#include <QSysInfo>

#include "app/document/files.h"
#include "app/document/press_id.h"
#include "app/editor/panels/inspector/inspector.h"
#include "app/editor/panels/project_panel.h"
#include "app/fields/number_field.h"
#include "core/base/files/input.h"
#include "tests/gui/editor_hands.h"
#include "tests/gui/gui_test.h"

using namespace etak;
using namespace etak::editor;

namespace {

// A file as on a network share that does not answer: a pipe that nobody writes to until answer() is called.
class SilentFile {
 public:
  explicit SilentFile(const QString& path) : path_(path.toStdString()) {
    ::mkfifo(path_.c_str(), 0600);
    (void)accept_input(path_);
  }
  ~SilentFile() { answer("{}"); }
  void answer(const QByteArray& bytes) {
    if (answered_) return;
    answered_ = true;
    int end = -1;  // the pipe cannot be opened for writing before a reader has opened it
    (void)QTest::qWaitFor(
        [&] {
          end = ::open(path_.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
          return end >= 0;
        },
        5000);
    if (end < 0) return;
    (void)!::write(end, bytes.constData(), static_cast<size_t>(bytes.size()));
    ::close(end);
  }

 private:
  std::string path_;
  bool answered_ = false;
};

}  // namespace

class EditorSafety : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    QApplication::setQuitOnLastWindowClosed(false);
  }

  void the_first_change_after_new_open_and_save_is_kept() {
    TestWindow window(true);
    show_active(window);
    const QString copy = window->autosave().file();
    const auto is_kept = [&] { return QTest::qWaitFor([&] { return QFile::exists(copy); }, 3000); };
    const auto is_gone = [&] { return QTest::qWaitFor([&] { return !QFile::exists(copy); }, 3000); };
    QTest::keyClick(window.window.get(), Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY2(is_kept(), "after New");

    const QString file = window.file(QStringLiteral("p.json"));
    QSignalSpy saved(window.window.get(), &Window::saved);
    window->save_to(file);
    QVERIFY(QTest::qWaitFor([&] { return saved.count() == 1; }, 20000));
    QVERIFY(is_gone());
    FineSpinBox& gloss = window->inspector().gloss().box();
    gloss.setFocus();
    QTest::keyClick(&gloss, Qt::Key_Up);
    QVERIFY2(is_kept(), "after Save");

    write(window.file(QStringLiteral("q.json")), project_bytes("gold"));
    QSignalSpy opened(window.window.get(), &Window::opened);
    window->open(window.file(QStringLiteral("q.json")));
    QVERIFY(QTest::qWaitFor([&] { return opened.count() == 1; }, 20000));
    QVERIFY(is_gone());
    gloss.setFocus();
    QTest::keyClick(&gloss, Qt::Key_Up);
    QVERIFY2(is_kept(), "after Open");
    // After an undo of all changes, the copy is removed.
    QTest::keyClick(&gloss, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(is_gone());
  }

  void what_a_dead_run_left_is_recovered_kept_or_deleted() {
    TestWindow window(true);
    window->show();
    const QString folder = window.file(QStringLiteral("autosave"));
    const QString copy = folder + QStringLiteral("/dead.json");
    write(copy, project_bytes("gold"));
    write(copy + QStringLiteral(".path"), "/somewhere/crate.json");
    // The files of a run that was killed without changes: the lock of a process that no longer exists.
    const QString lock = folder + QStringLiteral("/gone.json.lock");
    write(lock, "4194301\neditor\n" + QSysInfo::machineHostName().toUtf8() + "\n");
    write(folder + QStringLiteral("/gone.json.path"), "/somewhere/other.json");

    QString text;
    when_asked<QMessageBox>([&](QMessageBox& box) {
      text = box.text() + QLatin1Char('\n') + box.informativeText();
      QTest::keyClick(&box, Qt::Key_Escape);
    });
    QVERIFY(!window->offer_recovery());
    QVERIFY2(text.contains(QLatin1String("/somewhere/crate.json")) &&
                 text.contains(QLatin1String("One material, ")),
             qPrintable(text));
    const QString day = QLocale().toString(QDate::currentDate(), QLocale::ShortFormat);
    QVERIFY2(text.contains(day), qPrintable(text));
    QVERIFY(QFile::exists(copy));
    QVERIFY(!QFile::exists(lock) && !QFile::exists(folder + QStringLiteral("/gone.json.path")));
    // The lock of this run stays.
    QVERIFY(QFile::exists(window->autosave().file() + QStringLiteral(".lock")));

    when_asked<QMessageBox>(
        [](QMessageBox& box) { button_of(box, QStringLiteral("Keep for later"))->click(); });
    QVERIFY(!window->offer_recovery());
    QVERIFY(QFile::exists(copy));
    const QByteArray bytes = bytes_of(copy);
    when_asked<QMessageBox>([](QMessageBox& box) { button_of(box, QStringLiteral("Delete"))->click(); });
    QVERIFY(!window->offer_recovery());
    QVERIFY(!QFile::exists(copy));

    write(copy, bytes);
    QSignalSpy opened(window.window.get(), &Window::opened);
    when_asked<QMessageBox>([](QMessageBox& box) { button_of(box, QStringLiteral("Recover"))->click(); });
    QVERIFY(window->offer_recovery());
    QVERIFY(QTest::qWaitFor([&] { return opened.count() == 1; }, 20000));
    QCOMPARE(window->document().material()->name, std::string("Gold"));
    QVERIFY(!window->document().is_saved());
    QVERIFY(!QFile::exists(copy) && QFile::exists(window->autosave().file()));
  }

  void what_is_typed_and_not_left_yet_is_saved_and_asked_for() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    const QString file = window.file(QStringLiteral("p.json"));
    window->document().mark_saved(file);
    show_active(window);
    FineSpinBox& gloss = window->inspector().gloss().box();
    const auto type = [&](const char* text) {
      gloss.setFocus();
      gloss.selectAll();
      QTest::keyClicks(&gloss, QLatin1String(text));
    };
    type("0.25");
    QVERIFY(window->document().is_saved());
    QSignalSpy saved(window.window.get(), &Window::saved);
    QTest::keyClick(&gloss, Qt::Key_S, Qt::ControlModifier);
    QVERIFY(QTest::qWaitFor([&] { return saved.count() == 1; }, 20000));
    QCOMPARE(double{open_project(file, MaterialLibrary::builtin()).project.materials[0].gloss}, 0.25);
    type("0.35");
    answer(QMessageBox::Cancel);
    QVERIFY(!window->close());
    QCOMPARE(double{window->document().material()->gloss}, 0.35);
    // A window can be destroyed while a name is edited.
    QListView& list = window->project_panel().list();
    list.setFocus();
    QTest::keyClick(&list, Qt::Key_F2);
    QTest::keyClicks(list.viewport()->findChild<QLineEdit*>(), QStringLiteral("x"));
    window.window.reset();
  }

  void a_change_made_while_saving_keeps_the_path() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    show_active(window);
    const QString file = window.file(QStringLiteral("p.json"));
    QSignalSpy saved(window.window.get(), &Window::saved);
    window->save_to(file);
    FineSpinBox& gloss = window->inspector().gloss().box();
    gloss.setFocus();
    QTest::keyClick(&gloss, Qt::Key_Up);
    QVERIFY(QTest::qWaitFor([&] { return saved.count() == 1; }, 20000));
    QCOMPARE(window->document().path(), file);
    QVERIFY(!window->document().is_saved());
    QVERIFY(window->windowTitle().contains(QLatin1String("p.json")));
    // The key of Save does not ask for a name, because the project has one.
    QTest::keyClick(&gloss, Qt::Key_S, Qt::ControlModifier);
    QVERIFY(QTest::qWaitFor([&] { return saved.count() == 2; }, 20000));
    QVERIFY(window->document().is_saved());
    // Another project that was opened meanwhile does not get the path.
    window->save_to(window.file(QStringLiteral("old.json")));
    window->document().replace({}, {}, true);
    QVERIFY(QTest::qWaitFor([&] { return saved.count() == 3; }, 20000));
    QVERIFY(window->document().path().isEmpty());
  }

  void what_is_edited_while_a_file_is_read_is_asked_for() {
    TestWindow window(true);
    show_active(window);
    SilentFile slow(window.file(QStringLiteral("slow.json")));
    QSignalSpy opened(window.window.get(), &Window::opened);
    window->open(window.file(QStringLiteral("slow.json")));
    // The window can be used while the file is read.
    QTest::keyClick(window.window.get(), Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(window->document().material() != nullptr);
    const Project edited = window->document().project();
    int asked = 0;
    when_asked<QMessageBox>([&](QMessageBox& box) {
      ++asked;
      box.button(QMessageBox::Cancel)->click();
    });
    slow.answer(project_bytes("gold"));
    QVERIFY(QTest::qWaitFor([&] { return opened.count() == 1; }, 20000));
    QCOMPARE(asked, 1);
    QCOMPARE(opened.front().front().toBool(), false);
    QVERIFY(window->document().project() == edited);
  }

  void closing_on_a_share_that_does_not_answer_can_be_cancelled() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    window->document().mark_saved(window.file(QStringLiteral("p.json")));
    show_active(window);
    FineSpinBox& gloss = window->inspector().gloss().box();
    gloss.setFocus();
    QTest::keyClick(&gloss, Qt::Key_Up);
    SilentFile share(window.file(QStringLiteral("slow.json")));
    window->open(window.file(QStringLiteral("slow.json")));  // files are written after this one is read
    answer(QMessageBox::Save);
    when_asked<QProgressDialog>([](QProgressDialog& dialog) { dialog.findChild<QPushButton*>()->click(); });
    QVERIFY(!window->close());
    QVERIFY(window->isVisible());
    QVERIFY2(told(window).contains(QLatin1String("still being saved")), qPrintable(told(window)));
    // The save ends when the share answers. The file that was read is no project, which is reported, and none
    // is opened.
    QSignalSpy saved(window.window.get(), &Window::saved);
    share.answer("{");
    QVERIFY(QTest::qWaitFor([&] { return saved.count() == 1; }, 20000));
    QVERIFY(window->document().is_saved());
    QVERIFY(!shown_message(window).isEmpty());
    QVERIFY(window->close());
  }

  void dialogs_begin_beside_the_project() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    QVERIFY(QDir(window.file(QString())).mkpath(QStringLiteral("work")));
    window->document().mark_saved(window.file(QStringLiteral("work/p.json")));
    const QString folder = QFileInfo(window.file(QStringLiteral("work"))).canonicalFilePath();
    for (const char* name :
         {"Open", "Save as", "Save material as", "Import spectra", "Pack the atlas", "MaterialX"}) {
      QString at;
      when_asked<QFileDialog>([&](QFileDialog& dialog) {
        at = dialog.directory().canonicalPath();
        dialog.reject();
      });
      action_named(*window, QLatin1String(name))->trigger();
      QVERIFY2(at == folder, qPrintable(QLatin1String(name) + QStringLiteral(": ") + at));
    }
  }
};

ETAK_GUI_TEST(EditorSafety, "editor_safety")
#include "test_editor_safety.moc"
