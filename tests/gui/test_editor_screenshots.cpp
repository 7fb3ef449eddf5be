// SPDX-License-Identifier: Apache-2.0
// Pictures of the editor's states, for people to look at. The test checks what a program can check: the sizes
// are right, and no text of a control is cut. The environment of the process sets scale (QT_SCALE_FACTOR) and
// OpenGL. As a test, every state is drawn once, in one theme or the other, and few of them at 2x and without
// OpenGL. ./dev screenshots sets ETAK_SCREENSHOTS=all, which draws all states in both themes and three sizes.
#include <QAbstractButton>
#include <QComboBox>
#include <QDir>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QStyleOptionComboBox>
#include <QTabBar>

#include "app/editor/options.h"
#include "app/editor/screenshot.h"
#include "tests/gui/editor_support.h"
#include "tests/gui/gui_test.h"

using namespace etak::editor;

namespace {

// A message about a text that needs more room than it has; empty where it fits.
QString cut(const QWidget& widget, const QString& text, int room) {
  const int needs = widget.fontMetrics().horizontalAdvance(text);
  return needs <= room ? QString()
                       : QStringLiteral("%1: \"%2\" needs %3, has %4")
                             .arg(widget.accessibleName(), text)
                             .arg(needs)
                             .arg(room);
}

// Messages about all texts of visible controls that are cut off.
QStringList cut_texts(const QWidget& window) {
  QStringList out;
  const auto seen = [](const QWidget* w) { return w->isVisible() && !w->visibleRegion().isEmpty(); };
  for (const QLabel* label : window.findChildren<QLabel*>()) {
    if (!seen(label) || label->text().isEmpty() || label->pixmap(Qt::ReturnByValue).width() > 0) continue;
    if (label->wordWrap() ? label->height() + 1 < label->heightForWidth(label->width())
                          : label->width() + 1 < label->minimumSizeHint().width())
      out << label->accessibleName() + QStringLiteral(": ") + label->text();
  }
  for (const QAbstractButton* button : window.findChildren<QAbstractButton*>())
    if (seen(button) && !button->text().isEmpty() && button->width() + 1 < button->minimumSizeHint().width())
      out << button->text();
  for (const QComboBox* box : window.findChildren<QComboBox*>()) {
    // As of a line, a text that the tool tip shows as well may be cut.
    if (!seen(box) || box->isEditable() || box->toolTip() == box->currentText()) continue;
    QStyleOptionComboBox option;
    option.initFrom(box);
    option.rect = box->rect();
    const QRect field =
        box->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, box);
    out << cut(*box, box->currentText(), field.width());
  }
  for (const QLineEdit* line : window.findChildren<QLineEdit*>())
    // A line for a path may cut it, because its tool tip shows the whole path.
    if (seen(line) && (line->text().isEmpty() || line->toolTip() != line->text())) {
      const int room = line->width() - line->textMargins().left() - line->textMargins().right() - 4;
      out << cut(*line, line->text().isEmpty() ? line->placeholderText() : line->text(), room);
    }
  for (const QTabBar* bar : window.findChildren<QTabBar*>())
    for (int i = 0; seen(bar) && i < bar->count(); ++i)
      out << cut(*bar, bar->tabText(i), bar->tabRect(i).width());
  for (const QHeaderView* header : window.findChildren<QHeaderView*>())
    for (int i = 0; seen(header) && i < header->count(); ++i)
      out << cut(*header, header->model()->headerData(i, Qt::Horizontal).toString(), header->sectionSize(i));
  out.removeAll(QString());
  return out;
}

}  // namespace

class EditorScreenshots : public QObject {
  Q_OBJECT

 private slots:
  void every_state_data() {
    QTest::addColumn<QString>("state");
    QTest::addColumn<QString>("theme");
    QTest::addColumn<QSize>("size");
    const bool all = qEnvironmentVariable("ETAK_SCREENSHOTS") == QLatin1String("all");
    const bool no_gl = qEnvironmentVariable("QT_XCB_GL_INTEGRATION") == QLatin1String("none");
    // Without OpenGL and at 2x, only states that differ there are drawn, and one that draws much.
    const QStringList few{QStringLiteral("default"), QStringLiteral("shader"), QStringLiteral("compare")};
    const QStringList states = !all && (no_gl || scale() > 1) ? few : screenshot_states();
    for (const QString& state : states)
      for (const QString& theme : {QStringLiteral("dark"), QStringLiteral("light")})
        for (const QSize& size : {QSize(1280, 800), QSize(1920, 1080), QSize(2560, 1440)}) {
          if (!all && (size.width() == 1920 || (states == few && size.width() > 1280))) continue;
          const bool main = state == QLatin1String("default"), large = size.width() > 2000;
          const bool own_theme = (theme == QLatin1String("dark")) == (states.indexOf(state) % 2 == 0);
          if (!all && (large ? !main || !own_theme : !main && !own_theme)) continue;
          QTest::newRow(qPrintable(QStringLiteral("%1 %2 %3").arg(state, theme).arg(size.width())))
              << state << theme << size;
        }
  }

  void every_state() {
    QFETCH(QString, state);
    QFETCH(QString, theme);
    QFETCH(QSize, size);
    apply_theme(*qApp, theme_named(theme));
    QTemporaryDir data;
    WindowOptions options;
    options.remember = false;
    options.data_folder = data.path();
    options.cache_folder = cache_.path();  // shared, because the thumbnails are the same in all states
    Window window(options);
    window.resize(size);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QCOMPARE(window.size(), size);
    const bool empty = state == QLatin1String("empty");
    const QString problem = bring_into_state(window, empty ? QString() : QStringLiteral("gold"), {}, state);
    QVERIFY2(problem.isEmpty(), qPrintable(problem));
    const QImage picture = picture_of(window).toImage();
    QCOMPARE(picture.size(), size * scale());
    const QDir folder(QStringLiteral(ETAK_BUILD_FOLDER "/screenshots"));
    QVERIFY(QDir().mkpath(folder.path()));
    const QString gl = window.viewport().uses_gl() ? QString() : QStringLiteral("-cpu");
    QVERIFY(picture.save(folder.filePath(QStringLiteral("%1-%2-%3x%4@%5%6.png")
                                             .arg(state, theme)
                                             .arg(size.width())
                                             .arg(size.height())
                                             .arg(scale())
                                             .arg(gl))));
    const QStringList problems = cut_texts(window);
    QVERIFY2(problems.isEmpty(), qPrintable(problems.join(QLatin1Char('\n'))));
  }

 private:
  static double scale() { return qApp->devicePixelRatio(); }
  QTemporaryDir cache_;
};

ETAK_GUI_TEST(EditorScreenshots, "editor_screenshots")
#include "test_editor_screenshots.moc"
