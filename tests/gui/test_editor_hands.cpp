// SPDX-License-Identifier: Apache-2.0
// Keys, wheel and clicks of a user must not change anything by accident.
#include <QComboBox>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QSettings>
#include <QSpinBox>
#include <QTabWidget>
#include <QToolButton>
#include <QTreeView>

#include "app/editor/fields/color_field.h"
#include "app/editor/fields/number_field.h"
#include "app/editor/fields/press_id.h"
#include "app/editor/panels/findings_panel.h"
#include "app/editor/panels/inspector.h"
#include "app/editor/panels/library_panel.h"
#include "app/editor/panels/preview_bar.h"
#include "app/editor/panels/project_panel.h"
#include "app/editor/panels/source_section.h"
#include "app/editor/panels/view_panel.h"
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

}  // namespace

class EditorHands : public QObject {
  Q_OBJECT

 private slots:
  void the_wheel_over_fields_without_the_focus_edits_nothing() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    window->document().change_view(QStringLiteral("wedge"), next_press_id(), [](ProjectView& view) {
      view.wedge = {true, "gloss", 5};
    });
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

  void three_numbers_that_are_typed_with_tab_between_them_are_a_colour() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    show_active(window);
    QStringList tried;
    for (int tab = 0; tab < 3; ++tab) {
      window->inspector_tabs().setCurrentIndex(tab);
      for (ColorField* field : window->inspector_tabs().currentWidget()->findChildren<ColorField*>()) {
        const QString which = field->accessibleName().section(QLatin1Char(','), 0, 0);
        auto* red = named<FineSpinBox>(*field, which + QStringLiteral(", red, linear"));
        QVERIFY2(red != nullptr, qPrintable(which));
        if (!red->isVisible() || !red->isEnabled()) continue;
        tried << which;
        red->setFocus();
        red->selectAll();
        for (const char* number : {"0.9", "0.5", "0.2"}) {
          QTest::keyClicks(QApplication::focusWidget(), QLatin1String(number));
          QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        }
        QVERIFY2(field->color() == (LinearRgb{0.9, 0.5, 0.2}), qPrintable(which));
        // The next three are the codes, which show that colour and leave it as it is.
        QVERIFY(QApplication::focusWidget()->accessibleName().endsWith(QLatin1String("red, sRGB 8 bit")));
        for (int i = 0; i < 3; ++i) QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QVERIFY2(field->color() == (LinearRgb{0.9, 0.5, 0.2}), qPrintable(which));
      }
    }
    QVERIFY2(tried.contains(QLatin1String("Specular")) && tried.contains(QLatin1String("Diffuse")) &&
                 tried.contains(QLatin1String("Light colour")),
             qPrintable(tried.join(QLatin1String(", "))));
    QVERIFY2(tried.size() >= 4, qPrintable(tried.join(QLatin1String(", "))));
  }

  void no_field_moves_while_it_is_edited_and_none_of_the_first_with_the_material() {
    TestWindow window(true);
    show_active(window);
    Inspector& inspector = window->inspector();
    const auto height_of = [&](const QString& name) {
      auto* field = named<FineSpinBox>(inspector, name);
      return field == nullptr ? -1 : field->mapTo(inspector.widget(), QPoint()).y();
    };
    const auto settled = [&] {
      QTest::qWait(50);
      return window.settle();
    };
    const QString first = QStringLiteral("Specular, red, linear"), gloss = QStringLiteral("Gloss"),
                  last = QStringLiteral("Occlusion");
    std::vector<int> heights;
    for (const char* id : {"gold", "chalk", "water", "plastic_red", "pmma"}) {
      QVERIFY(window->use_library_material(QLatin1String(id)));
      QVERIFY(settled());
      heights.push_back(height_of(gloss));
      QVERIFY2(heights.back() > 0 && heights.back() == heights.front(), id);
      const int source = window->inspector().source().mapTo(inspector.widget(), QPoint()).y();
      QVERIFY2(source > heights.back(), id);
      // The convention's sentence goes while the gloss is pulled.
      const int below = height_of(last);
      auto* slider = named<FieldSlider>(inspector, QStringLiteral("Gloss, slider"));
      QTest::mousePress(slider, Qt::LeftButton, {}, QPoint(slider->width() / 3, slider->height() / 2));
      QVERIFY(settled());
      QCOMPARE(height_of(gloss), heights.front());
      QCOMPARE(height_of(last), below);
      QTest::mouseRelease(slider, Qt::LeftButton, {}, QPoint(slider->width() / 3, slider->height() / 2));
    }
    // A typed F0 lets go of the measurement, whose texts go with it.
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    QVERIFY(settled());
    auto* red = named<FineSpinBox>(inspector, first);
    red->setFocus();
    red->selectAll();
    const int before = height_of(first);
    QTest::keyClicks(red, QStringLiteral("0.5"));
    QTest::keyClick(red, Qt::Key_Return);
    QVERIFY(settled());
    QVERIFY(!window->document().material()->measured);
    QCOMPARE(height_of(first), before);
    QCOMPARE(height_of(gloss), heights.front());
    // Nothing of a measurement stands there then, and the button folds what stands there of one.
    auto* outside = named<QComboBox>(inspector, QStringLiteral("Outside medium"));
    QVERIFY(!outside->isVisible());
    window->document().undo_stack().undo();
    QVERIFY(outside->isVisible());
    auto* fold =
        named<QToolButton>(inspector, QStringLiteral("Show or hide what is to be said of the measurement"));
    fold->click();
    QVERIFY(!outside->isVisible() &&
            named<QComboBox>(inspector, QStringLiteral("Use measured F0 of"))->isVisible());
  }

  void a_field_that_a_texture_replaces_says_so_and_is_off() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    ProjectMaterial m = *window->document().material();
    m.alpha_mode = AlphaMode::blend;
    window->document().edit(0, m, QStringLiteral("mode"), next_press_id());
    show_active(window);
    Inspector& inspector = window->inspector();
    const auto label = [&](const QWidget* field) {
      for (const QLabel* each : inspector.findChildren<QLabel*>())
        if (each->buddy() == field) return each->text();
      return QString();
    };
    const std::vector<std::tuple<Channel, QWidget*, QString>> fields{
        {Channel::specular, &inspector.specular(), QStringLiteral("Specular (F0)")},
        {Channel::diffuse, &inspector.diffuse(), QStringLiteral("Diffuse")},
        {Channel::gloss, &inspector.gloss(), QStringLiteral("Gloss")},
        {Channel::gloss, &inspector.roughness(), QStringLiteral("Roughness")},
        {Channel::alpha, &inspector.alpha(), QStringLiteral("Alpha opacity")}};
    const auto is_marked = [&](Channel textured) {
      for (const auto& [channel, field, name] : fields) {
        const bool off = channel == textured;
        if (field->isEnabled() == off || label(field) != (off ? name + QStringLiteral(": texture") : name))
          return false;
      }
      return true;
    };
    QVERIFY(is_marked(Channel::occlusion));
    for (const Channel each : {Channel::specular, Channel::diffuse, Channel::gloss, Channel::alpha}) {
      put_texture(window, each, grey_picture(window, QStringLiteral("wood.png")));
      QVERIFY(is_marked(each));
      window->document().undo_stack().undo();
    }
    // Emission and occlusion are multiplied by their textures.
    put_texture(window, Channel::occlusion, grey_picture(window, QStringLiteral("wood.png")));
    QVERIFY(is_marked(Channel::occlusion));
    QVERIFY(named<FineSpinBox>(inspector, QStringLiteral("Occlusion"))->isEnabled());
  }

  void reset_of_gloss_and_roughness_goes_to_what_the_record_has() {
    TestWindow window(true);
    show_active(window);
    for (const auto& [id, roughness] : {std::pair{"chalk", 0.9}, {"plastic_red", 0.3}, {"gold", 0.24976}}) {
      QVERIFY(window->use_library_material(QLatin1String(id)));
      const Gloss standard = window->document().material()->gloss;
      QVERIFY2(std::abs(standard.roughness() - roughness) < 1e-5, id);
      for (const char* name : {"Gloss", "Roughness"}) {
        ProjectMaterial other = *window->document().material();
        other.gloss = 0.4;
        window->document().edit(window->document().current(), other, QStringLiteral("gloss"),
                                next_press_id());
        auto* reset = named<QToolButton>(window->inspector(), QStringLiteral("Reset ") + QLatin1String(name));
        QVERIFY(reset != nullptr);
        reset->click();
        QVERIFY2(window->document().material()->gloss == standard, id);
      }
    }
    emit window->project_panel().new_asked();
    named<QToolButton>(window->inspector(), QStringLiteral("Reset Gloss"))->click();
    QVERIFY(window->document().material()->gloss == ProjectMaterial{}.gloss);
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

  void messages_stand_in_one_strip_that_leaves_the_focus_and_esc_closes() {
    TestWindow window(true);
    show_active(window);
    QListView& list = window->project_panel().list();
    list.setFocus();
    QSignalSpy opened(window.window.get(), &Window::opened);
    window->open(window.file(QStringLiteral("first.json")));
    window->open(window.file(QStringLiteral("second.json")));
    QVERIFY(QTest::qWaitFor([&] { return opened.count() == 2; }, 20000));
    const QString text = window->problems().text();
    QVERIFY2(text.contains(QLatin1String("first.json")) && text.contains(QLatin1String("second.json")) &&
                 text.count(QLatin1String("This could not be opened")) == 1,
             qPrintable(text));
    QVERIFY(window->problems().isVisible() && list.hasFocus() &&
            QApplication::activeModalWidget() == nullptr);
    QTest::keyClick(&list, Qt::Key_Escape);
    QVERIFY(!window->problems().isVisible());
  }

  void a_typed_f0_is_asked_for_its_material_which_becomes_the_record() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    show_active(window);
    ColorField& field = window->inspector().specular();
    QLineEdit* hexadecimal = nullptr;
    for (auto* each : field.findChildren<QLineEdit*>())
      if (each->accessibleName().endsWith(QLatin1String(", hexadecimal"))) hexadecimal = each;
    QVERIFY(hexadecimal != nullptr);
    hexadecimal->setFocus();
    hexadecimal->selectAll();
    QTest::keyClicks(hexadecimal, QStringLiteral("#ffe49c"));
    QTest::keyClick(hexadecimal, Qt::Key_Return);
    QVERIFY(!window->document().material()->measured);
    auto* ask =
        named<QToolButton>(field, QStringLiteral("What is this? Which measured materials have this F0"));
    QVERIFY(ask != nullptr);
    QTest::keyClick(ask, Qt::Key_Space);
    const auto menu = [&] {
      for (QMenu* each : window->findChildren<QMenu*>())
        if (each->accessibleName() == QLatin1String("What this could be")) return each;
      return static_cast<QMenu*>(nullptr);
    };
    QTRY_VERIFY_WITH_TIMEOUT(menu() != nullptr, 60000);
    const QList<QAction*> rows = menu()->actions();
    QVERIFY(rows.size() > 2 && !rows[0]->isEnabled());
    QVERIFY2(rows[1]->text().startsWith(QLatin1String("Gold")), qPrintable(rows[1]->text()));
    QCOMPARE(rows[1]->data().toString(), QStringLiteral("gold"));
    QTest::keyClick(menu(), Qt::Key_Down);
    QTest::keyClick(menu(), Qt::Key_Return);
    QTRY_VERIFY(window->document().material()->measured);
    QCOMPARE(window->document().material()->measured->material, std::string("gold"));
    window->document().undo_stack().undo();
    QVERIFY(!window->document().material()->measured);
  }

  void what_is_folded_stays_folded_in_the_next_run() {
    const QTemporaryDir folder;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder.path());
    QCoreApplication::setOrganizationName(QStringLiteral("etak-test"));
    WindowOptions options;
    options.cpu_viewport = true;
    options.data_folder = options.cache_folder = folder.path();
    for (const bool first : {true, false}) {
      Window window(options);
      QVERIFY(window.use_library_material(QStringLiteral("gold")));
      window.show();
      auto* fold = named<QToolButton>(window.inspector(),
                                      QStringLiteral("Show or hide what is to be said of the measurement"));
      QCOMPARE(fold->isChecked(), first);
      if (first) QTest::keyClick(fold, Qt::Key_Space);
      QVERIFY(!fold->isChecked());
      window.document().mark_saved(folder.filePath(QStringLiteral("p.json")));
      QVERIFY(window.close());
    }
    QSettings().clear();
  }

  void space_shows_side_b_where_no_field_takes_it() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    emit window->view_panel().pin_asked();
    QVERIFY(window->use_library_material(QStringLiteral("chromium")));
    show_active(window);
    window->setFocus();
    QTRY_VERIFY(!window->is_busy());
    const QImage a = window->viewport().grab_picture();
    QTest::keyPress(window.window.get(), Qt::Key_Space);
    const QImage b = window->viewport().grab_picture();
    QTest::keyRelease(window.window.get(), Qt::Key_Space);
    QVERIFY(a != b);
    QCOMPARE(window->viewport().grab_picture(), a);
  }

  void a_preview_is_marked_read_and_ended() {
    TestWindow window(true);
    window->resize(1280, 800);
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
    QVERIFY(text->text().contains(QLatin1String("Gold\nnot in the project")));
    // It covers neither the ball nor the name in the middle.
    const QRectF view = window->viewport().rect();
    const QPointF apart = view.center() - QPointF(bar->geometry().bottomRight());
    QVERIFY2(std::hypot(apart.x(), apart.y()) > std::min(view.width(), view.height()) / 2.2 && apart.x() > 90,
             qPrintable(QStringLiteral("%1 %2").arg(apart.x()).arg(apart.y())));
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

  void the_selection_never_grows_by_itself() {
    TestWindow window(true);
    show_active(window);
    QListView& list = window->project_panel().list();
    list.setFocus();
    for (std::size_t count = 1; count <= 4; ++count) {
      QTest::keyClick(window.window.get(), Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
      QCOMPARE(window->document().project().materials.size(), count);
      QCOMPARE(window->project_panel().selected(), std::vector<int>{static_cast<int>(count) - 1});
    }
    QTest::keyClick(window.window.get(), Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(window->project_panel().selected(), std::vector<int>{4});
  }

  void del_copy_and_edits_act_on_what_is_marked() {
    TestWindow window(true);
    for (const char* id : {"gold", "copper", "silver", "brick", "water"})
      QVERIFY(window->use_library_material(QLatin1String(id)));
    show_active(window);
    const Project before = window->document().project();
    QListView& list = window->project_panel().list();
    const auto* note = named<QLabel>(window->project_panel(), QStringLiteral("Marked materials"));
    QVERIFY(note != nullptr);
    const auto mark_three = [&] {
      click_row(list, list.model()->index(0, 0));
      QVERIFY(!note->isVisible());
      click_row(list, list.model()->index(3, 0), Qt::ControlModifier);
      click_row(list, list.model()->index(1, 0), Qt::ControlModifier);
      QCOMPARE(window->project_panel().selected(), (std::vector<int>{0, 1, 3}));
      QVERIFY(note->isVisible() && note->text().startsWith(QLatin1String("3 marked")));
    };
    mark_three();
    list.setFocus();
    QTest::keyClick(&list, Qt::Key_Delete);
    QCOMPARE(window->document().project().materials,
             (std::vector<ProjectMaterial>{before.materials[2], before.materials[4]}));
    QVERIFY(window->document().current() >= 0 && window->document().current() < 2);
    QTest::keyClick(&list, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(window->document().project() == before);

    mark_three();
    QTest::keyClick(&list, Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(window->document().project().materials.size(), std::size_t{8});
    QVERIFY(window->document().project().materials[7].measured == before.materials[3].measured);
    QTest::keyClick(&list, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(window->document().project() == before);

    mark_three();
    FineSpinBox& gloss = window->inspector().gloss().box();
    gloss.setFocus();
    gloss.selectAll();
    QTest::keyClicks(&gloss, QStringLiteral("0.42"));
    QTest::keyClick(&gloss, Qt::Key_Return);
    for (const std::size_t row : {0u, 1u, 3u})
      QCOMPARE(double{window->document().project().materials[row].gloss}, 0.42);
    QCOMPARE(window->project_panel().selected(), (std::vector<int>{0, 1, 3}));
    for (const std::size_t row : {2u, 4u})
      QVERIFY(window->document().project().materials[row] == before.materials[row]);
    // Each gets its own measurement back, not that of the material that is shown.
    auto* red = named<FineSpinBox>(window->inspector(), QStringLiteral("Specular, red, linear"));
    red->setFocus();
    red->selectAll();
    QTest::keyClicks(red, QStringLiteral("0.6"));
    QTest::keyClick(red, Qt::Key_Return);
    QVERIFY(!window->document().project().materials[0].measured);
    QTest::mouseClick(named<QToolButton>(window->inspector(), QStringLiteral("Reset Specular")),
                      Qt::LeftButton);
    for (const std::size_t row : {0u, 1u})
      QVERIFY(window->document().project().materials[row].specular == before.materials[row].specular);
    for (int i = 0; i < 3; ++i) QTest::keyClick(&list, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(window->document().project() == before);
    // A drag of the slider over three materials is one step of undo.
    mark_three();
    const int steps = steps_of(window);
    FieldSlider& slider = window->inspector().gloss().slider();
    drag(slider, QPoint(slider.width() / 2, slider.height() / 2),
         QPoint(slider.width() / 4, slider.height() / 2));
    QCOMPARE(steps_of(window), steps + 1);
    QCOMPARE(double{window->document().project().materials[0].gloss},
             double{window->document().project().materials[3].gloss});
  }

  void a_slider_that_is_dragged_thins_the_pictures() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    show_active(window);
    QVERIFY(window.settle());
    FieldSlider& slider = window->inspector().gloss().slider();
    const QPoint from(slider.width() / 2, slider.height() / 2), to(slider.width() / 4, slider.height() / 2);
    QTest::mousePress(&slider, Qt::LeftButton, {}, from);
    QMouseEvent move(QEvent::MouseMove, to, slider.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&slider, &move);
    QTRY_VERIFY(window->viewport().is_hurried());
    QTest::mouseRelease(&slider, Qt::LeftButton, {}, to);
    QVERIFY(!window->viewport().is_hurried());
    QVERIFY(window.settle());
  }

  void sentences_go_when_they_are_true_no_more() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    show_active(window);
    LibraryPanel& library = window->library_panel();
    click_row(library.list(), library_row(library, QStringLiteral("gold")));
    QVERIFY2(told(window).contains(QLatin1String("Esc ends the preview")), qPrintable(told(window)));
    QTest::keyClick(&library.list(), Qt::Key_Return);
    QCOMPARE(window->document().material()->name, std::string("Gold"));
    QVERIFY2(!told(window).contains(QLatin1String("preview")), qPrintable(told(window)));

    auto* red = named<FineSpinBox>(window->inspector(), QStringLiteral("Specular, red, linear"));
    red->setFocus();
    red->selectAll();
    QTest::keyClicks(red, QStringLiteral("0.5"));
    QTest::keyClick(red, Qt::Key_Return);
    QVERIFY2(told(window).contains(QLatin1String("measured no longer")), qPrintable(told(window)));
    QTest::keyClick(red, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(window->document().material()->measured);
    QVERIFY2(told(window).isEmpty(), qPrintable(told(window)));
  }

  void arrow_keys_change_the_material_from_viewport_and_list_alone() {
    TestWindow window(true);
    for (const char* id : {"gold", "copper", "silver"})
      QVERIFY(window->use_library_material(QLatin1String(id)));
    show_active(window);
    window->inspector_tabs().setCurrentIndex(0);
    auto* reset = named<QToolButton>(window->inspector(), QStringLiteral("Reset Gloss"));
    QVERIFY(reset != nullptr);
    reset->setFocus();
    QTest::keyClick(reset, Qt::Key_Down);
    QTest::keyClick(reset, Qt::Key_Right);
    QCOMPARE(window->document().current(), 2);
    window->viewport().setFocus();
    QTest::keyClick(&window->viewport(), Qt::Key_Right);
    QCOMPARE(window->document().current(), 0);
  }

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
};

ETAK_GUI_TEST(EditorHands, "editor_hands")
#include "test_editor_hands.moc"
