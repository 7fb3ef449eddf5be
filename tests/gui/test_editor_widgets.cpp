// SPDX-License-Identifier: Apache-2.0
// Widgets one by one, without OpenGL: what is typed is what is kept, and every control has a name.
#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QMenuBar>
#include <QScrollBar>
#include <QSlider>
#include <QSpinBox>
#include <QSplitter>
#include <QTabWidget>

#include "app/editor/color_field.h"
#include "app/editor/eyedropper.h"
#include "app/editor/inspector.h"
#include "app/editor/library_panel.h"
#include "app/editor/number_field.h"
#include "app/editor/options.h"
#include "app/editor/shortcuts.h"
#include "app/editor/texture_section.h"
#include "app/editor/view_panel.h"
#include "core/color/srgb.h"
#include "tests/gui/editor_support.h"

using namespace etak;
using namespace etak::editor;

class EditorWidgets : public QObject {
  Q_OBJECT

 private slots:
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
      // Parts that Qt makes inside of a named one: the line of a spin box, the list of a combo box, scroll
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
    for (QWidget* each :
         {static_cast<QWidget*>(&window->inspector().gloss().box()),
          static_cast<QWidget*>(&window->inspector().gloss().slider()),
          static_cast<QWidget*>(&window->library_panel().list()), static_cast<QWidget*>(&window->viewport())})
      QVERIFY2(seen.contains(each), qPrintable(each->accessibleName()));
  }

  void a_colour_is_the_same_in_its_three_forms() {
    ColorField field(QStringLiteral("Test"), {0.04, 0.04, 0.04});
    QSignalSpy edits(&field, &ColorField::edited);
    const auto boxes = field.findChildren<FineSpinBox*>();
    QCOMPARE(boxes.size(), 3);
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
    // What is no colour changes nothing.
    hexadecimal->setText(QStringLiteral("gold"));
    emit hexadecimal->editingFinished();
    QCOMPARE(hexadecimal->text(), QStringLiteral("#808080"));
  }

  void the_wheel_is_coarse_with_ctrl_and_fine_with_shift() {
    FineSpinBox box;
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
    // One press after the other, closely: one id.
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

  void undo_and_redo_of_everything_end_where_they_began() {
    TestWindow window(true);
    Document& document = window->document();
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    QCOMPARE(document.project().materials[1].name, std::string("Gold 2"));
    ProjectMaterial m = *document.material();
    m.gloss = 0.1;
    document.edit(document.current(), m, QStringLiteral("gloss"), 1);
    document.remove(0);
    ProjectView view = document.project().view;
    view.exposure = 2;
    document.edit_view(view, QStringLiteral("exposure"), 2);
    const Project end = document.project();
    while (document.undo_stack().canUndo()) document.undo_stack().undo();
    QVERIFY(document.project() == Project{});
    while (document.undo_stack().canRedo()) document.undo_stack().redo();
    QVERIFY(document.project() == end);
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

  void names_of_files_tell_their_channel() {
    QVERIFY(channel_of_name(QStringLiteral("/a/crate_gloss.png")) == Channel::gloss);
    QVERIFY(channel_of_name(QStringLiteral("crate-Specular.tif")) == Channel::specular);
    QVERIFY(channel_of_name(QStringLiteral("albedo.exr")) == Channel::diffuse);
    QVERIFY(!channel_of_name(QStringLiteral("crate.png")));
  }

  void the_command_line_is_checked_before_a_display_is_asked_for() {
    const auto parsed = [](const QStringList& list) {
      return parse_options(QStringList{QStringLiteral("etak-editor")} + list);
    };
    QVERIFY(parsed({QStringLiteral("--screenshot"), QStringLiteral("a.png"), QStringLiteral("gold")})
                .error.isEmpty());
    QCOMPARE(parsed({QStringLiteral("--size=640x480")}).size, QSize(640, 480));
    for (const char* wrong : {"--size=0x0", "--theme=blue", "--state=none", "--model=lambert", "--what"})
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

QTEST_MAIN(EditorWidgets)
#include "test_editor_widgets.moc"
