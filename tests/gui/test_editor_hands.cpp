// SPDX-License-Identifier: Apache-2.0
// Keys, wheel and clicks of a user must not change anything by accident.
#include <QComboBox>
#include <QLineEdit>
#include <QListView>
#include <QPlainTextEdit>
#include <QSpinBox>
#include <QTabWidget>
#include <QToolButton>

#include "app/editor/fields/color_field.h"
#include "app/editor/fields/number_field.h"
#include "app/editor/fields/path_edit.h"
#include "app/editor/fields/press_id.h"
#include "app/editor/panels/inspector.h"
#include "app/editor/panels/library_panel.h"
#include "app/editor/panels/preview_bar.h"
#include "app/editor/panels/project_panel.h"
#include "app/editor/panels/source_section.h"
#include "app/editor/panels/texture_section.h"
#include "tests/gui/editor_hands.h"
#include "tests/gui/gui_test.h"

using namespace etak;
using namespace etak::editor;

namespace {

void click_slider(FieldSlider& slider, double share) {
  QTest::mouseClick(&slider, Qt::LeftButton, {},
                    QPoint(static_cast<int>(share * slider.width()), slider.height() / 2));
}

// All widgets on the visible page that can be edited.
QWidgetList fields_of(QWidget& page) {
  QWidgetList out;
  for (QWidget* each : page.findChildren<QWidget*>())
    if (each->isVisible() && each->isEnabled() &&
        (qobject_cast<QAbstractSpinBox*>(each) != nullptr || qobject_cast<QSlider*>(each) != nullptr ||
         qobject_cast<QComboBox*>(each) != nullptr ||
         (qobject_cast<QLineEdit*>(each) != nullptr &&
          qobject_cast<QAbstractSpinBox*>(each->parentWidget()) == nullptr)))
      out << each;
  return out;
}

int steps_of(TestWindow& window) {
  return window->document().undo_stack().index();
}

QModelIndex library_row(LibraryPanel& library, const QString& id) {
  const QAbstractItemModel* model = library.list().model();
  for (int row = 0; row < model->rowCount(); ++row)
    if (model->index(row, 0).data(LibraryModel::id_role).toString() == id) return model->index(row, 0);
  return {};
}

void click_row(QListView& list, const QModelIndex& row) {
  list.scrollTo(row);
  QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualRect(row).center());
}

}  // namespace

class EditorHands : public QObject {
  Q_OBJECT

