// SPDX-License-Identifier: Apache-2.0
// Pictures of every main state in both themes and two sizes, at 1x or 2x (QT_SCALE_FACTOR), to be looked at.
// The test says what a program can say of them: nothing is empty, and no text is cut.
#include <QAbstractButton>
#include <QComboBox>
#include <QDir>
#include <QGroupBox>
#include <QLabel>

#include "app/editor/options.h"
#include "app/editor/screenshot.h"
#include "tests/gui/editor_support.h"

using namespace etak::editor;

class EditorScreenshots : public QObject {
  Q_OBJECT

 private slots:
  void every_state_data() {
    QTest::addColumn<QString>("state");
    QTest::addColumn<QString>("theme");
    QTest::addColumn<QSize>("size");
    for (const QString& state : screenshot_states())
      for (const QString& theme : {QStringLiteral("dark"), QStringLiteral("light")}) {
        for (const QSize& size : {QSize(1280, 800), QSize(2560, 1440)}) {
          // Large and light differ from small and dark in what the theme and the layout do, not state by
          // state.
          if (theme == QLatin1String("light") && size.width() > 2000 && state != QLatin1String("default"))
            continue;
          QTest::newRow(qPrintable(QStringLiteral("%1 %2 %3").arg(state, theme).arg(size.width())))
              << state << theme << size;
        }
      }
  }

  void every_state() {
    QFETCH(QString, state);
    QFETCH(QString, theme);
    QFETCH(QSize, size);
    apply_theme(*qApp, theme_named(theme));
    TestWindow window;
    const double ratio = window->devicePixelRatioF();
    // At 2x the screen of the test holds the small window only.
    window->resize(ratio > 1 ? QSize(1280, 740) : size);
    window->show();
    QVERIFY(QTest::qWaitForWindowExposed(window.window.get()));
    const QString problem = bring_into_state(
        *window, state == QLatin1String("empty") ? QString() : QStringLiteral("gold"), {}, state);
    QVERIFY2(problem.isEmpty(), qPrintable(problem));
    const QImage picture = window->grab().toImage();
    QVERIFY(!picture.isNull());
    const QDir folder(QStringLiteral(ETAK_BUILD_FOLDER "/screenshots"));
    QVERIFY(QDir().mkpath(folder.path()));
    QVERIFY(picture.save(folder.filePath(QStringLiteral("%1-%2-%3x%4@%5.png")
                                             .arg(state, theme)
                                             .arg(picture.width())
                                             .arg(picture.height())
                                             .arg(ratio))));
    for (const QLabel* label : window->findChildren<QLabel*>()) {
      if (!label->isVisible() || label->text().isEmpty() || label->wordWrap() ||
          label->pixmap(Qt::ReturnByValue).width() > 0)
        continue;
      QVERIFY2(label->width() + 1 >= label->minimumSizeHint().width(), qPrintable(label->text()));
    }
    for (const QAbstractButton* button : window->findChildren<QAbstractButton*>())
      if (button->isVisible() && !button->text().isEmpty() && !button->visibleRegion().isEmpty())
        QVERIFY2(button->width() + 1 >= button->minimumSizeHint().width(), qPrintable(button->text()));
  }
};

QTEST_MAIN(EditorScreenshots)
#include "test_editor_screenshots.moc"
