// SPDX-License-Identifier: Apache-2.0
// The bar above the viewport, the size of the window, the history and the preferences, by keys and mouse.
#include <QAbstractSpinBox>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QDockWidget>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>
#include <QUndoView>

#include "app/editor/panels/drop_table.h"
#include "app/editor/panels/inspector/inspector.h"
#include "app/editor/panels/inspector/sections.h"
#include "app/editor/panels/preferences.h"
#include "app/editor/panels/project_panel.h"
#include "app/editor/panels/view_bar.h"
#include "app/fields/number_field.h"
#include "core/render/view_moves.h"
#include "tests/gui/editor_hands.h"
#include "tests/gui/gui_test.h"

using namespace etak;
using namespace etak::editor;

namespace {

ViewBar& bar_of(TestWindow& window) {
  return *window->findChild<ViewBar*>();
}

const ProjectView& seen_by(TestWindow& window) {
  return window->document().project().view;
}

void write_pyramid(const QString& file) {
  constexpr float s = 0.70710678f;
  const float corners[] = {-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1, 0, 1.5f, 0};
  const float normals[] = {-s, 0, -s, s, 0, -s, s, 0, s, -s, 0, s, 0, 1, 0};
  const std::uint16_t triangles[] = {0, 4, 1, 1, 4, 2, 2, 4, 3, 3, 4, 0, 0, 1, 2, 0, 2, 3};
  QByteArray bytes;
  bytes.append(reinterpret_cast<const char*>(corners), sizeof corners);
  bytes.append(reinterpret_cast<const char*>(normals), sizeof normals);
  bytes.append(reinterpret_cast<const char*>(triangles), sizeof triangles);
  const char* const scene = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1},"indices":2}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":5,"type":"VEC3","min":[-1,0,-1],"max":[1,1.5,1]},
{"bufferView":1,"componentType":5126,"count":5,"type":"VEC3"},
{"bufferView":2,"componentType":5123,"count":18,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteLength":60},{"buffer":0,"byteOffset":60,"byteLength":60},
{"buffer":0,"byteOffset":120,"byteLength":36}],
"buffers":[{"byteLength":156,"uri":"data:application/octet-stream;base64,BYTES"}]})";
  write(file, QByteArray(scene).replace("BYTES", bytes.toBase64()));
}

}  // namespace

