// SPDX-License-Identifier: Apache-2.0
// What the window shows is right and can be read: names, tooltips, paths, searches, the first window.
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QSpinBox>
#include <QStandardItemModel>
#include <QTabWidget>
#include <algorithm>

#include "app/document/press_id.h"
#include "app/editor/panels/inspector/inspector.h"
#include "app/editor/panels/inspector/texture_section.h"
#include "app/editor/panels/texture_view.h"
#include "app/editor/panels/view_panel.h"
#include "app/fields/color_field.h"
#include "app/fields/number_field.h"
#include "app/fields/path_edit.h"
#include "tests/gui/editor_hands.h"
#include "tests/gui/gui_test.h"

using namespace etak;
using namespace etak::editor;

class EditorShown : public QObject {
  Q_OBJECT

 private slots:
  void a_search_brings_what_is_called_so_first() {
    TestWindow window(true);
    show_active(window);
    LibraryPanel& library = window->library_panel();
    click_row(library.list(), library_row(library, QStringLiteral("copper")));
    for (const char* id : {"gold", "silver", "iron", "water"}) {
      library.search().setFocus();
      library.search().selectAll();
      QTest::keyClicks(&library.search(), QLatin1String(id));
      QTest::keyClick(&library.search(), Qt::Key_Return);
      QCOMPARE(library.selected(), QLatin1String(id));
      QCOMPARE(window->look().preview->measured->material, std::string(id));
    }
    QTest::keyClick(&library.list(), Qt::Key_Return);
    QCOMPARE(window->document().material()->measured->material, std::string("water"));
  }

