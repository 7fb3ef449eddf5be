// SPDX-License-Identifier: Apache-2.0
// Findings that help: badges, the texels that one is about, repair, muting with a reason, the histogram.
#include <QInputDialog>
#include <QLineEdit>
#include <QTabWidget>
#include <QToolButton>
#include <QTreeView>
#include <cmath>

#include "app/editor/panels/findings_panel.h"
#include "app/editor/panels/histogram.h"
#include "app/editor/panels/inspector/inspector.h"
#include "app/editor/panels/project_panel.h"
#include "app/editor/panels/texture_view.h"
#include "core/project/project.h"
#include "tests/gui/editor_hands.h"
#include "tests/gui/gui_test.h"

using namespace etak;
using namespace etak::editor;

namespace {

// A metal with a diffuse colour (ETK108, an error) beside a clean material, saved as a project.
void open_painted_metal(TestWindow& window) {
  Project project;
  ProjectMaterial metal, clean;
  metal.name = "metal";
  metal.specular = {0.9, 0.88, 0.85};
  metal.diffuse = {0.3, 0.3, 0.3};
  metal.alpha_mode = AlphaMode::opaque;
  clean.name = "plastic";
  clean.diffuse = {0.4, 0.1, 0.1};
  clean.alpha_mode = AlphaMode::opaque;
  project.materials = {metal, clean};
  const QString file = window.file(QStringLiteral("p.json"));
  write(file, QByteArray::fromStdString(format_project(project, file.toStdString())));
  QSignalSpy opened(window.window.get(), &Window::opened);
  window->open(file);
  QVERIFY(QTest::qWaitFor([&] { return opened.count() == 1; }, 20000));
  QVERIFY(window.settle());
}

// Marks the row of a rule in the list, and returns whether there is one.
bool mark_rule(TestWindow& window, const QString& rule) {
  window->tabs().setCurrentWidget(&window->findings());
  QTreeView& table = window->findings().table();
  const QAbstractItemModel& model = *table.model();
  for (int row = 0; row < model.rowCount(); ++row)
    if (model.index(row, FindingsModel::rule_column).data() == rule) {
      table.setCurrentIndex(model.index(row, 0));
      return true;
    }
  return false;
}

QString severity_of_rule(TestWindow& window, const QString& rule) {
  if (!mark_rule(window, rule)) return {};
  return window->findings()
      .table()
      .currentIndex()
      .siblingAtColumn(FindingsModel::severity_column)
      .data()
      .toString();
}

QModelIndex project_row(TestWindow& window, int row) {
  return window->project_panel().list().model()->index(row, 0);
}

}  // namespace

class EditorFixes : public QObject {
  Q_OBJECT

 private slots:
  void badges_stand_in_the_list_and_beside_the_field() {
    TestWindow window(true);
    show_active(window);
    open_painted_metal(window);
    QVERIFY(
        project_row(window, 0).data(Qt::AccessibleTextRole).toString().startsWith(QStringLiteral("metal, ")));
    QVERIFY(project_row(window, 0).data(Qt::ToolTipRole).toString().contains(QStringLiteral("error")));
    QCOMPARE(project_row(window, 1).data(Qt::AccessibleTextRole).toString(), QStringLiteral("plastic"));
    const auto* badge = named<QLabel>(window->inspector(), QStringLiteral("Findings about Diffuse, colour"));
    QVERIFY(badge != nullptr && !badge->text().isEmpty());
    QVERIFY2(badge->toolTip().contains(QStringLiteral("metal")), qPrintable(badge->toolTip()));
    const int y = window->inspector().diffuse().mapTo(&window->inspector(), QPoint()).y();
    window->document().set_current(1);
    QVERIFY(badge->text().isEmpty());
    QCOMPARE(window->inspector().diffuse().mapTo(&window->inspector(), QPoint()).y(), y);
  }

