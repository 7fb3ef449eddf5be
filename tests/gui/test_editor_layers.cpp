// SPDX-License-Identifier: Apache-2.0
// Layers on a record: they are edited in the inspector, undone, saved, and seen over their thickness.
#include <QLineEdit>
#include <QToolButton>

#include "app/curves/line_plot_widget.h"
#include "app/document/press_id.h"
#include "app/editor/panels/inspector/inspector.h"
#include "app/editor/panels/inspector/layers_section.h"
#include "app/fields/number_field.h"
#include "core/color/srgb.h"
#include "tests/gui/editor_hands.h"
#include "tests/gui/gui_test.h"

using namespace etak;
using namespace etak::editor;

class EditorLayers : public QObject {
  Q_OBJECT

  static std::string record(TestWindow& window) { return window->document().material()->measured->material; }
  // The rows of the layers are made anew where their number changes, and shown from the event loop.
  static LayersSection& layers(TestWindow& window) {
    QTest::qWait(1);
    return *window->inspector().findChild<LayersSection*>();
  }
  static void press(TestWindow& window, const char* name) {
    auto* button = named<QToolButton>(layers(window), QLatin1String(name));
    QVERIFY2(button != nullptr, name);
    button->click();
  }
  static void type(TestWindow& window, const char* name, const char* text) {
    auto* line = named<QLineEdit>(layers(window), QLatin1String(name));
    QVERIFY2(line != nullptr, name);
    line->setText(QLatin1String(text));
    QTest::keyClick(line, Qt::Key_Return);
  }
  static NumberField* thickness(TestWindow& window) {
    for (NumberField* each : layers(window).findChildren<NumberField*>())
      if (each->isVisibleTo(&layers(window))) return each;
    return nullptr;
  }

 private slots:
  void a_thickness_is_edited_undone_and_saved() {
    TestWindow window(true);
    show_active(window);
    QVERIFY(window->use_library_material("anodised_titanium_40nm"));
    QVERIFY(!layers(window).isHidden());
    NumberField* field = thickness(window);
    QVERIFY(field != nullptr);
    QCOMPARE(field->value(), 40.0);
    emit field->edited(120, next_press_id());
    QCOMPARE(record(window), std::string("titania_amorphous:120nm/titanium"));
    const LinearRgb gold = window->document().material()->specular;
    QVERIFY2(gold.r > 0.35 && gold.b < 0.2, "120 nm on titanium are yellow");
    // A drag is one step of undo.
    const int drag_press = next_press_id();
    for (const double nm : {110.0, 100.0, 90.0}) emit thickness(window)->edited(nm, drag_press);
    QCOMPARE(record(window), std::string("titania_amorphous:90nm/titanium"));
    window->document().undo_stack().undo();
    QCOMPARE(record(window), std::string("titania_amorphous:120nm/titanium"));
    QCOMPARE(thickness(window)->value(), 120.0);
    // What is saved is read again with the same colour.
    const Project saved = parse_project(format_project(window->document().project(), ""), "saved.json");
    Project read = saved;
    QVERIFY(resolve(read, *window->document().library()).empty());
    QCOMPARE(read.materials[0].measured->material, std::string("titania_amorphous:120nm/titanium"));
    QVERIFY(read.materials[0].specular == gold);
    window->document().undo_stack().undo();
    QCOMPARE(record(window), std::string("anodised_titanium_40nm"));
    QVERIFY(window.settle());
  }

  void layers_are_added_moved_named_and_removed() {
    TestWindow window(true);
    show_active(window);
    QVERIFY(window->use_library_material("copper"));
    QVERIFY(thickness(window) == nullptr);  // a bare record has no layers, and can get them
    press(window, "Add a layer on top");
    QCOMPARE(record(window), std::string("fused_silica:100nm/copper"));
    press(window, "Add a layer on top");
    type(window, "Layer 1, medium", "water");
    QCOMPARE(record(window), std::string("water:100nm/fused_silica:100nm/copper"));
    press(window, "Layer 1: inwards");
    QCOMPARE(record(window), std::string("fused_silica:100nm/water:100nm/copper"));
    press(window, "Layer 2: outwards");
    QCOMPARE(record(window), std::string("water:100nm/fused_silica:100nm/copper"));
    type(window, "Base", "silver");
    QCOMPARE(record(window), std::string("water:100nm/fused_silica:100nm/silver"));
    press(window, "Layer 1: remove");
    press(window, "Layer 1: remove");
    QCOMPARE(record(window), std::string("silver"));
    QVERIFY(window.settle());
  }

  void a_medium_that_is_not_known_is_told_and_changes_nothing() {
    TestWindow window(true);
    show_active(window);
    QVERIFY(window->use_library_material("anodised_titanium_40nm"));
    const int before = window->document().undo_stack().index();
    type(window, "Layer 1, medium", "unobtainium");
    QVERIFY2(told(window).contains(QLatin1String("unobtainium")), qPrintable(told(window)));
    QCOMPARE(window->document().undo_stack().index(), before);
    QCOMPARE(named<QLineEdit>(layers(window), QStringLiteral("Layer 1, medium"))->text(),
             QStringLiteral("titania_amorphous"));
  }

  void the_strip_has_the_colour_of_each_thickness_and_the_plots_have_the_layers() {
    TestWindow window(true);
    show_active(window);
    QVERIFY(window->use_library_material("anodised_titanium_40nm"));
    auto* strip = layers(window).findChild<ThicknessStrip*>();
    QVERIFY(strip != nullptr);
    QVERIFY(QTest::qWaitFor([&] { return !strip->colors().empty(); }, 20000));
    // The ends of the slider are bare titanium and 500 nm.
    const auto color_at = [&](double nm) {
      emit thickness(window)->edited(nm, next_press_id());
      const Srgb8 code = srgb_u8(window->document().material()->specular);
      return QColor(code.r, code.g, code.b);
    };
    QCOMPARE(strip->colors().front(), color_at(0));
    QCOMPARE(strip->colors().back(), color_at(500));
    const auto plots = layers(window).findChildren<LinePlotWidget*>();
    QCOMPARE(plots.size(), 2);
    for (const LinePlotWidget* each : plots)
      QVERIFY2(each->csv_text().count(QLatin1Char('\n')) > 40, qPrintable(each->csv_text()));
  }
};

ETAK_GUI_TEST(EditorLayers, "editor_layers")
#include "test_editor_layers.moc"
