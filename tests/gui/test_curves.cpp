// SPDX-License-Identifier: Apache-2.0
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QImage>
#include <QMimeData>
#include <QPainter>
#include <QSignalSpy>
#include <QTabBar>
#include <QTabWidget>
#include <QTimer>
#include <QToolButton>
#include <QToolTip>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <ctime>

#include "app/curves/curves_panel.h"
#include "app/curves/line_plot_widget.h"
#include "app/curves/polar_plot_widget.h"
#include "core/brdf/models.h"
#include "core/material/library.h"
#include "tests/gui/gui_test.h"

using namespace etak;
using namespace etak::editor;

namespace {

QPalette palette_of(bool dark) {
  QPalette out;
  const QColor window(dark ? "#2b2b2b" : "#efefef"), base(dark ? "#202020" : "#ffffff"),
      ink(dark ? "#ececec" : "#1c1c1c");
  out.setColor(QPalette::Window, window);
  out.setColor(QPalette::Button, window);
  out.setColor(QPalette::Base, base);
  out.setColor(QPalette::AlternateBase, window);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText})
    out.setColor(role, ink);
  out.setColor(QPalette::Highlight, QColor("#3d7eb8"));
  return out;
}

std::vector<double> initial_values(const Model& model) {
  std::vector<double> out;
  for (const Parameter& p : model.parameters) out.insert(out.end(), p.color ? 3 : 1, p.initial);
  return out;
}

const Model& model() {
  return *find_model("ggx-schlick");
}

void show_material(CurvesPanel& panel, const char* id, F0Options options = {}) {
  const Material material = *MaterialLibrary::builtin().find(id);
  panel.set_material(material, material.preferred_dataset(), options, 0.75, &model(),
                     initial_values(model()));
}

// Waits until the last request is drawn.
bool wait(CurvesPanel& panel) {
  QSignalSpy spy(&panel, &CurvesPanel::drawn);
  return !panel.busy() || spy.wait(20000);
}

QImage picture_of(QWidget& widget, double ratio) {
  QImage out(widget.size() * ratio, QImage::Format_RGB32);
  out.setDevicePixelRatio(ratio);
  widget.render(&out);
  return out;
}

// Processor time of this thread in milliseconds, which does not grow on a busy machine.
double thread_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) / 1e6;
}

// The number of different colours in a picture.
int colors_in(const QImage& picture) {
  QSet<QRgb> seen;
  for (int y = 0; y < picture.height(); y += 2)
    for (int x = 0; x < picture.width(); x += 2) seen.insert(picture.pixel(x, y));
  return static_cast<int>(seen.size());
}

}  // namespace