class EditorBar : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QApplication::setAttribute(Qt::AA_DontUseNativeDialogs); }

  void every_switch_has_a_name_a_tip_and_a_place_in_the_tab_order() {
    TestWindow window(true);
    show_active(window);
    ViewBar& bar = bar_of(window);
    QStringList names;
    for (QWidget* each : bar.findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
      QVERIFY2(!each->accessibleName().isEmpty() && !each->toolTip().isEmpty(),
               each->metaObject()->className());
      QVERIFY(each->focusPolicy() & Qt::TabFocus);
      names << each->accessibleName();
    }
    QCOMPARE(names.size(), 7);
    named<QComboBox>(bar, names.front())->setFocus();
    QStringList walked;
    for (int i = 0; i < names.size(); ++i) {
      walked << QApplication::focusWidget()->accessibleName();
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    }
    QCOMPARE(walked, names);
  }

  void environment_exposure_tone_and_shape_go_by_keys() {
    TestWindow window(true);
    show_active(window);
    ViewBar& bar = bar_of(window);
    auto* environment = named<QComboBox>(bar, "Environment");
    const std::string first = seen_by(window).lights.environment;
    QCOMPARE(environment->currentData().toString().toStdString(), first);
    environment->setFocus();
    QTest::keyClick(environment, Qt::Key_Down);
    QVERIFY(seen_by(window).lights.environment != first);
    auto* exposure = named<FineSpinBox>(bar, "Exposure of the picture");
    exposure->setFocus();
    exposure->selectAll();
    QTest::keyClicks(exposure, "1");
    QTest::keyClick(exposure, Qt::Key_Return);
    QCOMPARE(seen_by(window).exposure, 2.0);
    auto* tone = named<QComboBox>(bar, "Tone curve");
    QCOMPARE(seen_by(window).tone, Tone::neutral);
    tone->setFocus();
    QTest::keyClick(tone, Qt::Key_Up);
    QCOMPARE(seen_by(window).tone, Tone::plain);
    auto* shape = named<QComboBox>(bar, "Shown on");
    shape->setFocus();
    QTest::keyClick(shape, Qt::Key_Down);
    QVERIFY(seen_by(window).shape == Shape::quad);
    QTest::keyClick(shape, Qt::Key_Down);
    QVERIFY(seen_by(window).wedge.on);
    // Looks have steps of undo of their own.
    QCOMPARE(window->document().view_stack().count(), 4);
    while (window->document().view_stack().canUndo())
      QTest::keyClick(window.window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::AltModifier);
    QCOMPARE(exposure->value(), 0.0);
    QCOMPARE(shape->currentIndex(), 0);
    QCOMPARE(tone->currentIndex(), 1);
  }

  void a_shader_ball_and_a_mesh_of_ones_own_stand_in_place_of_the_sphere() {
    TestWindow window(true);
    QVERIFY(window->use_library_material("gold"));
    show_active(window);
    QVERIFY(window.settle());
    auto* shape = named<QComboBox>(bar_of(window), "Shown on");
    const QImage sphere = window->viewport().grab_picture();
    shape->setFocus();
    for (int i = 0; i < 3; ++i) QTest::keyClick(shape, Qt::Key_Down);
    QCOMPARE(shape->currentText(), QStringLiteral("shader ball"));
    QCOMPARE(seen_by(window).mesh, std::string("shader-ball"));
    QVERIFY(window.settle());
    const QImage ball = window->viewport().grab_picture();
    QVERIFY(ball != sphere);
    QVERIFY(!window->viewport().uses_gl());
    QVERIFY(!window->viewport().fallback_reason().isEmpty());

    // A mesh of a file: a pyramid that this test writes.
    const QString file = window.file("own pyramid.gltf");
    write_pyramid(file);
    choose_file(file);
    QTest::keyClick(shape, Qt::Key_Down);
    QTRY_COMPARE(seen_by(window).mesh, file.toStdString());
    QVERIFY(window.settle());
    QCOMPARE(shape->currentText(), QStringLiteral("own pyramid.gltf"));
    QVERIFY(window->viewport().grab_picture() != ball);

    // One that cannot be read is told by its name, and the sphere is shown.
    const QString broken = window.file("broken.glb");
    QFile out(broken);
    QVERIFY(out.open(QIODevice::WriteOnly) && out.write("no glTF") > 0);
    out.close();
    choose_file(broken);
    emit shape->activated(4);
    QTRY_COMPARE(seen_by(window).mesh, broken.toStdString());
    QVERIFY(window.settle());
    QVERIFY(shown_message(window).contains(QStringLiteral("broken.glb")));
    QTRY_COMPARE(window->viewport().grab_picture(), sphere);
    QVERIFY(window->viewport().uses_gl() || !window->viewport().fallback_reason().isEmpty());
    while (window->document().view_stack().canUndo()) window->document().view_stack().undo();
    QVERIFY(window.settle());
    QCOMPARE(shape->currentText(), QStringLiteral("sphere"));
    QTRY_COMPARE(window->viewport().grab_picture(), sphere);
  }

  void buttons_switch_comparison_backdrop_and_overlays() {
    TestWindow window(true);
    show_active(window);
    ViewBar& bar = bar_of(window);
    auto* compare = named<QToolButton>(bar, "Compare A and B");
    QTest::mouseClick(compare, Qt::LeftButton);
    QVERIFY(seen_by(window).compare.on && compare->isChecked());
    QTest::keyClick(window.window.get(), Qt::Key_T, Qt::ControlModifier);
    QVERIFY(!seen_by(window).compare.on && !compare->isChecked());
    const auto choose = [&](const QString& button, const QString& title) {
      QMenu* menu = named<QToolButton>(bar, button)->menu();
      for (QAction* each : menu->actions())
        if (each->text().remove('&') == title) {
          menu->popup(bar.mapToGlobal(QPoint()));
          QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(each).center());
          return each->isChecked();
        }
      return false;
    };
    QVERIFY(seen_by(window).backdrop.ground);
    QVERIFY(!choose("Backdrop", "Ground"));
    QVERIFY(!seen_by(window).backdrop.ground);
    QVERIFY(choose("Overlays", "Energy overlay"));
    QVERIFY(window->look().energy_overlay);
    QTest::keyClick(window.window.get(), Qt::Key_2, Qt::ControlModifier);
    QVERIFY(!window->look().energy_overlay);
    QVERIFY(!choose("Overlays", "Show textures"));
    QVERIFY(!window->look().textured);
  }

  void the_ball_has_half_of_the_usual_window_and_940_pixels_are_enough() {
    TestWindow window(true);
    window->resize(1280, 800);
    show_active(window);
    QVERIFY(window->use_library_material("gold"));
    QVERIFY(window.settle());
    const QSize size = window->viewport().size();
    const PlaceUnder middle = place_under(window->viewport().state(), size.width(), size.height(),
                                          size.width() / 2.0, size.height() / 2.0);
    QVERIFY2(2 * middle.radius_pixels >= 400, qPrintable(QString::number(2 * middle.radius_pixels)));
    QVERIFY2(window->minimumSizeHint().width() <= 940,
             qPrintable(QString::number(window->minimumSizeHint().width())));
    window->resize(940, 700);
    QTRY_COMPARE(window->width(), 940);
    for (QWidget* each : bar_of(window).findChildren<QWidget*>(Qt::FindDirectChildrenOnly))
      QVERIFY(bar_of(window).rect().contains(each->geometry()));
  }

  void the_right_button_has_menus() {
    TestWindow window(true);
    show_active(window);
    QVERIFY(window->use_library_material("gold"));
    QVERIFY(window.settle());
    const QImage parallel = window->viewport().grab_picture();
    QTest::keyClick(window.window.get(), Qt::Key_4, Qt::ControlModifier);
    QTRY_VERIFY(window->viewport().state().perspective);
    const QImage near = window->viewport().grab_picture();
    QVERIFY(near != parallel);
    const QPoint middle = window->viewport().rect().center();
    QContextMenuEvent asked(QContextMenuEvent::Mouse, middle, window->viewport().mapToGlobal(middle));
    QCoreApplication::sendEvent(&window->viewport(), &asked);
    auto* menu = window->viewport().findChild<QMenu*>();
    QVERIFY(menu != nullptr && menu->isVisible());
    QTest::mouseClick(menu, Qt::LeftButton, {},
                      menu->actionGeometry(action_named(*window, "Perspective camera")).center());
    QTRY_VERIFY(!window->viewport().state().perspective);
    QVERIFY(window->viewport().grab_picture() != near);
    QListView& list = window->project_panel().list();
    QStringList titles;
    for (QAction* each : list.actions()) titles << each->text().remove('&');
    QCOMPARE(titles.front(), QString("Rename"));
    QVERIFY(titles.contains("Duplicate materials") && titles.contains("Copy materials") &&
            titles.contains("Remove materials"));
  }

  void a_folder_is_opened_with_the_table_of_what_goes_where() {
    TestWindow window(true);
    show_active(window);
    QVERIFY(QDir(window.folder.path()).mkdir("set"));
    grey_picture(window, "set/wall_diffuse.png");
    grey_picture(window, "set/wall_gloss.png");
    when_asked<QFileDialog>([&](QFileDialog& dialog) {
      dialog.findChild<QLineEdit*>("fileNameEdit")->setText(window.file("set"));
      static_cast<QDialog&>(dialog).accept();
    });
    QTest::keyClick(window.window.get(), Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY_WITH_TIMEOUT(window->findChild<DropTable*>() != nullptr, 10000);
  }

  void a_click_in_the_history_goes_back() {
    TestWindow window(true);
    show_active(window);
    QVERIFY(window->use_library_material("gold"));
    QVERIFY(window->use_library_material("copper"));
    auto* dock = window->findChild<QDockWidget*>("history");
    QVERIFY(dock->isHidden());
    dock->show();
    dock->raise();
    auto* list = named<QUndoView>(*window, "Edits");
    QTRY_VERIFY(list->isVisible());
    QCOMPARE(list->model()->rowCount(), 3);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualRect(list->model()->index(1, 0)).center());
    QCOMPARE(window->document().project().materials.size(), std::size_t(1));
  }

  void preferences_hold_for_what_is_new() {
    TestWindow window(true);
    show_active(window);
    QVERIFY(window->use_library_material("gold"));
    QTest::keyClick(window.window.get(), Qt::Key_Comma, Qt::ControlModifier);
    auto* dialog = window->findChild<PreferencesDialog*>();
    QVERIFY(dialog != nullptr);
    auto* model = named<QuietComboBox>(*dialog, "Model of new materials");
    model->setCurrentIndex(model->findData("ggx-exact"));
    auto* look = named<QuietComboBox>(*dialog, "New projects begin with");
    look->setFocus();
    QTest::keyClick(look, Qt::Key_Down);
    QTest::keyClick(dialog, Qt::Key_Return);
    const std::string before = window->document().material()->specular_model;
    QVERIFY(before != "ggx-exact");
    QVERIFY(window->use_library_material("copper"));
    QCOMPARE(window->document().material()->specular_model, std::string("ggx-exact"));
    QTest::keyClick(window.window.get(), Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(window->document().material()->specular_model, std::string("ggx-exact"));
    QCOMPARE(window->document().project().materials.front().specular_model, before);
    answer(QMessageBox::Discard);
    QTest::keyClick(window.window.get(), Qt::Key_N, Qt::ControlModifier);
    QVERIFY(is_measure(seen_by(window)));
  }

  // Chooses an entry of the menu of a field, which the menu key opens.
  static void choose_in_menu(QWidget& part, const QString& entry) {
    const QPoint middle = part.rect().center();
    QContextMenuEvent asked(QContextMenuEvent::Keyboard, middle, part.mapToGlobal(middle));
    QCoreApplication::sendEvent(&part, &asked);
    QVERIFY(QTest::qWaitFor([] { return QApplication::activePopupWidget() != nullptr; }));
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    QVERIFY(menu != nullptr);
    QAction* found = action_named(*menu, entry);
    QVERIFY2(found != nullptr, qPrintable(entry));
    menu->setActiveAction(found);
    QTest::keyClick(menu, Qt::Key_Return);
  }

  void fields_have_a_menu_that_copies_and_resets() {
    TestWindow window(true);
    QVERIFY(window->use_library_material(QStringLiteral("gold")));
    show_active(window);
    QVERIFY(window.settle());
    auto* gloss = named<QAbstractSpinBox>(window->inspector(), QStringLiteral("Gloss"));
    QVERIFY(gloss != nullptr);
    choose_in_menu(*gloss, QStringLiteral("Copy value"));
    QCOMPARE(QApplication::clipboard()->text(), QStringLiteral("0.75"));
    window->document().change_material(QStringLiteral("gloss"), 0, [](ProjectMaterial& m) { m.gloss = 0.2; });
    choose_in_menu(*gloss, QStringLiteral("Reset Gloss"));
    QCOMPARE(double{window->document().material()->gloss}, 0.75);
    auto* red = named<QAbstractSpinBox>(window->inspector(), QStringLiteral("Specular, red, sRGB 8 bit"));
    QVERIFY(red != nullptr);
    choose_in_menu(*red, QStringLiteral("Copy as hexadecimal"));
    QCOMPARE(QApplication::clipboard()->text(), QStringLiteral("#ffe49c"));
    choose_in_menu(*red, QStringLiteral("Copy linear value"));
    QVERIFY(QApplication::clipboard()->text().startsWith(QStringLiteral("1.04")));
  }

  void the_theme_follows_the_desktop_while_it_is_told_to() {
    TestWindow window(true);
    show_active(window);
    const auto shown = [] { return is_dark(QApplication::palette()); };
    const auto desktop_changes = [&] {
      QEvent change(QEvent::ThemeChange);
      QCoreApplication::sendEvent(window->windowHandle(), &change);
      QTest::qWait(20);
    };
    action_named(*window, QStringLiteral("As the desktop"))->trigger();
    const bool desktop = shown();
    // As if the desktop had been another one until now.
    apply_theme(*qApp, desktop ? Theme::light : Theme::dark);
    desktop_changes();
    QCOMPARE(shown(), desktop);
    // A theme that was chosen stays.
    action_named(*window, desktop ? QStringLiteral("Light") : QStringLiteral("Dark"))->trigger();
    desktop_changes();
    QCOMPARE(shown(), !desktop);
  }
};

ETAK_GUI_TEST(EditorBar, "editor_bar")
#include "test_editor_bar.moc"
