// SPDX-License-Identifier: Apache-2.0
// The panel of the library, and the inspector's texts about its materials, without OpenGL.
#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QTabWidget>

#include "app/curves/curves_panel.h"
#include "app/editor/panels/inspector/inspector.h"
#include "app/editor/panels/inspector/source_section.h"
#include "app/editor/panels/library_model.h"
#include "app/editor/panels/library_panel.h"
#include "core/material/embedded/unmeasured.h"
#include "tests/gui/editor_hands.h"
#include "tests/gui/gui_test.h"

using namespace etak;
using namespace etak::editor;

class EditorLibrary : public QObject {
  Q_OBJECT

 private slots:
  void clear_bodies_and_totals_are_told_and_exported() {
    TestWindow window(true);
    window->show();
    const auto told = [&] {
      for (const QLabel* each : window->inspector().source().findChildren<QLabel*>())
        if (each->accessibleName() == QStringLiteral("About the body and the roughness")) return each->text();
      return QString();
    };
    QVERIFY(window->use_library_material(QStringLiteral("water")));
    QVERIFY(window->document().material()->diffuse == LinearRgb{});
    QCOMPARE(window->document().material()->alpha, 0.0);
    QTRY_VERIFY(told().contains(QStringLiteral("the body is clear")));
    QVERIFY(told().contains(QStringLiteral("a convention, no measurement")));
    const ExportSurface water = export_surface(*window->document().material(), *window->document().library());
    QVERIFY(water.clear);
    QCOMPARE(water.opacity, 1.0);
    QVERIFY(window->use_library_material(QStringLiteral("brick")));
    QTRY_VERIFY(told().contains(QStringLiteral("total reflectance")));
    const ProjectMaterial brick = *window->document().material();
    QCOMPARE(brick.gloss.roughness(), 0.9);
    const auto total = [](const ProjectMaterial& m) { return m.diffuse.r + m.specular.r; };
    const ExportSurface surface = export_surface(brick, *window->document().library());
    QVERIFY(std::abs(total(brick) - surface.total->r) < 1e-12);
    // A typed F0 of the surface takes another share of the same total reflectance.
    ProjectMaterial shinier = brick;
    shinier.specular = {0.05, 0.05, 0.05};
    window->document().edit(window->document().current(),
                            with_measured(shinier, *window->document().library()),
                            QStringLiteral("specular colour"), 1);
    QVERIFY(std::abs(total(*window->document().material()) - surface.total->r) < 1e-12);
    QVERIFY(window->document().material()->measured.has_value());
  }

  void search_and_classes_leave_what_they_name() {
    TestWindow window(true);
    LibraryPanel& library = window->library_panel();
    const int all = library.list().model()->rowCount();
    QVERIFY(all > 150);
    library.search().setText(QStringLiteral("ALUMIN"));
    const int some = library.list().model()->rowCount();
    QVERIFY(some > 0 && some < all);
    library.search().clear();
    QCOMPARE(library.list().model()->rowCount(), all);
    for (auto* chip : library.findChildren<QAbstractButton*>())
      if (chip->text() == QLatin1String("gem")) chip->click();
    QVERIFY(library.list().model()->rowCount() > 3 && library.list().model()->rowCount() < 40);
  }

