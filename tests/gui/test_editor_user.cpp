// SPDX-License-Identifier: Apache-2.0
// A session by keys and mouse that ends by a kill: pick gold, compare models, import a page, export a
// textured glTF, edit on. The next run recovers everything.
#include <signal.h>
#include <unistd.h>

#include <QComboBox>
#include <QDir>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QProcess>

#include "app/editor/panels/drop_table.h"
#include "app/editor/panels/inspector/inspector.h"
#include "app/fields/number_field.h"
#include "core/base/files/file.h"
#include "core/scene/gltf.h"
#include "tests/gltf_judge.h"
#include "tests/gui/editor_hands.h"
#include "tests/gui/gui_test.h"

using namespace etak;
using namespace etak::editor;

namespace {

constexpr const char* session_folder = "ETAK_TEST_SESSION";
constexpr int patience = 30000;

std::unique_ptr<Window> window_in(const QString& folder) {
  WindowOptions options;
  options.remember = false;
  options.data_folder = options.cache_folder = folder;
  return std::make_unique<Window>(options);
}

// Clicks through the menus of the window, by their texts.
bool click_menu(const Window& window, const QStringList& path) {
  QWidget* at = window.menuBar();
  for (const QString& text : path) {
    QAction* found = nullptr;
    for (QAction* each : at->actions())
      if (each->text().remove(QLatin1Char('&')).remove(QChar(0x2026)) == text) found = each;
    if (found == nullptr) return false;
    auto* bar = qobject_cast<QMenuBar*>(at);
    const QRect place =
        bar != nullptr ? bar->actionGeometry(found) : qobject_cast<QMenu*>(at)->actionGeometry(found);
    QTest::mouseClick(at, Qt::LeftButton, {}, place.center());
    if (found->menu() == nullptr) return true;
    at = found->menu();
    if (!QTest::qWaitFor([&] { return at->isVisible(); }, patience)) return false;
  }
  return false;
}

}  // namespace

// The run that is killed at its end, in the folder that the environment names.
class UserSession : public QObject {
  Q_OBJECT

  std::unique_ptr<Window> window;
  QDir folder{qEnvironmentVariable(session_folder)};

 private slots:
  void initTestCase() {
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    window = window_in(folder.path());
    QSignalSpy first_frame(window.get(), &Window::first_frame);
    window->show();
    window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window.get(), patience));
    QVERIFY(QTest::qWaitFor([&] { return first_frame.count() > 0; }, patience));
  }

  void gold_is_picked() {
    QTest::keyClick(window.get(), Qt::Key_F, Qt::ControlModifier);
    QLineEdit& search = window->library_panel().search();
    QTRY_VERIFY(search.hasFocus());
    QTest::keyClicks(&search, QStringLiteral("gold"));
    QTest::keyClick(&search, Qt::Key_Return);
    QVERIFY(window->look().preview.has_value());
    QTest::keyClick(&window->library_panel().list(), Qt::Key_Return);
    QVERIFY(window->document().material() != nullptr);
    QCOMPARE(window->document().material()->name, std::string("Gold"));
    // Esc ends what is left of the preview, and the camera goes round by a drag.
    QTest::keyClick(window.get(), Qt::Key_Escape);
    const View camera = window->look().camera;
    const QPoint middle = window->viewport().rect().center();
    drag(window->viewport(), middle, middle + QPoint(50, 20));
    QVERIFY(!(window->look().camera == camera));
  }

  void models_are_compared() {
    QTest::keyClick(window.get(), Qt::Key_B, Qt::ControlModifier);
    QVERIFY(window->document().project().view.compare.pinned.has_value());
    auto* model = named<QComboBox>(window->inspector(), QStringLiteral("Specular model"));
    window->inspector().ensureWidgetVisible(model);
    model->setFocus();
    const std::string before = window->document().material()->specular_model;
    QTest::keyClick(model, Qt::Key_Down);
    QVERIFY(window->document().material()->specular_model != before);
    const ViewState& shown = window->viewport().state();
    QTRY_VERIFY(shown.split && shown.a.specular != shown.b.specular);
    QTest::mouseMove(&window->viewport(), window->viewport().rect().center() + QPoint(2, 2));
    const auto* under = named<QLabel>(*window, QStringLiteral("Under the cursor"));
    QTRY_VERIFY(under->text().contains(QLatin1String("B - A")));
  }

  void a_page_is_imported() {
    const QString file = folder.filePath(QStringLiteral("my glass.yml"));
    write(file, glass_page);
    QSignalSpy opened(window.get(), &Window::opened);
    choose_file(file);
    QTest::keyClick(window.get(), Qt::Key_I, Qt::ControlModifier);
    QVERIFY(QTest::qWaitFor([&] { return opened.count() == 1; }, patience));
    QCOMPARE(window->document().project().materials.size(), std::size_t{2});
    QVERIFY(window->document().material()->measured.has_value());
  }

  void the_project_is_saved() {
    QSignalSpy saved(window.get(), &Window::saved);
    choose_file(folder.filePath(QStringLiteral("session.json")));
    QTest::keyClick(window.get(), Qt::Key_S, Qt::ControlModifier);
    QVERIFY(QTest::qWaitFor([&] { return saved.count() == 1; }, patience));
    QVERIFY(window->document().is_saved());
  }

  void a_textured_gltf_is_exported() {
    QStringList pictures;
    for (const char* name : {"wood.png", "wood_gloss.png"}) {
      QImage out(16, 16, QImage::Format_RGB32);
      out.fill(QColor(130, 90, 60));
      pictures << folder.filePath(QLatin1String(name));
      QVERIFY(out.save(pictures.back()));
    }
    QVERIFY(drop(window->viewport(), pictures));
    QTRY_VERIFY(window->findChild<DropTable*>() != nullptr && window->findChild<DropTable*>()->isVisible());
    QTest::keyClick(window->findChild<DropTable*>(), Qt::Key_Return);
    QTRY_VERIFY(window->document().material()->texture(Channel::smoothness).has_value());
    const QString file = folder.filePath(QStringLiteral("wood.gltf"));
    choose_file(file);
    QVERIFY(click_menu(*window,
                       {QStringLiteral("File"), QStringLiteral("Export material"), QStringLiteral("glTF")}));
    QVERIFY(QTest::qWaitFor([&] { return QFile::exists(file); }, patience));
    QVERIFY(QTest::qWaitFor([&] { return !window->is_busy(); }, patience));
    // What the format cannot hold is told in a message, which Esc closes.
    QTest::keyClick(window.get(), Qt::Key_Escape);
    QVERIFY(window->problems().text().isEmpty());
  }

  void a_kill_comes_in_the_middle_of_the_work() {
    auto* occlusion = named<FineSpinBox>(window->inspector(), QStringLiteral("Occlusion"));
    window->inspector().ensureWidgetVisible(occlusion);
    occlusion->setFocus();
    occlusion->selectAll();
    QTest::keyClicks(occlusion, QStringLiteral("0.4"));
    QTest::keyClick(occlusion, Qt::Key_Return);
    QCOMPARE(window->document().material()->occlusion, 0.4);
    QVERIFY(!window->document().is_saved());
    const std::string copy = window->autosave().file().toStdString();
    const auto is_kept = [&] {
      if (!QFile::exists(window->autosave().file())) return false;
      const Project kept = parse_project(read_file(copy), copy);
      return kept.materials.size() == 2 && kept.materials[1].occlusion == 0.4;
    };
    QVERIFY(QTest::qWaitFor(is_kept, patience));
    write(folder.filePath(QStringLiteral("all is well")), "");
    ::kill(::getpid(), SIGKILL);
  }
};

