// SPDX-License-Identifier: Apache-2.0
// Keys, wheel and clicks of a user in the fields of a material must not change anything by accident.
#include <QComboBox>
#include <QLineEdit>
#include <QListView>
#include <QSpinBox>
#include <QTabWidget>
#include <QToolButton>

#include "app/document/press_id.h"
#include "app/editor/panels/inspector/inspector.h"
#include "app/editor/panels/inspector/source_section.h"
#include "app/editor/panels/library_panel.h"
#include "app/editor/panels/project_panel.h"
#include "app/fields/color_field.h"
#include "app/fields/number_field.h"
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
};

ETAK_GUI_TEST(EditorHands, "editor_hands")
#include "test_editor_hands.moc"