 private slots:
  void the_wheel_over_fields_without_the_focus_edits_nothing() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    window->document().edit_wedge({true, "gloss", 5}, QStringLiteral("wedge"), next_press_id());
    show_active(window);
    const Project before = window->document().project();
    const int steps = steps_of(window);
    int fields = 0;
    for (const int tab : {0, 1, 2}) {
      window->inspector_tabs().setCurrentIndex(tab);
      window->library_panel().search().setFocus();
      for (QWidget* each : fields_of(*window->inspector_tabs().currentWidget())) {
        for (int i = 0; i < 3; ++i) turn_wheel(*each, -1);
        ++fields;
      }
    }
    QVERIFY2(fields > 40, qPrintable(QString::number(fields)));
    QVERIFY(window->document().project() == before);
    QCOMPARE(steps_of(window), steps);
    // With the focus the wheel edits; turns that follow each other closely are one step of undo.
    window->inspector_tabs().setCurrentIndex(0);
    for (QWidget* each : {static_cast<QWidget*>(&window->inspector().gloss().box()),
                          static_cast<QWidget*>(&window->inspector().gloss().slider())}) {
      const double gloss = window->document().material()->gloss;
      each->setFocus();
      for (int i = 0; i < 3; ++i) turn_wheel(*each, -1);
      QVERIFY(window->document().material()->gloss < gloss);
      QTest::keyClick(each, Qt::Key_Z, Qt::ControlModifier);
      QCOMPARE(double{window->document().material()->gloss}, gloss);
    }
  }

  void colours_begin_at_0() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    show_active(window);
    auto* red = named<FineSpinBox>(window->inspector().diffuse(), QStringLiteral("Diffuse, red, linear"));
    QVERIFY(red != nullptr);
    const int steps = steps_of(window);
    red->setFocus();
    for (int i = 0; i < 3; ++i) turn_wheel(*red, -1);
    QTest::keyClick(red, Qt::Key_Down);
    QTest::keyClick(red, Qt::Key_PageDown);
    QCOMPARE(window->document().material()->diffuse, (LinearRgb{0, 0, 0}));
    QCOMPARE(steps_of(window), steps);
    auto* f0 = named<FineSpinBox>(window->inspector().specular(), QStringLiteral("Specular, blue, linear"));
    f0->setFocus();
    f0->selectAll();
    QTest::keyClicks(f0, QStringLiteral("0.001"));
    QTest::keyClick(f0, Qt::Key_Return);
    QTest::keyClick(f0, Qt::Key_Down);
    QCOMPARE(window->document().material()->specular.b, 0.0);
    // A colour out of gamut is shown as it is, and showing it does not change it.
    ProjectMaterial m = *window->document().material();
    m.specular = {0.5, 0.4, -0.1};
    window->document().edit(0, m, QStringLiteral("colour"), next_press_id());
    QCOMPARE(f0->value(), -0.1);
    QTest::keyClick(f0, Qt::Key_Return);
    QCOMPARE(window->document().material()->specular.b, -0.1);
    window->document().undo_stack().undo();
    QCOMPARE(f0->minimum(), 0.0);
  }

  void a_click_in_the_groove_goes_there() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    show_active(window);
    FieldSlider& slider = window->inspector().gloss().slider();
    const int steps = steps_of(window);
    click_slider(slider, 0.25);
    QVERIFY2(std::abs(window->document().material()->gloss - 0.25) < 0.08,
             qPrintable(QString::number(window->document().material()->gloss)));
    QCOMPARE(steps_of(window), steps + 1);
    // A click and the drag that follows it are one step of undo, and the slider ends at the cursor.
    drag(slider, QPoint(slider.width() * 3 / 4, slider.height() / 2),
         QPoint(slider.width() / 2, slider.height() / 2));
    QVERIFY(std::abs(window->document().material()->gloss - 0.5) < 0.08);
    QCOMPARE(steps_of(window), steps + 2);
    QTest::keyClick(&slider, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(std::abs(window->document().material()->gloss - 0.25) < 0.08);
  }

  void held_arrow_keys_are_one_step_of_undo() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    show_active(window);
    NumberField& gloss = window->inspector().gloss();
    for (QWidget* each : {static_cast<QWidget*>(&gloss.box()), static_cast<QWidget*>(&gloss.slider())}) {
      const double before = window->document().material()->gloss;
      const int steps = steps_of(window);
      each->setFocus();
      for (int i = 0; i < 6; ++i) QTest::keyClick(each, Qt::Key_Down);
      QVERIFY(window->document().material()->gloss < before);
      QCOMPARE(steps_of(window), steps + 1);
      QTest::keyClick(each, Qt::Key_Z, Qt::ControlModifier);
      QCOMPARE(double{window->document().material()->gloss}, before);
    }
  }

  void undo_and_redo_work_wherever_the_focus_is() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    show_active(window);
    FineSpinBox& gloss = window->inspector().gloss().box();
    gloss.setFocus();
    gloss.selectAll();
    QTest::keyClicks(&gloss, QStringLiteral("0.4"));
    QTest::keyClick(&gloss, Qt::Key_Return);
    QCOMPARE(double{window->document().material()->gloss}, 0.4);
    QWidgetList places = fields_of(window->inspector());
    places << &window->library_panel().search() << &window->library_panel().list()
           << &window->project_panel().list() << &window->viewport() << window.window.get();
    window->tabs().setCurrentIndex(1);
    places << window->tabs().currentWidget();
    for (QWidget* each : places) {
      each->setFocus();
      QWidget* at = QApplication::focusWidget() != nullptr ? QApplication::focusWidget() : each;
      const QString where =
          QString::fromLatin1(each->metaObject()->className()) + QLatin1Char(' ') + each->accessibleName();
      QTest::keyClick(at, Qt::Key_Z, Qt::ControlModifier);
      QVERIFY2(window->document().material()->gloss == 0.75, qPrintable(where));
      QTest::keyClick(at, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
      QVERIFY2(window->document().material()->gloss == 0.4, qPrintable(where));
    }
    // Undo first takes back a text that is being typed, which is no step of the document.
    gloss.setFocus();
    gloss.selectAll();
    QTest::keyClicks(&gloss, QStringLiteral("0.9"));
    for (int i = 0; i < 4 && gloss.is_typed_in(); ++i)
      QTest::keyClick(&gloss, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(gloss.text(), QStringLiteral("0.4"));
    QCOMPARE(double{window->document().material()->gloss}, 0.4);
    QTest::keyClick(&gloss, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(double{window->document().material()->gloss}, 0.75);
  }

  void a_field_that_is_left_as_it_was_changes_nothing() {
    TestWindow window(true);
    for (const char* id : {"gold", "brick", "water"}) {
      QVERIFY(window->use_library_material(QLatin1String(id)));
      ProjectMaterial m = *window->document().material();
      // The numbers have more digits than a field shows.
      m.gloss = 0.123456789;
      m.alpha = 0.987654321;
      m.alpha_mode = AlphaMode::mask;
      window->document().edit(window->document().current(), m, QStringLiteral("numbers"), next_press_id());
      show_active(window);
      const Project before = window->document().project();
      const int steps = steps_of(window);
      for (const int tab : {0, 1, 2}) {
        window->inspector_tabs().setCurrentIndex(tab);
        for (QWidget* each : fields_of(*window->inspector_tabs().currentWidget())) {
          const QString which = each->accessibleName();
          each->setFocus();
          QTest::keyClick(each, Qt::Key_Return);
          QTest::keyClick(each, Qt::Key_Tab);
          QVERIFY2(window->document().project() == before, qPrintable(which));
        }
      }
      QCOMPARE(steps_of(window), steps);
    }
  }

  void letting_go_of_a_measurement_is_said_and_reset_goes_back_to_it() {
    TestWindow window(true);
    for (const auto& [id, field_name] : {std::pair{"gold", "Specular"}, {"brick", "Diffuse"}}) {
      QVERIFY(window->use_library_material(QLatin1String(id)));
      show_active(window);
      const ProjectMaterial measured = *window->document().material();
      QVERIFY(measured.measured);
      auto* red = named<FineSpinBox>(window->inspector(),
                                     QLatin1String(field_name) + QStringLiteral(", red, linear"));
      QVERIFY(red != nullptr);
      red->setFocus();
      red->selectAll();
      QTest::keyClicks(red, QStringLiteral("0.5"));
      QTest::keyClick(red, Qt::Key_Return);
      QVERIFY(!window->document().material()->measured);
      QVERIFY2(told(window).contains(QLatin1String("measured no longer")), qPrintable(told(window)));
      // After a rename, the measurement can still be restored.
      ProjectMaterial renamed = *window->document().material();
      renamed.name += " by hand";
      window->document().edit(window->document().current(), renamed, QStringLiteral("rename"),
                              next_press_id());
      auto* reset =
          named<QToolButton>(window->inspector(), QStringLiteral("Reset ") + QLatin1String(field_name));
      QVERIFY(reset != nullptr);
      QTest::mouseClick(reset, Qt::LeftButton);
      ProjectMaterial expected = measured;
      expected.name = renamed.name;
      QVERIFY(*window->document().material() == expected);
      // A second reset changes nothing.
      const int steps = steps_of(window);
      QTest::mouseClick(reset, Qt::LeftButton);
      QCOMPARE(steps_of(window), steps);
    }
  }

  void a_preview_is_marked_read_and_ended() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    show_active(window);
    LibraryPanel& library = window->library_panel();
    const Project before = window->document().project();
    const auto* bar = window->findChild<PreviewBar*>();
    QVERIFY(bar != nullptr && !bar->isVisible());
    // Neither the focus that comes by Tab nor a search starts a preview.
    library.list().setFocus(Qt::TabFocusReason);
    QVERIFY(!window->look().preview);
    library.search().setFocus();
    QTest::keyClicks(&library.search(), QStringLiteral("co"));
    library.search().clear();
    QVERIFY(!window->look().preview);

    click_row(library.list(), library_row(library, QStringLiteral("gold")));
    QVERIFY(window->look().preview);
    QVERIFY(bar->isVisible());
    const auto* text = named<QLabel>(*bar, QStringLiteral("What is looked at"));
    QVERIFY(text->text().contains(QLatin1String("Gold: preview, not in the project")));
    // The inspector shows the numbers and the citation of the previewed material, which cannot be edited.
    QCOMPARE(named<QLineEdit>(window->inspector(), QStringLiteral("Name of the material"))->text(),
             QStringLiteral("Gold"));
    QVERIFY(window->inspector().specular().color().r > 1);
    QVERIFY(!window->inspector().specular().isEnabled());
    const auto* citation = named<QLabel>(window->inspector(), QStringLiteral("Citation"));
    QTRY_VERIFY(citation->text().contains(QLatin1String("Johnson")) || citation->text().size() > 20);
    QVERIFY(citation->isEnabled() && citation->isVisible());
    QVERIFY(window->document().project() == before);

    QTest::keyClick(&library.list(), Qt::Key_Escape);
    QVERIFY(!window->look().preview && !bar->isVisible());
    QVERIFY(window->inspector().specular().isEnabled());
    QCOMPARE(named<QLineEdit>(window->inspector(), QStringLiteral("Name of the material"))->text(),
             QString::fromStdString(window->document().material()->name));

    // A click on the same row starts the preview again; a click on the current row of the project ends it.
    click_row(library.list(), library_row(library, QStringLiteral("gold")));
    QVERIFY(window->look().preview);
    QListView& project = window->project_panel().list();
    click_row(project, project.model()->index(0, 0));
    QVERIFY(!window->look().preview);

    // Add puts the previewed material into the project.
    click_row(library.list(), library_row(library, QStringLiteral("gold")));
    QTest::mouseClick(
        named<QToolButton>(*bar, QStringLiteral("Add the material that is looked at to the project")),
        Qt::LeftButton);
    QVERIFY(!window->look().preview && !bar->isVisible());
    QCOMPARE(window->document().material()->name, std::string("Gold"));
  }

  void a_name_is_edited_by_f2_or_a_double_click_only() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    show_active(window);
    QListView& list = window->project_panel().list();
    const QModelIndex row = list.model()->index(0, 0);
    const auto editor = [&] { return list.viewport()->findChild<QLineEdit*>(); };
    click_row(list, row);
    QTest::qWait(QApplication::doubleClickInterval() + 100);
    click_row(list, row);
    QTest::qWait(QApplication::doubleClickInterval() + 100);
    QVERIFY(editor() == nullptr);
    QTest::keyClick(&list, Qt::Key_F2);
    QVERIFY(editor() != nullptr);
    QTest::keyClick(editor(), Qt::Key_Escape);
    QTRY_VERIFY(editor() == nullptr);
    QTest::mouseDClick(list.viewport(), Qt::LeftButton, {}, list.visualRect(row).center());
    QVERIFY(editor() != nullptr);
    editor()->selectAll();
    QTest::keyClicks(editor(), QStringLiteral("Dore"));
    QTest::keyClick(editor(), Qt::Key_Return);
    QTRY_COMPARE(QString::fromStdString(window->document().material()->name), QStringLiteral("Dore"));
  }

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

  void a_long_path_is_cut_where_it_is_shown_and_whole_where_it_counts() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    show_active(window);
    QString path = QStringLiteral("/a");
    for (int i = 0; i < 20; ++i) path += QStringLiteral("/folder %1").arg(i);
    path += QStringLiteral("/wood.png");
    window->inspector().textures().take_files({path}, Channel::diffuse);
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
};

ETAK_GUI_TEST(EditorHands, "editor_hands")
#include "test_editor_hands.moc"