class Curves : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    QApplication::setStyle("fusion");
    QDir().mkpath(pictures_);
  }

  // Pictures to look at: every tab, dark and light, at 1x and 2x, with the cursor on the curves.
  void draws_every_tab() {
    for (const bool dark : {false, true}) {
      QApplication::setPalette(palette_of(dark));
      CurvesPanel panel;
      panel.resize(640, 360);
      panel.show();
      show_material(panel, "gold");
      QVERIFY(wait(panel));
      auto* tabs = panel.findChild<QTabWidget*>();
      const double places[] = {520, 460, 72, 48};
      for (int tab = 0; tab < tabs->count(); ++tab) {
        tabs->setCurrentIndex(tab);
        PlotWidget* const plot = panel.current_plot();
        picture_of(panel, 1);  // the first drawing makes the layout
        plot->set_cursor(places[tab]);
        QVERIFY(!plot->readout().isEmpty());
        for (const int ratio : {1, 2}) {
          const QImage picture = picture_of(panel, ratio);
          QVERIFY(colors_in(picture) > 20);
          picture.save(
              QString("%1/%2-%3-%4x.png").arg(pictures_, names_[tab], dark ? "dark" : "light").arg(ratio));
        }
      }
    }
  }

  void draws_small_panels() {
    QApplication::setPalette(palette_of(true));
    CurvesPanel panel;
    panel.resize(420, 240);
    panel.show();
    auto* tabs = panel.findChild<QTabWidget*>();
    for (const char* id : {"fused_silica", "silicon"}) {
      show_material(panel, id);
      QVERIFY(wait(panel));
      for (int tab = 0; tab < tabs->count(); ++tab) {
        tabs->setCurrentIndex(tab);
        picture_of(panel, 1).save(QString("%1/small-%2-%3.png").arg(pictures_, id, names_[tab]));
      }
    }
    // A glossy lobe on the logarithmic scale.
    tabs->setCurrentIndex(3);
    panel.findChild<QCheckBox*>()->setChecked(true);
    picture_of(panel, 2).save(pictures_ + "/lobe-logarithmic.png");
  }

  void data_without_n_and_k_say_so() {
    const MaterialLibrary library = MaterialLibrary::builtin();
    CurvesPanel panel;
    panel.resize(640, 360);
    panel.show();
    for (std::size_t i = 0; i < library.ids().size(); ++i) {
      const Material material = library.at(i);
      if (!std::holds_alternative<Reflectance>(material.preferred_dataset().optics)) continue;
      panel.set_material(material, material.preferred_dataset(), {}, 0.5, nullptr, {});
      break;
    }
    QVERIFY(wait(panel));
    auto* tabs = panel.findChild<QTabWidget*>();
    QVERIFY(!tabs->isTabEnabled(0) && tabs->tabToolTip(0).contains(QLatin1String("no n and k")));
    QCOMPARE(tabs->currentIndex(), 1);
    tabs->setCurrentIndex(2);
    QVERIFY(panel.current_plot()->accessibleDescription().contains("no exact curve"));
    tabs->setCurrentIndex(3);
    QVERIFY(panel.current_plot()->accessibleDescription().contains("no specular model"));
    picture_of(panel, 1).save(pictures_ + "/no-model.png");
  }

  void kept_curves_stand_beside_the_next_material() {
    CurvesPanel panel;
    panel.resize(640, 360);
    panel.show();
    auto* tabs = panel.findChild<QTabWidget*>();
    const auto csv = [&] {
      panel.current_plot()->copy_csv();
      return QApplication::clipboard()->text();
    };
    show_material(panel, "gold");
    QVERIFY(wait(panel));
    panel.keep();
    panel.keep();  // the same curves are kept once
    show_material(panel, "copper");
    QVERIFY(wait(panel));
    for (const int tab : {1, 2, 3}) {
      tabs->setCurrentIndex(tab);
      const QString both = csv();
      QCOMPARE(both.section('\n', 0, 0).count(QStringLiteral("gold/")), 1);
      QCOMPARE(both.section('\n', 0, 0).count(QStringLiteral("copper/")), 1);
      picture_of(panel, 1).save(QString("%1/kept-%2.png").arg(pictures_, names_[tab]));
    }
    panel.forget_kept();
    tabs->setCurrentIndex(1);
    QVERIFY(!csv().contains(QStringLiteral("gold/")));
  }

  void an_authored_surface_keeps_its_lobe() {
    CurvesPanel panel;
    panel.set_surface("mine", 0.5, &model(), initial_values(model()));
    QVERIFY(wait(panel));
    QVERIFY(panel.current_plot()->accessibleDescription().contains("no measured data"));
    panel.findChild<QTabWidget*>()->setCurrentIndex(3);
    QVERIFY(panel.current_plot()->csv_text().count('\n') > 700);
  }

  void the_angle_tab_tells_error_and_time() {
    CurvesPanel panel;
    show_material(panel, "chromium");
    QVERIFY(wait(panel));
    const auto plots = panel.findChildren<LinePlotWidget*>();
    const auto found = std::find_if(plots.begin(), plots.end(), [](const LinePlotWidget* p) {
      return p->plot().title.find("over the angle") != std::string::npos;
    });
    QVERIFY(found != plots.end());
    const auto& keys = (*found)->plot().keys;
    QCOMPARE(keys.size(), std::size_t{6});
    for (const PlotKey& key : keys)
      QVERIFY2(key.text.find("ns") != std::string::npos || key.text.find("µs") != std::string::npos,
               key.text.c_str());
    for (std::size_t i = 1; i < keys.size(); ++i) QVERIFY(keys[i].text.find("error") != std::string::npos);
  }

  void the_latest_wish_is_what_is_drawn() {
    CurvesPanel panel;
    for (const char* id : {"gold", "silver", "copper", "iron", "water"}) show_material(panel, id);
    QVERIFY(wait(panel));
    QVERIFY(panel.current_plot()->accessibleName().startsWith("Water"));
  }

  // While a parameter is dragged, the user-interface thread never waits for curves.
  void the_ui_thread_is_never_held_for_50_ms() {
    CurvesPanel panel;
    panel.resize(640, 360);
    panel.show();
    show_material(panel, "gold");
    QVERIFY(wait(panel));
    double longest = 0, last = thread_ms();
    QTimer timer;
    timer.setInterval(0);
    connect(&timer, &QTimer::timeout, this, [&] {
      const double now = thread_ms();
      longest = std::max(longest, now - last);
      last = now;
    });
    const char* ids[] = {"gold", "silver", "copper", "fused_silica"};
    auto* tabs = panel.findChild<QTabWidget*>();
    const Model& m = model();
    std::vector<Material> all;
    for (const char* id : ids) all.push_back(*MaterialLibrary::builtin().find(id));
    timer.start();
    for (int i = 0; i < 60; ++i) {
      const Material& each = all[static_cast<std::size_t>(i) % 4];
      panel.set_material(each, each.preferred_dataset(), {}, i / 60.0, &m, initial_values(m));
      tabs->setCurrentIndex(i % 4);
      QTest::qWait(3);
    }
    QVERIFY(wait(panel));
    timer.stop();
    qInfo("longest work between events: %.1f ms", longest);
#ifdef __SANITIZE_ADDRESS__
    QVERIFY(longest < 250);
#else
    QVERIFY(longest < 50);
#endif
  }

  void the_cursor_moves_by_pointer_and_keys_and_is_read_out() {
    CurvesPanel panel;
    panel.resize(640, 360);
    panel.show();
    show_material(panel, "gold");
    QVERIFY(wait(panel));
    PlotWidget* const plot = panel.current_plot();
    picture_of(panel, 1);
    QSignalSpy spy(&panel, &CurvesPanel::readout_changed);
    QTest::mouseMove(plot, plot->rect().center());
    QTRY_VERIFY(!plot->readout().isEmpty());
    QVERIFY(plot->readout().contains(" nm: n "));
    QVERIFY(plot->accessibleDescription() == plot->readout());
    const QString before = plot->readout();
    QTest::keyClick(plot, Qt::Key_Right);
    QVERIFY(plot->readout() != before);
    QTest::keyClick(plot, Qt::Key_Home);
    QVERIFY(plot->readout().startsWith("360 nm"));
    QTest::keyClick(plot, Qt::Key_Left);
    QVERIFY(plot->readout().startsWith("360 nm"));
    QTest::keyClick(plot, Qt::Key_Escape);
    QVERIFY(plot->readout().isEmpty());
    QVERIFY(spy.count() >= 4);
  }

  void the_tooltip_stands_beside_the_curves() {
    CurvesPanel panel;
    panel.resize(560, 300);
    panel.show();
    panel.move(0, 0);
    show_material(panel, "gold");
    QVERIFY(wait(panel));
    PlotWidget* const plot = panel.current_plot();
    const QPoint middle = plot->rect().center();
    QHelpEvent help(QEvent::ToolTip, middle, plot->mapToGlobal(middle));
    QCoreApplication::sendEvent(plot, &help);
    const QWidget* tip = nullptr;
    for (const QWidget* each : QApplication::topLevelWidgets())
      if (each->inherits("QTipLabel") && each->isVisible()) tip = each;
    QVERIFY(tip != nullptr);
    const QRect place(plot->mapToGlobal(QPoint()), plot->size());
    QVERIFY2(!place.intersects(tip->geometry()), qPrintable(QToolTip::text()));
    QToolTip::hideText();
  }

  void copies_as_csv_and_svg() {
    CurvesPanel panel;
    panel.show();
    show_material(panel, "gold");
    QVERIFY(wait(panel));
    auto* tabs = panel.findChild<QTabWidget*>();
    for (int tab = 0; tab < tabs->count(); ++tab) {
      tabs->setCurrentIndex(tab);
      PlotWidget* const plot = panel.current_plot();
      QTest::keyClick(plot, Qt::Key_C, Qt::ControlModifier);
      const QString csv = QApplication::clipboard()->text();
      QCOMPARE(csv, plot->csv_text());
      QVERIFY(csv.count('\n') > 30);
      QTest::keyClick(plot, Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
      QVERIFY(QApplication::clipboard()->text().startsWith("<svg xmlns"));
      QVERIFY(QApplication::clipboard()->mimeData()->hasFormat("image/svg+xml"));
      QFile file(pictures_ + "/" + names_[tab] + ".svg");
      QVERIFY(file.open(QIODevice::WriteOnly));
      file.write(plot->svg_text().toUtf8());
    }
  }

  void every_control_has_a_name() {
    CurvesPanel panel;
    for (QWidget* widget : panel.findChildren<QWidget*>()) {
      const bool control = qobject_cast<QToolButton*>(widget) || qobject_cast<QComboBox*>(widget) ||
                           qobject_cast<QDoubleSpinBox*>(widget);
      // The buttons that scroll the tabs belong to the tab bar.
      if (!control || qobject_cast<QTabBar*>(widget->parentWidget())) continue;
      QVERIFY2(!widget->accessibleName().isEmpty(), widget->metaObject()->className());
      QVERIFY(widget->focusPolicy() != Qt::NoFocus);
    }
  }

  void is_destroyed_while_it_works() {
    for (int i = 0; i < 5; ++i) {
      CurvesPanel panel;
      show_material(panel, "gold");
    }
    QCoreApplication::processEvents();
  }

 private:
  const QString pictures_ = ETAK_BUILD_FOLDER "/screenshots/curves";
  const char* names_[4] = {"n-k", "reflectance", "angle", "lobe"};
};

ETAK_GUI_TEST(Curves, "curves_panel")
#include "test_curves.moc"
