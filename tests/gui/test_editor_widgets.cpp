// SPDX-License-Identifier: Apache-2.0
// Tests of single widgets, without OpenGL: a typed value is kept as it is, and every control has an
// accessible name.
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QScrollBar>
#include <QSlider>
#include <QSpinBox>
#include <QSplitter>
#include <QTabWidget>
#include <QToolButton>

#include "app/document/look.h"
#include "app/document/press_id.h"
#include "app/editor/options.h"
#include "app/editor/panels/inspector/inspector.h"
#include "app/editor/panels/inspector/texture_section.h"
#include "app/editor/panels/library_panel.h"
#include "app/editor/panels/view_panel.h"
#include "app/editor/shortcuts.h"
#include "app/fields/color_field.h"
#include "app/fields/eyedropper.h"
#include "app/fields/number_field.h"
#include "core/color/srgb.h"
#include "tests/gui/editor_support.h"
#include "tests/gui/gui_test.h"

using namespace etak;
using namespace etak::editor;

namespace {

template <class Widget>
Widget& called(const TestWindow& window, const char* name) {
  for (Widget* each : window.window->findChildren<Widget*>())
    if (each->accessibleName() == QLatin1String(name)) return *each;
  qFatal("no widget is called %s", name);
}

QAbstractButton* button_called(const TestWindow& window, const char* name) {
  return &called<QAbstractButton>(window, name);
}

QComboBox& combo_called(const TestWindow& window, const char* name) {
  return called<QComboBox>(window, name);
}

// As a person chooses it.
void choose(QComboBox& box, const QString& text) {
  const int row = box.findText(text);
  QVERIFY2(row >= 0, qPrintable(text));
  box.setCurrentIndex(row);
  emit box.activated(row);
}

}  // namespace

class EditorWidgets : public QObject {
  Q_OBJECT

 private slots:
  void choosing_an_environment_switches_the_hemispheres_off_in_the_same_step() {
    TestWindow window(true);
    window->show();
    const auto lights = [&] { return window->document().project().view.lights; };
    QUndoStack& steps = window->document().undo_stack();
    QVERIFY(lights() == studio_lights());
    button_called(window, "Lights of the sources")->click();
    QVERIFY(lights() == default_lights());
    QCOMPARE(steps.count(), 1);
    choose(combo_called(window, "Environment picture"), QStringLiteral("sunset"));
    QCOMPARE(steps.count(), 2);
    QCOMPARE(lights().environment, std::string("sunset"));
    QVERIFY(!lights().hemispheres.has_value());
    QVERIFY(lights().lights == default_lights().lights);
    steps.undo();
    QVERIFY(lights() == default_lights());
    button_called(window, "Studio light")->click();
    QVERIFY(lights() == studio_lights());
  }

  void the_srgb_curve_has_the_tone_curves_as_its_views() {
    TestWindow window(true);
    window->document().replace({}, {}, true);  // with the view that projects have in which none is saved
    window->show();
    QComboBox& view = combo_called(window, "View of the display");
    QCOMPARE(view.count(), 5);
    QVERIFY(view.isEnabled());
    choose(view, QStringLiteral("Khronos PBR Neutral"));
    QVERIFY(window->document().project().view.tone == Tone::neutral);
    QVERIFY(QTest::qWaitFor([&] { return window->viewport().state().tone == Tone::neutral; }, 20000));
    // A display of the config has views of its own.
    choose(combo_called(window, "Display"), QStringLiteral("sRGB - Display"));
    QVERIFY(view.findText(QStringLiteral("Khronos PBR Neutral")) < 0);
    window->document().view_stack().undo();
    QCOMPARE(view.currentText(), QStringLiteral("Khronos PBR Neutral"));
    window->document().view_stack().undo();
    QVERIFY(window->document().project().view.tone == Tone::plain);
    QCOMPARE(view.currentIndex(), 0);
  }