class EditorUser : public QObject {
  Q_OBJECT

 private slots:
  void what_a_killed_session_did_is_recovered() {
    QTemporaryDir folder;
    QProcess child;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QLatin1String(session_folder), folder.path());
    child.setProcessEnvironment(environment);
    child.setProcessChannelMode(QProcess::MergedChannels);
    child.start(QCoreApplication::applicationFilePath(), {QStringLiteral("user_session")});
    QVERIFY(child.waitForFinished(300000));
    const QByteArray said = child.readAll();
    QVERIFY2(QFile::exists(folder.filePath(QStringLiteral("all is well"))), said.constData());
    QCOMPARE(child.exitStatus(), QProcess::CrashExit);

    // The exported file holds both textures and passes the Khronos validator.
    const std::string gltf = folder.filePath(QStringLiteral("wood.gltf")).toStdString();
    const GltfScene scene = read_gltf(gltf, {});
    QCOMPARE(scene.images.size(), std::size_t{2});
    for (const PictureFile& each : scene.images)
      QCOMPARE(QImage::fromData(QByteArray::fromStdString(each.bytes), "png").size(), QSize(16, 16));
    const auto messages = test::gltf_messages(folder.path().toStdString(), {gltf});
    if (!messages) qWarning("no node with gltf-validator (NODE_PATH): what is written is not validated");
    QCOMPARE(messages.value_or(""), std::string());

    const auto window = window_in(folder.path());
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window.get()));
    QString question;
    when_asked<QMessageBox>([&](QMessageBox& box) {
      question = box.text() + QLatin1Char(' ') + box.informativeText();
      QTest::mouseClick(button_of(box, QStringLiteral("Recover")), Qt::LeftButton);
    });
    QSignalSpy opened(window.get(), &Window::opened);
    QVERIFY(window->offer_recovery());
    QVERIFY(QTest::qWaitFor([&] { return opened.count() == 1; }, patience));
    QVERIFY2(
        question.contains(QLatin1String("session.json")) && question.contains(QLatin1String("2 materials")),
        qPrintable(question));
    const Project& project = window->document().project();
    QCOMPARE(project.materials.size(), std::size_t{2});
    QCOMPARE(project.materials[0].name, std::string("Gold"));
    QCOMPARE(project.spectra.size(), std::size_t{1});
    QVERIFY(project.view.compare.on && project.view.compare.pinned.has_value());
    QVERIFY(project.materials[1].texture(Channel::diffuse) &&
            project.materials[1].texture(Channel::smoothness));
    QCOMPARE(project.materials[1].occlusion, 0.4);
    QVERIFY(!window->document().is_saved());
    QCOMPARE(window->document().path(), folder.filePath(QStringLiteral("session.json")));
    QVERIFY(QTest::qWaitFor([&] { return !window->is_busy(); }, patience));
  }
};

ETAK_GUI_TEST(UserSession, "user_session")
ETAK_GUI_TEST(EditorUser, "editor_user")
#include "test_editor_user.moc"