  void a_search_without_a_row_says_why_and_lists_what_is_near() {
    TestWindow window(true);
    show_active(window);
    LibraryPanel& library = window->library_panel();
    const auto* answer = named<QLabel>(library, QStringLiteral("Why nothing is found"));
    const auto* count = named<QLabel>(library, QStringLiteral("Number of materials shown"));
    const auto search = [&](const char* text) {
      library.search().setFocus();
      library.search().selectAll();
      QTest::keyClicks(&library.search(), QString::fromUtf8(text));
      QStringList rows;
      const QAbstractItemModel* model = library.list().model();
      for (int row = 0; row < std::min(20, model->rowCount()); ++row)
        rows << model->index(row, 0).data(LibraryModel::id_role).toString();
      return rows;
    };
    const Unmeasured* paint = window->document().library()->unmeasured("car paint");
    QVERIFY(paint != nullptr && !paint->nearest.empty());
    QStringList near;
    for (const std::string& each : paint->nearest) near << QString::fromStdString(each);
    QCOMPARE(search("car paint"), near);
    QVERIFY2(answer->isVisible() && answer->text().startsWith(QLatin1String("no open measurement known: ")),
             qPrintable(answer->text()));
    // The rows that are near are added by the keys that add any row.
    QTest::keyClick(&library.search(), Qt::Key_Return);
    QTest::keyClick(&library.list(), Qt::Key_Return);
    QCOMPARE(window->document().material()->measured->material, paint->nearest.front());
    QCOMPARE(search("glod").value(0), QStringLiteral("gold"));
    QVERIFY(answer->isVisible());
    QVERIFY(search("qwertzuiop").isEmpty() && count->text().startsWith(QLatin1String("0 of ")));
    QCOMPARE(search("spectralon").size(), 1);
    QVERIFY(!answer->isVisible());
    library.search().clear();
    QVERIFY(count->text().endsWith(QLatin1String(" materials")));
  }

  // The library's list and the inspector tell where the data of a material are doubtful.
  void the_quality_of_data_is_told() {
    TestWindow window(true);
    const QAbstractItemModel* model = window->library_panel().list().model();
    QString zinc;
    for (int row = 0; row < model->rowCount(); ++row)
      if (const QModelIndex at = model->index(row, 0);
          at.data(LibraryModel::id_role).toString() == QLatin1String("zinc"))
        zinc = at.data(Qt::ToolTipRole).toString();
    // Behind name and kind of the data, each flag is a sentence.
    const QStringList told = zinc.split(QLatin1Char('\n'));
    QVERIFY2(told.front().endsWith(QLatin1String("(zinc). Its data are computed.")), qPrintable(zinc));
    QCOMPARE(told.size(), 3);
    for (const QString& line : told.mid(1))
      QVERIFY2(line.front().isUpper() && line.endsWith(QLatin1Char('.')) && line.contains(QLatin1Char(' ')),
               qPrintable(zinc));
    QVERIFY(window->use_library_material(QStringLiteral("tantalum")));
    const auto* dataset = named<QComboBox>(*window, QStringLiteral("Dataset"));
    QVERIFY(dataset != nullptr);
    QVERIFY(dataset->findText(QStringLiteral("werner-2009-reels (measured; sparse; doubtful)")) > 0);
    const auto* result = named<QLabel>(*window, QStringLiteral("Measured F0, result"));
    QVERIFY(result != nullptr);
    QTRY_VERIFY(result->text().contains(QLatin1String("data computed; sparse; doubtful")));
    QVERIFY(result->text().contains(QLatin1String("doubtful: at 667 nm")));
  }

  void a_record_of_reflectance_alone_shows_that_in_place_of_n_and_k() {
    TestWindow window(true);
    window->show();
    auto* tabs = named<QTabWidget>(window->curves(), QStringLiteral("Curves"));
    tabs->setCurrentIndex(0);
    QVERIFY(window->use_library_material(QStringLiteral("cardboard")));
    QTRY_VERIFY(!tabs->isTabEnabled(0));
    QVERIFY(tabs->currentIndex() != 0);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    QTRY_COMPARE(tabs->currentIndex(), 0);
  }

  void a_surface_has_no_zone_verdict() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("cardboard")));
    const auto* result = named<QLabel>(*window, QStringLiteral("Measured F0, result"));
    QVERIFY(result != nullptr);
    QTRY_VERIFY(result->text().contains(QLatin1String("data measured")));
    QVERIFY2(!result->text().contains(QLatin1String("inside")), qPrintable(result->text()));
  }
};

ETAK_GUI_TEST(EditorLibrary, "editor_library")
#include "test_editor_library.moc"