  void every_control_has_a_name() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    window->show();
    QStringList nameless;
    int controls = 0;
    for (const QWidget* each : window->findChildren<QWidget*>()) {
      const bool control =
          qobject_cast<const QAbstractButton*>(each) || qobject_cast<const QAbstractSpinBox*>(each) ||
          qobject_cast<const QComboBox*>(each) || qobject_cast<const QLineEdit*>(each) ||
          qobject_cast<const QSlider*>(each) || qobject_cast<const QAbstractItemView*>(each) ||
          qobject_cast<const QTabWidget*>(each) || qobject_cast<const QDockWidget*>(each) ||
          qobject_cast<const Viewport*>(each);
      // Qt makes parts inside of named widgets: the line of a spin box, the list of a combo box, scroll
      // arrows.
      bool inside = each->objectName().startsWith(QLatin1String("qt_"));
      for (const QWidget* parent = each->parentWidget(); parent != nullptr; parent = parent->parentWidget())
        inside = inside || qobject_cast<const QAbstractSpinBox*>(parent) ||
                 qobject_cast<const QComboBox*>(parent) || qobject_cast<const QTabBar*>(parent) ||
                 qobject_cast<const QMenuBar*>(parent) ||
                 (qobject_cast<const QDockWidget*>(parent) == each->parentWidget() &&
                  qobject_cast<const QAbstractButton*>(each)) ||
                 (qobject_cast<const QLineEdit*>(parent) != nullptr);
      if (!control || inside) continue;
      ++controls;
      if (each->accessibleName().isEmpty())
        nameless << QString::fromLatin1(each->metaObject()->className()) + QLatin1Char(' ') +
                        each->objectName() + QStringLiteral(" in ") + each->parentWidget()->accessibleName();
    }
    QVERIFY2(controls > 80, qPrintable(QString::number(controls)));
    QVERIFY2(nameless.isEmpty(), qPrintable(nameless.join(QLatin1Char('\n'))));
  }

  void every_field_is_reached_by_keys() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    window->show();
    QApplication::setActiveWindow(window.window.get());
    QSet<QWidget*> seen;
    window->library_panel().search().setFocus();
    for (int i = 0; i < 400; ++i) {
      if (QApplication::focusWidget() != nullptr) seen.insert(QApplication::focusWidget());
      QTest::keyClick(
          QApplication::focusWidget() != nullptr ? QApplication::focusWidget() : window.window.get(),
          Qt::Key_Tab);
    }
    QStringList missed;
    int reached = 0;
    for (QWidget* each : window->findChildren<QWidget*>()) {
      // The line of a spin box or of an editable combo box gets the focus through its parent.
      if (!each->isVisible() || !each->isEnabled() || !(each->focusPolicy() & Qt::TabFocus) ||
          each->focusProxy() != nullptr || qobject_cast<QAbstractSpinBox*>(each->parentWidget()) != nullptr ||
          qobject_cast<QComboBox*>(each->parentWidget()) != nullptr ||
          qobject_cast<QDockWidget*>(each->parentWidget()) != nullptr)
        continue;
      if (seen.contains(each))
        ++reached;
      else
        missed << QString::fromLatin1(each->metaObject()->className()) + QLatin1Char(' ') +
                      each->accessibleName();
    }
    QVERIFY2(missed.isEmpty(), qPrintable(missed.join(QLatin1Char('\n'))));
    QVERIFY2(reached > 60, qPrintable(QString::number(reached)));
    QVERIFY(seen.contains(&window->viewport()));
  }

  void a_colour_outside_of_srgb_can_be_brought_in_and_back() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    window->show();
    Document& document = window->document();
    ColorField& field = window->inspector().specular();
    const auto button = [&](const QString& text) {
      for (auto* each : field.findChildren<QToolButton*>())
        if (each->text() == text) return each;
      return static_cast<QToolButton*>(nullptr);
    };
    QVERIFY(button(QStringLiteral("Clip"))->isVisible());
    const ProjectMaterial gold = *document.material();
    const LinearRgb measured = gold.specular;
    QVERIFY(measured.r > 1);
    button(QStringLiteral("Clip"))->click();
    QCOMPARE(document.material()->specular, (LinearRgb{1, measured.g, measured.b}));
    QVERIFY(!document.material()->measured);
    QVERIFY(!button(QStringLiteral("Clip"))->isVisible());
    document.undo_stack().undo();
    QVERIFY(*document.material() == gold);
    QVERIFY(button(QStringLiteral("Keep hue"))->isVisible());
    button(QStringLiteral("Keep hue"))->click();
    const LinearRgb kept = document.material()->specular;
    QCOMPARE(kept.r, 1.0);
    QVERIFY(std::abs(kept.g / kept.r - measured.g / measured.r) < 1e-12);
    QVERIFY(std::abs(kept.b / kept.r - measured.b / measured.r) < 1e-12);
    document.undo_stack().undo();
    QVERIFY(*document.material() == gold);
    // A colour with a channel below 0 is mixed with grey until that channel is 0.
    emit field.edited({0.5, 0.4, -0.1}, next_press_id());
    QCOMPARE(document.material()->specular.b, -0.1);
    button(QStringLiteral("Keep hue"))->click();
    QVERIFY(std::abs(document.material()->specular.b) < 1e-12);
    QVERIFY(document.material()->specular.r < 0.5);
  }

  void every_parameter_goes_back_by_its_button() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("pmma")));
    window->show();
    Document& document = window->document();
    ProjectMaterial m = *document.material();
    m.alpha_mode = AlphaMode::mask;  // the only mode with a cutoff
    m.specular_model = "abc-schlick";
    m.diffuse_model = "oren-nayar";
    document.edit(0, m, QStringLiteral("model"), next_press_id());
    int checked = 0;
    const auto check = [&](QWidget& page) {
      for (auto* field : page.findChildren<NumberField*>()) {
        if (!field->isEnabled() || !field->isVisible()) continue;
        const double before = field->value();
        const double other = before + (before > field->box().minimum() + 0.05 ? -0.05 : 0.05);
        field->box().setValue(other);
        QVERIFY2(std::abs(field->value() - other) < 1e-6, qPrintable(field->accessibleName()));
        const Project edited = document.project();
        const auto steps_of_both = [&] {
          return document.undo_stack().count() + document.view_stack().count();
        };
        const int edits = document.undo_stack().count(), steps = steps_of_both();
        for (auto* button : field->findChildren<QToolButton*>())
          if (button->accessibleName().startsWith(QLatin1String("Reset"))) button->click();
        QCOMPARE(steps_of_both(), steps + 1);
        QVERIFY2(field->value() != other, qPrintable(field->accessibleName()));
        QUndoStack& stack =
            document.undo_stack().count() > edits ? document.undo_stack() : document.view_stack();
        stack.undo();
        QVERIFY(document.project() == edited);
        stack.redo();
        ++checked;
      }
    };
    check(window->inspector());
    QVERIFY2(checked >= 4, qPrintable(QString::number(checked)));
    for (const int tab : {1, 2}) {
      window->inspector_tabs().setCurrentIndex(tab);
      check(*window->inspector_tabs().currentWidget());
    }
    QVERIFY2(checked >= 7, qPrintable(QString::number(checked)));
    // Colours are reset too.
    window->inspector_tabs().setCurrentIndex(0);
    emit window->inspector().diffuse().edited({0.1, 0.2, 0.3}, next_press_id());
    for (auto* button : window->inspector().diffuse().findChildren<QToolButton*>())
      if (button->accessibleName().startsWith(QLatin1String("Reset"))) button->click();
    QCOMPARE(document.material()->diffuse, (LinearRgb{0, 0, 0}));
  }

  void the_eyedropper_takes_the_colour_under_the_click() {
    QWidget page;
    page.setStyleSheet(QStringLiteral("background: #336699"));
    page.resize(400, 300);
    ColorField field(QStringLiteral("Test"), {0.04, 0.04, 0.04}, &page);
    field.setGeometry(0, 0, 300, 120);
    page.show();
    QVERIFY(QTest::qWaitForWindowExposed(&page));
    QToolButton* pick = nullptr;
    for (auto* each : field.findChildren<QToolButton*>())
      if (each->accessibleName().endsWith(QLatin1String("eyedropper"))) pick = each;
    QVERIFY(pick != nullptr);
    QSignalSpy edits(&field, &ColorField::edited);
    // Escape picks no colour.
    pick->click();
    QTest::keyClick(&field, Qt::Key_Escape);
    QCOMPARE(edits.count(), 0);
    QTest::qWait(10);
    pick->click();
    QTest::mouseClick(&field, Qt::LeftButton, {}, QPoint(350, 250));
    QCOMPARE(edits.count(), 1);
    QCOMPARE(hex(srgb_u8(field.color())), std::string("#336699"));
  }

  void a_colour_is_the_same_in_its_three_forms() {
    ColorField field(QStringLiteral("Test"), {0.04, 0.04, 0.04});
    QSignalSpy edits(&field, &ColorField::edited);
    const auto boxes = field.findChildren<FineSpinBox*>();
    QCOMPARE(boxes.size(), 6);  // three linear, three of 8 bit
    boxes[0]->setValue(1.25);
    QCOMPARE(edits.count(), 1);
    QCOMPARE(field.color(), (LinearRgb{1.25, 0.04, 0.04}));
    auto* hexadecimal = field.findChild<QLineEdit*>({}, Qt::FindDirectChildrenOnly);
    QCOMPARE(hexadecimal->text(), QString::fromStdString(hex(srgb_u8(field.color()))));
    QVERIFY(hexadecimal->text().startsWith(QLatin1String("#ff")));
    hexadecimal->setText(QStringLiteral("#808080"));
    emit hexadecimal->editingFinished();
    QCOMPARE(field.color(), srgb_decode(Srgb8{128, 128, 128}));
    QCOMPARE(boxes[1]->value(), std::round(srgb_decode(128 / 255.0) * 1e6) / 1e6);
    // A notch of the wheel changes a code by one, with Ctrl by ten. Notches that follow each other closely
    // have the same press id.
    field.show();
    QApplication::setActiveWindow(&field);
    boxes[3]->setFocus();
    turn_wheel(*boxes[3], 1);
    turn_wheel(*boxes[3], 1, Qt::ControlModifier);
    turn_wheel(*boxes[3], -1, Qt::ShiftModifier);
    QCOMPARE(hexadecimal->text(), QStringLiteral("#8a8080"));
    QCOMPARE(edits[edits.count() - 1][1], edits[edits.count() - 3][1]);
    turn_wheel(*boxes[3], -1, Qt::ControlModifier);
    QCOMPARE(hexadecimal->text(), QStringLiteral("#808080"));
    // A text that is no colour changes nothing.
    hexadecimal->setText(QStringLiteral("gold"));
    emit hexadecimal->editingFinished();
    QCOMPARE(hexadecimal->text(), QStringLiteral("#808080"));
  }

  void the_wheel_is_coarse_with_ctrl_and_fine_with_shift() {
    FineSpinBox box;
    box.show();
    QApplication::setActiveWindow(&box);
    box.setFocus();
    box.setRange(0, 100);
    box.setSingleStep(0.1);
    box.show_value(10);
    QSignalSpy edits(&box, &FineSpinBox::edited);
    turn_wheel(box, 1);
    QCOMPARE(box.value(), 10.1);
    turn_wheel(box, 1, Qt::ControlModifier);
    QCOMPARE(box.value(), 11.1);
    turn_wheel(box, -1, Qt::ShiftModifier);
    QCOMPARE(box.value(), 11.09);
    // Steps that follow each other closely have the same press id.
    QCOMPARE(edits.count(), 3);
    QCOMPARE(edits[0][1], edits[2][1]);
  }

  void a_drag_is_one_step_of_undo() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    window->show();
    QSlider& slider = window->inspector().gloss().slider();
    const int before = window->document().undo_stack().count();
    emit slider.sliderPressed();
    slider.setValue(100);
    slider.setValue(200);
    slider.setValue(300);
    emit slider.sliderReleased();
    QCOMPARE(window->document().undo_stack().count(), before + 1);
    emit slider.sliderPressed();
    slider.setValue(400);
    emit slider.sliderReleased();
    QCOMPARE(window->document().undo_stack().count(), before + 2);
    window->document().undo_stack().undo();
    QCOMPARE(window->document().material()->gloss, 0.3);
    window->document().undo_stack().undo();
    QCOMPARE(window->document().material()->gloss, 0.75);
  }

  void roughness_is_typed_beside_gloss_from_mirror_to_paper() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    window->show();
    Inspector& inspector = window->inspector();
    QVERIFY(std::abs(inspector.roughness().value() - roughness_of_gloss(0.75)) < 1e-6);
    for (const double roughness : {0.0, 0.5, 1.0}) {
      inspector.roughness().box().setValue(roughness);
      const Gloss& gloss = window->document().material()->gloss;
      QCOMPARE(gloss.roughness(), roughness);
      QVERIFY(std::abs(inspector.gloss().value() - double{gloss}) < 1e-6);
      const ExportSurface surface =
          export_surface(*window->document().material(), *window->document().library());
      QCOMPARE(surface.gloss.roughness(), roughness);
    }
    inspector.gloss().box().setValue(0.5);
    QVERIFY(std::abs(inspector.roughness().value() - roughness_of_gloss(0.5)) < 1e-6);
    QVERIFY(!window->document().material()->gloss.given_roughness());
  }

  void undo_and_redo_of_everything_end_where_they_began() {
    TestWindow window(true);
    Document& document = window->document();
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    QCOMPARE(document.project().materials[1].name, std::string("Gold 2"));
    ProjectMaterial m = *document.material();
    m.gloss = 0.1;
    document.edit(document.current(), m, QStringLiteral("gloss"), 1);
    document.remove({0});
    ProjectView view = document.project().view;
    view.exposure = 2;
    document.edit_view(view, QStringLiteral("exposure"), 2);
    const Project end = document.project();
    QUndoStack* const stacks[] = {&document.undo_stack(), &document.view_stack()};
    for (QUndoStack* each : stacks)
      while (each->canUndo()) each->undo();
    QVERIFY(document.project() == new_project());
    for (QUndoStack* each : stacks)
      while (each->canRedo()) each->redo();
    QVERIFY(document.project() == end);
  }

  void the_command_line_is_checked_before_a_display_is_asked_for() {
    const auto parsed = [](const QStringList& list) {
      return parse_options(QStringList{QStringLiteral("etak-editor")} + list);
    };
    QVERIFY(parsed({QStringLiteral("--screenshot"), QStringLiteral("a.png"), QStringLiteral("gold")})
                .error.isEmpty());
    QCOMPARE(parsed({QStringLiteral("--size=640x480")}).size, QSize(640, 480));
    QCOMPARE(parsed({QStringLiteral("--input-timeout=0.5")}).input_timeout.value_or(-1), 0.5);
    QCOMPARE(parsed({QStringLiteral("-")}).subjects, QStringList{QStringLiteral("-")});
    for (const char* wrong : {"--size=0x0", "--theme=blue", "--state=none", "--model=lambert", "--what",
                              "--input-timeout=soon", "--input-timeout=-1"})
      QVERIFY2(!parsed({QLatin1String(wrong)}).error.isEmpty(), wrong);
    QVERIFY(help_text().contains(QLatin1String("--screenshot")));
  }

  void the_list_of_keys_holds_every_shortcut() {
    TestWindow window(true);
    ShortcutsDialog keys(*window);
    keys.show();
    QVERIFY(keys.findChild<QAbstractItemView*>() != nullptr);
  }
};

ETAK_GUI_TEST(EditorWidgets, "editor_widgets")
#include "test_editor_widgets.moc"