  void an_engine_is_shown_by_its_model_with_the_difference_and_changes_no_material() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    show_active(window);
    const int steps = window->document().undo_stack().count();
    QComboBox* engine = nullptr;
    for (QComboBox* each : window->view_panel().findChildren<QComboBox*>())
      if (each->accessibleName() == QLatin1String("Engine")) engine = each;
    QVERIFY(engine != nullptr);
    QLabel* told = nullptr;
    for (QLabel* each : window->view_panel().findChildren<QLabel*>())
      if (each->accessibleName() == QLatin1String("Difference to the exact material")) told = each;
    QVERIFY(told != nullptr);
    const auto choose = [&](const QString& title) {
      engine->setCurrentIndex(engine->findText(title));
      emit engine->activated(engine->currentIndex());
    };
    choose(QStringLiteral("Unity HDRP"));
    QVERIFY(QTest::qWaitFor([&] { return told->text().startsWith(QLatin1String("dE2000")); }, 60000));
    QCOMPARE(window->viewport().state().a.specular->id, std::string_view("as-unity-hdrp"));
    choose(QStringLiteral("its own models"));
    QVERIFY(QTest::qWaitFor(
        [&] { return window->viewport().state().a.specular->id != std::string_view("as-unity-hdrp"); },
        60000));
    QVERIFY(!told->text().startsWith(QLatin1String("dE2000")));
    QCOMPARE(window->document().undo_stack().count(), steps);
  }

  void the_viewport_is_shown_alone_until_esc_and_a_material_is_copied_as_a_command() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    show_active(window);
    const auto shown = [&] {
      const auto docks = window->findChildren<QDockWidget*>();
      return std::count_if(docks.begin(), docks.end(),
                           [](const QDockWidget* each) { return each->isVisible(); });
    };
    const auto before = shown();
    action_named(*window.window, QStringLiteral("Viewport only"))->trigger();
    QCOMPARE(shown(), 0);
    QVERIFY(!window->tabs().isVisible());
    QTest::keyClick(&window->viewport(), Qt::Key_Escape);
    QCOMPARE(shown(), before);
    QVERIFY(window->tabs().isVisible());
    action_named(*window.window, QStringLiteral("Copy as command line"))->trigger();
    QVERIFY(QApplication::clipboard()->text().startsWith(QLatin1String("etak render gold ")));
  }

  // Two black bodies, a moulded plastic and a pigment: what tells their pictures apart is their roughness.
  void pictures_of_the_library_have_the_roughness_that_the_material_gets() {
    TestWindow window(true);
    window->show();
    const auto brightest = [&](const char* id) {
      const QModelIndex row = library_row(window->library_panel(), QLatin1String(id));
      (void)row.data(Qt::DecorationRole);
      if (!QTest::qWaitFor([&] { return window->thumbnails().is_idle(); }, 120000)) return -1;
      const QImage picture = qvariant_cast<QIcon>(row.data(Qt::DecorationRole)).pixmap(128).toImage();
      int out = 0;
      for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
          if (y > picture.height() / 6) out = std::max(out, qGray(picture.pixel(x, y)));
      return out;
    };
    const int plastic = brightest("plastic_abs_black"), pigment = brightest("pigment_bone_black");
    QVERIFY2(plastic > pigment + 40, qPrintable(QStringLiteral("%1 and %2").arg(plastic).arg(pigment)));
    for (const auto& [id, roughness] : {std::pair{"plastic_abs_black", 0.3}, {"pigment_bone_black", 0.9}}) {
      QVERIFY(window->use_library_material(QLatin1String(id)));
      QCOMPARE(window->document().material()->gloss.roughness(), roughness);
    }
  }

  void a_long_path_is_cut_where_it_is_shown_and_whole_where_it_counts() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    show_active(window);
    QString path = QStringLiteral("/a");
    for (int i = 0; i < 20; ++i) path += QStringLiteral("/folder %1").arg(i);
    path += QStringLiteral("/wood.png");
    put_texture(window, Channel::diffuse, path);
    const Project before = window->document().project();
    auto* line = named<PathEdit>(window->inspector(), QStringLiteral("Diffuse texture, file"));
    QVERIFY(line != nullptr);
    QCOMPARE(line->text(), path);
    QVERIFY2(line->shown_text().contains(QChar(0x2026)), qPrintable(line->shown_text()));
    QVERIFY(line->shown_text().endsWith(QLatin1String("png")));
    (void)line->grab();
    line->setFocus();
    QTest::keyClick(line, Qt::Key_Return);
    window->library_panel().search().setFocus();
    QVERIFY(window->document().project() == before);
    QVERIFY(short_path(path).size() <= 60 && short_path(path).endsWith(QLatin1String("wood.png")));
  }

  void the_three_alphas_have_names_of_their_own() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    ProjectMaterial m = *window->document().material();
    for (const Model& each : models()) {
      if (each.kind == ModelKind::diffuse) continue;
      m.specular_model = each.id;
      window->document().edit(0, m, QStringLiteral("model"), next_press_id());
      QStringList labels;
      for (const QLabel* label : window->inspector().findChildren<QLabel*>()) labels << label->text();
      const QString all = labels.join(QLatin1Char('|'));
      for (const char* name : {"Alpha opacity", "Alpha cutoff", "alpha roughness"})
        QVERIFY2(all.contains(QLatin1String(name)), name);
      QVERIFY2(!labels.contains(QStringLiteral("alpha"), Qt::CaseInsensitive), qPrintable(all));
    }
  }

  void every_parameter_has_a_tooltip() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    ProjectMaterial m = *window->document().material();
    m.specular_model = "abc-schlick";
    m.diffuse_model = "oren-nayar";
    window->document().edit(0, m, QStringLiteral("model"), next_press_id());
    window->show();
    QStringList without;
    int fields = 0;
    for (const int tab : {0, 1, 2}) {
      window->inspector_tabs().setCurrentIndex(tab);
      QWidget* page = window->inspector_tabs().currentWidget();
      for (const QWidget* each : page->findChildren<QWidget*>()) {
        const bool field = qobject_cast<const NumberField*>(each) || qobject_cast<const ColorField*>(each) ||
                           (qobject_cast<const QComboBox*>(each)) || qobject_cast<const QSpinBox*>(each) ||
                           each->inherits("QCheckBox") ||
                           (qobject_cast<const FineSpinBox*>(each) &&
                            !qobject_cast<const NumberField*>(each->parentWidget())) ||
                           (qobject_cast<const QLineEdit*>(each) &&
                            !qobject_cast<const QAbstractSpinBox*>(each->parentWidget()) &&
                            !qobject_cast<const QComboBox*>(each->parentWidget()));
        if (!field) continue;
        ++fields;
        QString tip;
        for (const QWidget* up = each; up != page && tip.isEmpty(); up = up->parentWidget())
          tip = up->toolTip();
        if (tip.isEmpty()) without << each->accessibleName();
      }
    }
    QVERIFY2(fields > 50, qPrintable(QString::number(fields)));
    QVERIFY2(without.isEmpty(), qPrintable(without.join(QLatin1Char('\n'))));
  }

  void the_first_window_fits_the_screen_and_has_an_icon() {
    TestWindow window(true);
    QVERIFY(!window->windowIcon().isNull());
    const QSize room = window->screen()->availableSize();
    QVERIFY2(window->width() <= room.width() && window->height() <= room.height(),
             qPrintable(QStringLiteral("%1x%2 of %3x%4; least %5x%6")
                            .arg(window->width())
                            .arg(window->height())
                            .arg(room.width())
                            .arg(room.height())
                            .arg(window->minimumSizeHint().width())
                            .arg(window->minimumSizeHint().height())));
  }

  void a_new_material_is_opaque_and_its_file_says_so() {
    TestWindow window(true);
    show_active(window);
    QTest::keyClick(window.window.get(), Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(window->document().material() != nullptr);
    QVERIFY(window->document().material()->alpha_mode == AlphaMode::opaque);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    QVERIFY(window->document().material()->alpha_mode == AlphaMode::opaque);
    // Viewport and exports ignore the alpha of an opaque material.
    ProjectMaterial m = *window->document().material();
    m.alpha = 0.5;
    window->document().edit(1, m, QStringLiteral("alpha"), next_press_id());
    QVERIFY(!window->inspector().alpha().isEnabled());
    QCOMPARE(window->document().surface_of(m).opacity, 1.0);
    QCOMPARE(surface_of(m, *window->document().library()).opacity, 1.0);
    QCOMPARE(export_surface(m, *window->document().library()).opacity, 1.0);
    m.alpha_mode = AlphaMode::blend;
    window->document().edit(1, m, QStringLiteral("mode"), next_press_id());
    QVERIFY(window->inspector().alpha().isEnabled());
    QCOMPARE(window->document().surface_of(m).opacity, 0.5);
    QCOMPARE(export_surface(m, *window->document().library()).opacity, 0.5);
    window->document().undo_stack().undo();
    window->document().undo_stack().undo();
    // A clear body shows the background.
    QVERIFY(window->use_library_material(QStringLiteral("water")));
    QVERIFY(window->document().material()->alpha_mode == AlphaMode::blend);
    const Project& project = window->document().project();
    const std::string text = format_project(project, "");
    QVERIFY(parse_project(text, "p.json").materials[0].alpha_mode == AlphaMode::opaque);
    QVERIFY(QByteArray::fromStdString(text).count("opaque") == 2);
  }

  void models_stand_in_families_by_their_titles() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    std::size_t listed = 0;
    for (const char* name : {"Specular model", "Diffuse model"}) {
      auto* box = named<QComboBox>(window->inspector(), QLatin1String(name));
      QVERIFY(box != nullptr);
      const auto* rows = qobject_cast<QStandardItemModel*>(box->model());
      QString family;
      int families = 0;
      for (int row = 1; row < box->count(); ++row) {  // the first row is "none"
        if (!rows->item(row)->isEnabled()) {
          family = box->itemText(row);
          ++families;
          QVERIFY(!box->itemData(row).isValid());
          continue;
        }
        ++listed;
        const Model* model = find_model(box->itemData(row).toString().toStdString());
        QVERIFY2(model != nullptr && !family.isEmpty(), qPrintable(box->itemText(row)));
        QCOMPARE(box->itemText(row).toStdString(), std::string(model->title));
        QVERIFY(box->itemData(row, Qt::ToolTipRole).toString().contains(box->itemData(row).toString()));
        QCOMPARE(family.startsWith(QLatin1String("Sch")), model->id.starts_with("schueler"));
      }
      QVERIFY(families > 1 || box->count() < 8);
    }
    QCOMPARE(listed, models().size());
    // The box of side B has the same rows below its first one.
    const auto* of_a = named<QComboBox>(window->inspector(), QStringLiteral("Specular model"));
    const auto* of_b = named<QComboBox>(window->view_panel(), QStringLiteral("Specular model of side B"));
    QVERIFY(of_b != nullptr);
    QCOMPARE(of_b->count(), of_a->count());
    for (int row = 1; row < of_b->count(); ++row) {
      QCOMPARE(of_b->itemText(row), of_a->itemText(row));
      QCOMPARE(of_b->itemData(row), of_a->itemData(row));
    }
    // The keys step from model to model, over the names of families.
    auto* box = named<QComboBox>(window->inspector(), QStringLiteral("Specular model"));
    show_active(window);
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Home);
    QCOMPARE(window->document().material()->specular_model, std::string());
    QTest::keyClick(box, Qt::Key_Down);
    QCOMPARE(window->document().material()->specular_model, std::string("schueler-full"));
    auto* about = named<QLabel>(window->inspector(), QStringLiteral("About the model"));
    QVERIFY2(about->text().contains(QLatin1String("schueler-full")), qPrintable(about->text()));
  }

  void flags_of_data_are_sentences() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("tantalum")));
    const auto* result = named<QLabel>(window->inspector(), QStringLiteral("Measured F0, result"));
    QVERIFY(result != nullptr);
    QTRY_VERIFY(result->text().contains(QLatin1String("The data are doubtful: ")));
    QStringList lines = result->text().split(QLatin1Char('\n'));
    QVERIFY2(lines.contains(QStringLiteral("The numbers come from theory alone; nothing was measured.")),
             qPrintable(result->text()));
    // Behind the values and the kind of the data, each line is a sentence.
    for (const QString& line : lines.mid(2))
      QVERIFY2(line.front().isUpper() && line.endsWith(QLatin1Char('.')), qPrintable(line));
  }

  void a_and_b_are_named_and_the_difference_ends_with_the_comparison() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    show_active(window);
    QVERIFY(window.settle());
    const auto& state = window->viewport().state();
    QVERIFY(QByteArray::fromStdString(state.a.label).startsWith("Gold, "));
    QTest::keyClick(window.window.get(), Qt::Key_T, Qt::ControlModifier);
    QTRY_VERIFY(state.split);
    QVERIFY(QByteArray::fromStdString(state.a.label).startsWith("A: Gold, "));
    QVERIFY(QByteArray::fromStdString(state.b.label).startsWith("B: Gold, "));
    QTest::mouseMove(&window->viewport(), window->viewport().rect().center());
    const auto* under = named<QLabel>(*window, QStringLiteral("Under the cursor"));
    const auto* difference = named<QLabel>(*window, QStringLiteral("Difference under the cursor"));
    QTRY_VERIFY(under->text().contains(QLatin1String("B - A")));
    QVERIFY(difference->text().contains(QLatin1String("B - A")));
    QVERIFY(window->viewport().readout().contains(QLatin1String("difference")));
    QTest::keyClick(window.window.get(), Qt::Key_T, Qt::ControlModifier);
    QVERIFY(under->text().isEmpty() && difference->text().isEmpty());
    QTRY_VERIFY(!state.split);
    QVERIFY2(!window->viewport().readout().contains(QLatin1String("difference")),
             qPrintable(window->viewport().readout()));
  }

  void lights_and_scales_have_units() {
    TestWindow window(true);
    window->show();
    window->inspector_tabs().setCurrentIndex(1);
    const QWidget& page = *window.window;
    // The text beside a field.
    const auto label = [&](const char* field) {
      const QWidget* wanted = named<QWidget>(page, QLatin1String(field));
      for (const QLabel* each : page.findChildren<QLabel*>())
        if (wanted != nullptr && each->buddy() == wanted) return each->text();
      return QString();
    };
    const auto set = [&](LightKind kind, bool pi_scaled) {
      ProjectView view = window->document().project().view;
      view.lights.lights = {Light{}};
      view.lights.lights[0].kind = kind;
      view.lights.pi_scaled = pi_scaled;
      window->document().edit_view(view, QStringLiteral("lights"), next_press_id());
    };
    set(LightKind::directional, false);
    QCOMPARE(label("Intensity, field"), QStringLiteral("E W/m\u00b2"));
    set(LightKind::directional, true);
    QCOMPARE(label("Intensity, field"), QStringLiteral("E/\u03c0 W/m\u00b2"));
    set(LightKind::point, false);
    QCOMPARE(label("Intensity, field"), QStringLiteral("I W/sr"));
    set(LightKind::spot, true);
    QCOMPARE(label("Intensity, field"), QStringLiteral("I/\u03c0 W/sr"));
    QCOMPARE(label("Light place"), QStringLiteral("Place r"));
    QCOMPARE(label("Inner cone, field"), QStringLiteral("Inner \u00b0"));
    QCOMPARE(label("Outer cone, field"), QStringLiteral("Outer \u00b0"));
    QCOMPARE(label("Environment scale, field"), QStringLiteral("Scale \u00d7"));
    QCOMPARE(label("Environment turn, field"), QStringLiteral("Turn \u00b0"));
    QCOMPARE(label("Exposure, field"), QStringLiteral("Exposure EV"));
  }

  void the_texel_under_the_cursor_is_told_and_arrow_keys_move_it() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    QImage two(2, 1, QImage::Format_RGB32);
    two.setPixelColor(0, 0, QColor(255, 228, 156));  // gold's F0
    two.setPixelColor(1, 0, QColor(150, 150, 150));
    const QString file = window.file(QStringLiteral("two_specular.png"));
    QVERIFY(two.save(file));
    put_texture(window, Channel::specular, file);
    show_active(window);
    window->tabs().setCurrentWidget(&window->texture_view());
    window->texture_view().show_channel(Channel::specular);
    QTRY_VERIFY_WITH_TIMEOUT(
        window->texture_view().textures() != nullptr && !window->texture_view().is_busy(), 60000);
    auto* sheet = named<QWidget>(window->texture_view(), QStringLiteral("Texture picture"));
    const auto* texel = named<QLabel>(window->texture_view(), QStringLiteral("Texel under the cursor"));
    QVERIFY(sheet != nullptr && texel != nullptr);
    QCOMPARE(texel->text().trimmed(), QString());
    QTest::keyClick(sheet, Qt::Key_Right);
    QVERIFY2(texel->text().startsWith(
                 QLatin1String("texel 1, 0: code 150 150 150 (#969696), linear 0.305 0.305 0.305")) &&
                 texel->text().contains(QLatin1String("inside the zone")),
             qPrintable(texel->text()));
    QTest::keyClick(sheet, Qt::Key_Left);
    QVERIFY2(texel->text().startsWith(QLatin1String("texel 0, 0: code 255 228 156")) &&
                 texel->text().contains(QLatin1String("above the zone; nearest Gold")),
             qPrintable(texel->text()));
    // The cursor does the same, and leaving takes the text away.
    const QPoint right = sheet->rect().center() + QPoint(4, 0);
    QMouseEvent move(QEvent::MouseMove, right, sheet->mapToGlobal(right), Qt::NoButton, Qt::NoButton,
                     Qt::NoModifier);
    QCoreApplication::sendEvent(sheet, &move);
    QVERIFY2(texel->text().startsWith(QLatin1String("texel 1, 0")), qPrintable(texel->text()));
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(sheet, &leave);
    QCOMPARE(texel->text().trimmed(), QString());
  }
};

ETAK_GUI_TEST(EditorShown, "editor_shown")
#include "test_editor_shown.moc"
