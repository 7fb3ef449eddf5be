// SPDX-License-Identifier: Apache-2.0
// A photograph as side B, and the picture of how far A is from B.
#include <QPushButton>
#include <QTabWidget>

#include "app/editor/panels/difference_map.h"
#include "app/editor/panels/view_panel.h"
#include "core/render/display.h"
#include "tests/gui/editor_hands.h"
#include "tests/gui/gui_test.h"

using namespace etak;
using namespace etak::editor;

namespace {

// The mean that the map of the sides tells; none where there is no map.
std::optional<double> mean_told(TestWindow& window) {
  const auto* map = named<QLabel>(window->view_panel(), "Difference of A and B, in colour");
  if (map == nullptr || map->isHidden()) return std::nullopt;
  return map->accessibleDescription().section(',', 0, 0).section(' ', -1).toDouble();
}

void show_view_tab(TestWindow& window) {
  window->resize(1000, 800);
  show_active(window);
  window->inspector_tabs().setCurrentWidget(&window->view_panel());
}

}  // namespace

class EditorCompare : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QApplication::setAttribute(Qt::AA_DontUseNativeDialogs); }

  void a_photograph_of_the_material_is_not_far_from_it_and_another_is() {
    TestWindow window(true);
    QVERIFY(window->use_library_material("gold"));
    show_view_tab(window);
    QVERIFY(window.settle());
    QVERIFY(!mean_told(window));
    const QString file = window.file("gold photo.png");
    QVERIFY(window->viewport().grab_picture(true).save(file));
    choose_file(file);
    QTest::mouseClick(named<QPushButton>(window->view_panel(), "Photograph as side B"), Qt::LeftButton);
    QTRY_VERIFY(window->document().project().view.compare.on);
    QVERIFY(window.settle());
    QTRY_VERIFY(mean_told(window).value_or(99) < 1);
    const QPointF on_ball = QRectF(window->viewport().rect()).center() + QPointF(30, 20);
    auto patch = window->viewport().patch_at(on_ball);
    QVERIFY(patch && patch->delta_e < 2);
    QVERIFY(!patch || patch->on_object);
    QVERIFY(window->use_library_material("copper"));
    QVERIFY(window.settle());
    QTRY_VERIFY(mean_told(window).value_or(0) > 5);
    patch = window->viewport().patch_at(on_ball);
    QVERIFY(patch && patch->delta_e > 3);
    // The picture that is saved has the photograph on its right side.
    const QImage saved = window->viewport().grab_picture(true);
    const QImage photo(file);
    const QPoint right(saved.width() * 3 / 4, saved.height() / 2);
    QCOMPARE(saved.pixelColor(right), photo.pixelColor(right));
    // So has one of another size, and it has the photograph everywhere while the sides are flipped.
    const QPoint left(saved.width() / 4, saved.height() / 2);
    const auto colour_at = [&](const QPoint& place) {
      const SavedView view = window->viewport().saved_view();
      return view.picture(view.size, false, {}).pixelColor(place);
    };
    QCOMPARE(colour_at(right), photo.pixelColor(right));
    QVERIFY(colour_at(left) != photo.pixelColor(left));
    window->viewport().set_flipped(true);
    QCOMPARE(colour_at(left), photo.pixelColor(left));
    QCOMPARE(window->viewport().grab_picture(true).pixelColor(left), photo.pixelColor(left));
    window->viewport().set_flipped(false);
    QTest::mouseClick(named<QPushButton>(window->view_panel(), "Unpin side B"), Qt::LeftButton);
    QVERIFY(window.settle());
    QTRY_COMPARE(mean_told(window).value_or(99), 0.0);  // side B is the material in hand again
  }

  void the_map_is_that_of_core() {
    TestWindow window(true);
    QVERIFY(window->use_library_material("gold"));
    show_view_tab(window);
    QTest::keyClick(window.window.get(), Qt::Key_B, Qt::ControlModifier);
    QVERIFY(window->use_library_material("silver"));
    QVERIFY(window.settle());
    ViewState state = window->viewport().state();
    state.split = false;
    state.refined = true;
    ViewState other = state;
    other.a = state.b;
    constexpr int width = 240;
    const int height = width * window->viewport().height() / window->viewport().width();
    const DifferencePicture expected = difference_picture(draw_view(other, width, height, 2),
                                                          draw_view(state, width, height, 2), 1, state.tone);
    QVERIFY(expected.mean_de > 3);
    QTRY_VERIFY(std::abs(mean_told(window).value_or(99) - expected.mean_de) < 0.1);
    QTest::keyClick(window.window.get(), Qt::Key_T, Qt::ControlModifier);
    QTRY_VERIFY(!mean_told(window));
  }

  void a_photograph_that_cannot_be_read_changes_nothing() {
    TestWindow window(true);
    QVERIFY(window->use_library_material("gold"));
    show_view_tab(window);
    write(window.file("broken.png"), "no picture");
    window->take_photograph(window.file("broken.png"));
    QVERIFY(shown_message(window).contains("broken.png"));
    QVERIFY(!window->document().project().view.compare.on);
    QVERIFY(window->look().photograph.empty());
  }
};

ETAK_GUI_TEST(EditorCompare, "editor_compare")
#include "test_editor_compare.moc"