  void fix_makes_the_diffuse_of_a_metal_black_in_one_step_of_undo() {
    TestWindow window(true);
    show_active(window);
    open_painted_metal(window);
    QVERIFY(mark_rule(window, QStringLiteral("ETK108")));
    auto* fix = named<QToolButton>(window->findings(), QStringLiteral("Fix"));
    QVERIFY(fix->isEnabled());
    fix->setFocus();
    QTest::keyClick(fix, Qt::Key_Space);
    QVERIFY(window.settle());
    QCOMPARE(window->document().project().materials[0].diffuse, (LinearRgb{0, 0, 0}));
    QVERIFY2(told(window).contains(QStringLiteral("made diffuse black under metal")),
             qPrintable(told(window)));
    QVERIFY(severity_of_rule(window, QStringLiteral("ETK108")).isEmpty());
    window->document().undo_stack().undo();
    QCOMPARE(window->document().project().materials[0].diffuse, (LinearRgb{0.3, 0.3, 0.3}));
    QVERIFY(window.settle());
  }

  void fix_of_a_picture_writes_a_copy_and_leaves_the_original() {
    TestWindow window(true);
    show_active(window);
    open_painted_metal(window);
    QImage grey(32, 32, QImage::Format_RGB32);
    grey.fill(QColor(150, 140, 130));
    const QString file = window.file(QStringLiteral("grey.png"));
    grey.save(file);
    const QByteArray original = bytes_of(file);
    put_texture(window, Channel::diffuse, file);
    QVERIFY(window.settle());
    QVERIFY(mark_rule(window, QStringLiteral("ETK108")));
    QTest::mouseClick(named<QToolButton>(window->findings(), QStringLiteral("Fix")), Qt::LeftButton);
    QVERIFY(window.settle());
    const auto& texture = window->document().project().materials[0].texture(Channel::diffuse);
    QCOMPARE(QFileInfo(QString::fromStdString(texture->path)).fileName(),
             QStringLiteral("metal_diffuse_fixed.png"));
    QCOMPARE(QImage(QString::fromStdString(texture->path)).pixelColor(5, 5), QColor(0, 0, 0));
    QCOMPARE(bytes_of(file), original);
  }

  void fix_turns_the_green_of_a_normal_map_around_in_a_copy() {
    TestWindow window(true);
    show_active(window);
    open_painted_metal(window);
    window->document().set_current(1);
    // A relief with twisted slopes, green down; the material takes it for one of OpenGL.
    QImage map(128, 128, QImage::Format_RGB32);
    for (int y = 0; y < map.height(); ++y)
      for (int x = 0; x < map.width(); ++x) {
        const double u = 0.7 * std::cos(x / 9.0) * std::cos(y / 11.0),
                     v = 0.6 * std::sin(x / 9.0) * std::sin(y / 11.0),
                     z = 127.5 / std::sqrt(u * u + v * v + 1);
        map.setPixel(x, y, qRgb(qRound(127.5 - u * z), qRound(127.5 + v * z), qRound(127.5 + z)));
      }
    const QString file = window.file(QStringLiteral("relief.png"));
    map.save(file);
    put_texture(window, Channel::normal, file);
    // The texels told the drop which way green points; here the user says that they do not.
    window->document().change_material(QStringLiteral("green"), 1,
                                       [](ProjectMaterial& m) { m.green_down = false; });
    QVERIFY(window.settle());
    QVERIFY(mark_rule(window, QStringLiteral("ETK703")));
    auto* fix = named<QToolButton>(window->findings(), QStringLiteral("Fix"));
    QVERIFY(fix->isEnabled());
    fix->setFocus();
    QTest::keyClick(fix, Qt::Key_Space);
    QVERIFY(window.settle());
    const auto& texture = window->document().project().materials[1].texture(Channel::normal);
    QCOMPARE(QFileInfo(QString::fromStdString(texture->path)).fileName(),
             QStringLiteral("plastic_normal_fixed.png"));
    const QRgb before = map.pixel(20, 30),
               after = QImage(QString::fromStdString(texture->path)).pixel(20, 30);
    QCOMPARE(after, qRgb(qRed(before), 255 - qGreen(before), qBlue(before)));
    QVERIFY(severity_of_rule(window, QStringLiteral("ETK703")).isEmpty());
  }

