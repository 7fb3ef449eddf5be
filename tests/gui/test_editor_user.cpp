// SPDX-License-Identifier: Apache-2.0
// A session by keys and mouse that ends by a kill: pick gold, compare models, import a page, export a textured glTF, drop
// sets of four conventions, mix two metals by a mask, fix a finding, compare with a photograph, export MaterialX, edit on.
// The next run recovers everything.
#include <signal.h>
#include <unistd.h>

#include <QComboBox>
#include <QDir>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QProcess>
#include <QTabWidget>
#include <QToolButton>
#include <QTreeView>

#include "app/editor/panels/drop_table.h"
#include "app/editor/panels/findings_panel.h"
#include "app/editor/panels/inspector/inspector.h"
#include "app/editor/panels/mask_dialog.h"
#include "app/editor/panels/project_panel.h"
#include "app/editor/panels/view_panel.h"
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
constexpr std::size_t all_materials = 10;  // gold, glass, four sets, two metals and their mix, silver

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

  // A picture of one colour beside the project.
  QString grey(const QString& name) const {
    QImage out(16, 16, QImage::Format_RGB32);
    out.fill(QColor(130, 90, 60));
    const QString file = folder.filePath(name);
    out.save(file);
    return file;
  }

  // Drops pictures of these names and takes what the table proposes.
  void drop_set(const QStringList& names) {
    QStringList files;
    for (const QString& name : names) files << grey(name);
    QVERIFY(drop(window->viewport(), files));
    QTRY_VERIFY(window->findChild<DropTable*>() != nullptr && window->findChild<DropTable*>()->isVisible());
    QTest::keyClick(window->findChild<DropTable*>(), Qt::Key_Return);
    QTRY_VERIFY(window->findChild<DropTable*>() == nullptr);
    QVERIFY(QTest::qWaitFor([&] { return !window->is_busy(); }, patience));
  }

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
    QVERIFY(
        drop(window->viewport(), {grey(QStringLiteral("wood.png")), grey(QStringLiteral("wood_gloss.png"))}));
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

  void sets_of_four_conventions_are_dropped() {
    const std::size_t before = window->document().project().materials.size();
    drop_set({"T_Crate_D.png", "T_Crate_ORM.png", "T_Crate_N.png", "Drum_BaseMap.png", "Drum_MaskMap.png",
              "Drum_Normal.png", "Chair_Diffuse.png", "Chair_Specular.png", "Chair_Glossiness.png",
              "planks_diff_4k.png", "planks_nor_gl_4k.png", "planks_arm_4k.png"});
    const auto& materials = window->document().project().materials;
    QCOMPARE(materials.size(), before + 4);
    for (std::size_t i = before; i < materials.size(); ++i) {
      const ProjectMaterial& each = materials[i];
      const bool is_chair = each.texture(Channel::diffuse).has_value();
      QVERIFY2(each.texture(is_chair ? Channel::specular : Channel::metallic), each.name.c_str());
      QVERIFY2(each.texture(is_chair ? Channel::smoothness : Channel::normal), each.name.c_str());
    }
  }

  void two_metals_are_mixed_by_a_mask() {
    for (const char* id : {"iron", "copper"}) QVERIFY(window->use_library_material(QLatin1String(id)));
    QListView& list = window->project_panel().list();
    const int rows = list.model()->rowCount();
    list.selectionModel()->select({list.model()->index(rows - 2, 0), list.model()->index(rows - 1, 0)},
                                  QItemSelectionModel::ClearAndSelect);
    QImage mask(32, 32, QImage::Format_RGB32);
    mask.fill(Qt::black);
    for (int y = 8; y < 24; ++y)
      for (int x = 8; x < 24; ++x) mask.setPixelColor(x, y, Qt::white);
    const QString file = folder.filePath(QStringLiteral("mask.png"));
    QVERIFY(mask.save(file));
    QTest::keyClick(window.get(), Qt::Key_M, Qt::ControlModifier);
    QTRY_VERIFY(window->findChild<MaskDialog*>() != nullptr && window->findChild<MaskDialog*>()->isVisible());
    const QPointer<MaskDialog> dialog(window->findChild<MaskDialog*>());
    QVERIFY(QTest::qWaitForWindowActive(dialog, patience));
    choose_file(file);
    QTest::mouseClick(named<QPushButton>(*dialog, QStringLiteral("Choose, Mask")), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(named<QLineEdit>(*dialog, QStringLiteral("Code of material 2"))->text(),
                              QStringLiteral("255"), patience);
    auto* line = named<QLineEdit>(*dialog, QStringLiteral("Name of the new material"));
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, QStringLiteral("Inlay"));
    QTest::keyClick(line, Qt::Key_Tab);
    QVERIFY(QTest::qWaitFor([&] { return !dialog->is_busy(); }, patience));
    const auto* note = named<QLabel>(*dialog, QStringLiteral("What comes out"));
    QVERIFY2(note->text().startsWith(QStringLiteral("Each texel")), qPrintable(note->text()));
    QTest::keyClick(dialog, Qt::Key_Return);
    QVERIFY(QTest::qWaitFor([&] { return dialog.isNull(); }, patience));
    QCOMPARE(window->document().material()->name, std::string("Inlay"));
    QVERIFY(window->document().material()->texture(Channel::specular));
    QVERIFY(QTest::qWaitFor([&] { return !window->is_busy(); }, patience));
  }

  void a_finding_is_fixed() {
    // A metal with a diffuse colour: ETK108.
    QVERIFY(window->use_library_material(QStringLiteral("silver")));
    window->document().change_material(QStringLiteral("diffuse"), 0, [](ProjectMaterial& m) {
      m.diffuse = {0.3, 0.3, 0.3};
    });
    const auto row_of_rule = [&] {
      QTreeView& table = window->findings().table();
      for (int row = 0; row < table.model()->rowCount(); ++row)
        if (table.model()->index(row, FindingsModel::rule_column).data() == QStringLiteral("ETK108"))
          return table.model()->index(row, 0);
      return QModelIndex();
    };
    window->tabs().setCurrentWidget(&window->findings());
    QTRY_VERIFY_WITH_TIMEOUT(row_of_rule().isValid(), patience);
    window->findings().table().setCurrentIndex(row_of_rule());
    auto* fix = named<QToolButton>(window->findings(), QStringLiteral("Fix"));
    QTRY_VERIFY(fix->isEnabled());
    QTest::mouseClick(fix, Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(window->document().material()->diffuse, (LinearRgb{0, 0, 0}), patience);
    QTRY_VERIFY_WITH_TIMEOUT(!row_of_rule().isValid(), patience);
  }

  void a_photograph_is_compared() {
    const QString file = folder.filePath(QStringLiteral("photo.png"));
    QVERIFY(window->viewport().grab_picture().save(file));
    window->inspector_tabs().setCurrentWidget(&window->view_panel());
    choose_file(file);
    QTest::mouseClick(named<QPushButton>(window->view_panel(), QStringLiteral("Photograph as side B")),
                      Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(window->look().photograph == "photo.png", patience);
    QVERIFY(QTest::qWaitFor([&] { return !window->is_busy(); }, patience));
    const auto patch =
        window->viewport().patch_at(QRectF(window->viewport().rect()).center() + QPointF(60, 20));
    QVERIFY(patch && patch->on_object);
  }

  void materialx_is_exported() {
    window->document().set_current(1);
    const QString file = folder.filePath(QStringLiteral("wood.mtlx"));
    choose_file(file);
    QVERIFY(click_menu(
        *window, {QStringLiteral("File"), QStringLiteral("Export material"), QStringLiteral("MaterialX")}));
    QVERIFY(QTest::qWaitFor([&] { return QFile::exists(file); }, patience));
    QVERIFY(bytes_of(file).contains("open_pbr_surface"));
    QVERIFY(QTest::qWaitFor([&] { return !window->is_busy(); }, patience));
    QTest::keyClick(window.get(), Qt::Key_Escape);
  }

  void a_kill_comes_in_the_middle_of_the_work() {
    window->inspector_tabs().setCurrentWidget(&window->inspector());
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
      return kept.materials.size() == all_materials && kept.materials[1].occlusion == 0.4;
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
    QVERIFY2(question.contains(QLatin1String("session.json")) &&
                 question.contains(QStringLiteral("%1 materials").arg(all_materials)),
             qPrintable(question));
    const Project& project = window->document().project();
    QCOMPARE(project.materials.size(), std::size_t{all_materials});
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
