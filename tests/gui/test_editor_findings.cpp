// SPDX-License-Identifier: Apache-2.0
// The list of findings: what it says, of what, and where it leads.
#include <QDockWidget>
#include <QTabWidget>
#include <QTreeView>

#include "app/document/press_id.h"
#include "app/editor/panels/findings_panel.h"
#include "app/editor/panels/inspector/inspector.h"
#include "tests/gui/editor_hands.h"
#include "tests/gui/gui_test.h"

using namespace etak;
using namespace etak::editor;

namespace {

QString black_picture(TestWindow& window) {
  QImage out(8, 8, QImage::Format_RGB32);
  out.fill(Qt::black);
  const QString file = window.file(QStringLiteral("black.png"));
  out.save(file);
  return file;
}

}  // namespace

class EditorFindings : public QObject {
  Q_OBJECT

 private slots:
  void findings_say_what_is_wrong_and_stay_marked_when_checked_again() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    show_active(window);
    const auto* sums = named<QLabel>(window->findings(), QStringLiteral("Number of findings"));
    QVERIFY(sums != nullptr);
    QVERIFY2(sums->text().contains(QLatin1String("checking")), qPrintable(sums->text()));
    for (int row = 0; row < 2; ++row) {
      ProjectMaterial m = window->document().project().materials[static_cast<std::size_t>(row)];
      m.measured.reset();
      m.specular = {0.3, 0.3, 0.3};
      window->document().edit(row, m, QStringLiteral("colour"), next_press_id());
    }
    QVERIFY(window.settle());
    QVERIFY2(!sums->text().contains(QLatin1String("checking")), qPrintable(sums->text()));
    QTreeView& table = window->findings().table();
    QAbstractItemModel& rows = *table.model();
    const auto row_of = [&](const QString& material) {
      for (int row = 0; row < rows.rowCount(); ++row)
        if (rows.index(row, 1).data() == QLatin1String("ETK101") && rows.index(row, 2).data() == material)
          return rows.index(row, 0);
      return QModelIndex();
    };
    const QString second = QString::fromStdString(window->document().project().materials[1].name);
    QVERIFY(row_of(second).isValid());
    QVERIFY2(rows.index(row_of(second).row(), 3)
                 .data()
                 .toString()
                 .startsWith(QLatin1String("F0 lies where no common material is: F0 0.3")),
             qPrintable(rows.index(row_of(second).row(), 3).data().toString()));
    table.setCurrentIndex(row_of(second));
    const auto* advice = named<QLabel>(window->findings(), QStringLiteral("Advice"));
    QVERIFY(!advice->text().isEmpty());
    QSignalSpy resets(&rows, &QAbstractItemModel::modelReset);
    const QPersistentModelIndex marked(table.currentIndex());
    // Another number of the same material, and the first one's finding gone by undo of its colour.
    ProjectMaterial m = window->document().project().materials[1];
    m.specular = {0.33, 0.33, 0.33};
    window->document().edit(1, m, QStringLiteral("colour"), next_press_id());
    m = window->document().project().materials[0];
    m.specular = {0.9, 0.7, 0.3};
    window->document().edit(0, m, QStringLiteral("colour"), next_press_id());
    QVERIFY(window.settle());
    QVERIFY(!row_of(QString::fromStdString(window->document().project().materials[0].name)).isValid());
    QCOMPARE(resets.count(), 0);
    QVERIFY(marked.isValid() && table.currentIndex() == marked && marked == row_of(second));
    QVERIFY(rows.index(marked.row(), 3).data().toString().contains(QLatin1String("F0 0.33")));
    QVERIFY(!advice->text().isEmpty());
  }

  void a_measured_f0_in_the_zone_is_a_note_that_names_the_other_datasets() {
    TestWindow window(true);
    // Titanium of another dataset, as its page comes in: F0 about 0.38.
    const QString page = window.file(QStringLiteral("Palm.yml"));
    write(page,
          "REFERENCES: |\n    A. Tester. Test data. J. Tests 1, 2 (2018)\nDATA:\n  - type: tabulated nk\n"
          "    data: |\n        0.3 1.5 1.9\n        0.5 1.5 1.9\n        0.9 1.5 1.9\n");
    QSignalSpy opened(window.window.get(), &Window::opened);
    window->import({page});
    QVERIFY(QTest::qWaitFor([&] { return opened.count() == 1; }, 20000));
    QVERIFY(window.settle());
    const ProjectMaterial imported = *window->document().material();
    const auto zone = [&]() -> const Finding* {
      for (const auto& [name, list] : window->validator().findings())
        for (const Finding& each : list)
          if (each.rule == "ETK101") return &each;
      return nullptr;
    };
    QVERIFY(zone() != nullptr);
    QVERIFY2(zone()->severity == Severity::info, zone()->message.c_str());
    QVERIFY2(QString::fromStdString(zone()->message).contains(QLatin1String("it is measured")),
             zone()->message.c_str());
    // The same colour, typed, is the error that it was.
    ProjectMaterial typed = imported;
    typed.measured.reset();
    window->document().edit(0, typed, QStringLiteral("typed"), next_press_id());
    QVERIFY(window.settle());
    QVERIFY(zone() != nullptr && zone()->severity == Severity::error);
  }

  // What nothing in the material reads has no findings.
  void findings_are_about_what_the_material_uses() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("iron")));
    ProjectMaterial m = *window->document().material();
    const Material iron = *window->document().library()->find("iron");
    for (const Dataset& each : iron.datasets) {
      m.measured->dataset = each.id;
      window->document().edit(0, m, QStringLiteral("dataset"), next_press_id());
      QVERIFY(window.settle());
      for (const auto& [name, findings] : window->validator().findings())
        for (const Finding& finding : findings)
          if (finding.pointer.starts_with("/datasets/"))
            QVERIFY2(
                iron.datasets[static_cast<std::size_t>(std::stoi(finding.pointer.substr(10)))].id == each.id,
                finding.message.c_str());
    }
    // In the mode opaque, an alpha is read by nothing.
    const auto has_alpha_finding = [&] {
      for (const auto& [name, findings] : window->validator().findings())
        for (const Finding& finding : findings)
          if (finding.rule.starts_with("ETK5")) return true;
      return false;
    };
    m.measured.reset();
    m.diffuse = {0.3, 0.3, 0.3};
    m.specular = {0.04, 0.04, 0.04};
    m.texture(Channel::alpha) = ImageSource{black_picture(window).toStdString(), "r", ""};
    m.alpha_mode = AlphaMode::blend;
    window->document().edit(0, m, QStringLiteral("alpha"), next_press_id());
    QVERIFY(window.settle());
    QVERIFY(has_alpha_finding());
    m.alpha_mode = AlphaMode::opaque;
    window->document().edit(0, m, QStringLiteral("mode"), next_press_id());
    QVERIFY(window.settle());
    QVERIFY(!has_alpha_finding());
  }

  void a_double_click_on_a_finding_goes_to_what_it_is_about() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    QVERIFY(window->use_library_material(QStringLiteral("titanium")));
    ProjectMaterial m = *window->document().material();
    m.measured.reset();
    m.name = "dark";
    m.diffuse = {0.001, 0.001, 0.001};
    m.specular = {0.3, 0.3, 0.3};
    m.texture(Channel::gloss) = ImageSource{window.file(QStringLiteral("missing.png")).toStdString(), "", ""};
    window->document().edit(1, m, QStringLiteral("dark"), next_press_id());
    show_active(window);
    QVERIFY(window.settle());
    QTest::keyClick(window.window.get(), Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(window->tabs().currentWidget(), static_cast<QWidget*>(&window->findings()));
    QVERIFY(window->tabs().tabText(window->tabs().currentIndex()).startsWith("Findings ("));
    auto* table = named<QTreeView>(window->findings(), QStringLiteral("List of findings"));
    QVERIFY(table != nullptr);
    const auto go = [&](const char* rule) {
      window->document().set_current(0);
      window->inspector_tabs().setCurrentIndex(1);
      window->findChild<QDockWidget*>(QStringLiteral("inspector"))->close();
      for (int row = 0; row < table->model()->rowCount(); ++row) {
        const QModelIndex at = table->model()->index(row, FindingsModel::rule_column);
        if (at.data().toString() != QLatin1String(rule)) continue;
        table->scrollTo(at);
        const QPoint middle = table->visualRect(at).center();
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, middle);
        QTest::mouseDClick(table->viewport(), Qt::LeftButton, {}, middle);
        QWidget* at_focus = QApplication::focusWidget();
        return at_focus == nullptr ? QString() : at_focus->accessibleName();
      }
      return QStringLiteral("no finding of ") + QLatin1String(rule);
    };
    QCOMPARE(go("ETK001"), QStringLiteral("Gloss texture, file"));
    QCOMPARE(window->document().current(), 1);
    QVERIFY(window->inspector().isVisible());
    m.texture(Channel::gloss).reset();
    window->document().edit(1, m, QStringLiteral("gloss"), next_press_id());
    QVERIFY(window.settle());
    QCOMPARE(go("ETK101"), QStringLiteral("Specular, red, linear"));
    // A finding about the record of another material leads to the record.
    m = window->document().project().materials[0];
    m.measured->material = "titanium";
    window->document().edit(0, m, QStringLiteral("record"), next_press_id());
    QVERIFY(window.settle());
    QCOMPARE(go("ETK608"), QStringLiteral("Dataset"));
    QCOMPARE(window->document().current(), 0);
  }
};

ETAK_GUI_TEST(EditorFindings, "editor_findings")
#include "test_editor_findings.moc"