  void muting_needs_a_reason_and_is_what_etak_validate_goes_by() {
    TestWindow window(true);
    show_active(window);
    open_painted_metal(window);
    QVERIFY(mark_rule(window, QStringLiteral("ETK108")));
    const auto mute = [&](const QString& reason) {
      QTest::mouseClick(named<QToolButton>(window->findings(), QStringLiteral("Mute")), Qt::LeftButton);
      auto* dialog = window->findings().findChild<QInputDialog*>();
      QVERIFY(dialog != nullptr);
      QPointer<QInputDialog> still(dialog);
      QTest::keyClicks(dialog->findChild<QLineEdit*>(), reason);
      QTest::keyClick(dialog, Qt::Key_Return);
      QVERIFY(QTest::qWaitFor([&] { return still.isNull(); }, 5000));
      QVERIFY(window.settle());
    };
    mute({});
    QCOMPARE(severity_of_rule(window, QStringLiteral("ETK108")), QStringLiteral("error"));
    QVERIFY(!QFile::exists(window.file(QStringLiteral("etak.toml"))));
    mute(QStringLiteral("a \"toy\" car"));
    const QByteArray config = bytes_of(window.file(QStringLiteral("etak.toml")));
    QVERIFY2(config.contains("reason = \"a \\\"toy\\\" car\""), config.constData());
    QCOMPARE(severity_of_rule(window, QStringLiteral("ETK108")), QStringLiteral("muted"));
    const auto* sums = named<QLabel>(window->findings(), QStringLiteral("Number of findings"));
    QVERIFY2(sums->text().startsWith(QStringLiteral("1 error,")) &&
                 sums->text().contains(QStringLiteral("1 muted")),
             qPrintable(sums->text()));
    QCOMPARE(project_row(window, 0).data(Qt::AccessibleTextRole).toString(),
             QStringLiteral("metal, 1 error"));
    // A configuration that cannot be read is told, and nothing more is written into it.
    write(window.file(QStringLiteral("etak.toml")), "[rules\n");
    window->validator().check_all();
    QVERIFY(window.settle());
    QVERIFY2(sums->text().contains(QStringLiteral("not by etak.toml: ")), qPrintable(sums->text()));
    QVERIFY(mark_rule(window, QStringLiteral("ETK108")));
    mute(QStringLiteral("again"));
    QCOMPARE(bytes_of(window.file(QStringLiteral("etak.toml"))), QByteArray("[rules\n"));
    QVERIFY(!shown_message(window).isEmpty());
  }

  void a_double_click_frames_the_texels_and_the_histogram_tells_of_them() {
    TestWindow window(true);
    show_active(window);
    open_painted_metal(window);
    window->document().set_current(1);
    // A patch in the forbidden zone, in a picture that is shown at half its size.
    QImage f0(2048, 1024, QImage::Format_RGB32);
    f0.fill(QColor(56, 56, 56));
    for (int y = 200; y < 328; ++y)
      for (int x = 1024; x < 1280; ++x) f0.setPixel(x, y, qRgb(150, 150, 150));
    const QString file = window.file(QStringLiteral("f0.png"));
    f0.save(file);
    put_texture(window, Channel::specular, file);
    QVERIFY(window.settle());
    QVERIFY(mark_rule(window, QStringLiteral("ETK101")));
    QTest::keyClick(&window->findings().table(), Qt::Key_Return);
    QVERIFY(QTest::qWaitFor([&] { return !window->texture_view().is_busy(); }, 10000));
    QCOMPARE(window->tabs().currentWidget(), static_cast<QWidget*>(&window->texture_view()));
    // The box is that of the plateau, without its outermost texels.
    const QRectF box = window->texture_view().shown_box();
    QVERIFY(QRectF(512, 100, 128, 64).contains(box) && box.width() > 126 && box.height() > 62);
    const auto* histogram = window->texture_view().findChild<Histogram*>();
    QCOMPARE(histogram->summary(),
             QStringLiteral("codes 56 to 150, mean 57.5; 1.56 % in the forbidden zone"));
    // Another material has no frame.
    window->document().set_current(0);
    QVERIFY(window.settle());
    QVERIFY(window->texture_view().shown_box().isEmpty());
  }
};

ETAK_GUI_TEST(EditorFixes, "editor_fixes")
#include "test_editor_fixes.moc"
