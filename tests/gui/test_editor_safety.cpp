// SPDX-License-Identifier: Apache-2.0
// No work is lost: copies of unsaved work, edits while files are written or read, exports that cannot hold
// everything, drops.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QClipboard>
#include <QDir>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QProgressDialog>
#include <QPushButton>
#include <QSysInfo>

#include "app/editor/document/files.h"
#include "app/editor/fields/number_field.h"
#include "app/editor/fields/press_id.h"
#include "app/editor/panels/inspector.h"
#include "app/editor/panels/library_panel.h"
#include "app/editor/panels/project_panel.h"
#include "app/editor/panels/texture_section.h"
#include "core/base/files/input.h"
#include "core/exchange/engine_values.h"
#include "tests/gui/editor_hands.h"
#include "tests/gui/gui_test.h"

using namespace etak;
using namespace etak::editor;

namespace {

QByteArray bytes_of(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QPushButton* button_of(QMessageBox& box, const QString& text) {
  for (QAbstractButton* each : box.buttons())
    if (each->text().remove(QLatin1Char('&')) == text) return qobject_cast<QPushButton*>(each);
  return nullptr;
}

// The message box that is shown, which does not stop the event loop.
QMessageBox* open_message(TestWindow& window, int most_ms = 10000) {
  QMessageBox* out = nullptr;
  (void)QTest::qWaitFor(
      [&] {
        for (QMessageBox* each : window->findChildren<QMessageBox*>())
          if (each->isVisible()) out = each;
        return out != nullptr;
      },
      most_ms);
  return out;
}

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

QByteArray project_bytes(const char* id) {
  const MaterialLibrary library = MaterialLibrary::builtin();
  Project project;
  project.materials.push_back(material_of(*library.find(id)));
  resolve(project, library);
  return QByteArray::fromStdString(format_project(project, ""));
}

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
    QVERIFY2(
        text.contains(QLatin1String("/somewhere/crate.json")) && text.contains(QLatin1String("1 materials")),
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
    if (QMessageBox* box = open_message(window)) box->close();
    QVERIFY(window->close());
  }

  void textures_are_not_lost_in_an_export() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    window->inspector().textures().take_files({window.file(QStringLiteral("wood_gloss.png"))},
                                              Channel::diffuse);
    for (const char* kind : {"MaterialX", "glTF", "glTF, binary"}) {
      const QString file = window.file(QStringLiteral("out"));
      choose_file(file);
      action_named(*window, QLatin1String(kind))->trigger();
      QMessageBox* box = open_message(window);
      QVERIFY2(box != nullptr, kind);
      QVERIFY2(box->informativeText().contains(QLatin1String("Gold has textures (gloss)")),
               qPrintable(box->informativeText()));
      box->close();
      QVERIFY(!QFile::exists(file));
    }
    QApplication::clipboard()->setText(QStringLiteral("nothing"));
    for (const EngineTarget& target : engine_targets()) {
      action_named(*window,
                   QString::fromUtf8(target.title.data(), static_cast<qsizetype>(target.title.size())))
          ->trigger();
      QCOMPARE(QApplication::clipboard()->text(), QStringLiteral("nothing"));
      QVERIFY(told(window).contains(QLatin1String("has textures")));
    }
  }

  void one_the_selected_or_all_materials_are_exported() {
    TestWindow window(true);
    for (const char* id : {"gold", "copper", "iron"})
      QVERIFY(window->use_library_material(QLatin1String(id)));
    show_active(window);
    QListView& list = window->project_panel().list();
    const auto click = [&](int row, Qt::KeyboardModifiers keys) {
      QTest::mouseClick(list.viewport(), Qt::LeftButton, keys,
                        list.visualRect(list.model()->index(row, 0)).center());
    };
    click(0, Qt::NoModifier);
    click(2, Qt::ControlModifier);
    QCOMPARE(window->project_panel().selected(), (std::vector<int>{0, 2}));
    const auto exported = [&](const char* which) {
      const QString file = window.file(QLatin1String(which) + QStringLiteral(".mtlx"));
      choose_file(file);
      for (QMenu* menu : window->findChildren<QMenu*>())
        if (menu->accessibleName() == QLatin1String(which)) menu->actions().front()->trigger();
      (void)QTest::qWaitFor([&] { return QFile::exists(file); }, 20000);
      if (QMessageBox* box = open_message(window, 300)) box->close();
      return bytes_of(file).count("<open_pbr_surface");
    };
    QCOMPARE(exported("Export material"), 1);
    QCOMPARE(exported("Export selected materials"), 2);
    QCOMPARE(exported("Export all materials"), 3);
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

  void dialogs_begin_beside_the_project() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    QVERIFY(QDir(window.file(QString())).mkpath(QStringLiteral("work")));
    window->document().mark_saved(window.file(QStringLiteral("work/p.json")));
    const QString folder = QFileInfo(window.file(QStringLiteral("work"))).canonicalFilePath();
    for (const char* name : {"Open", "Save as", "Save material as", "Save picture", "Import spectra",
                             "Pack the atlas", "MaterialX"}) {
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
