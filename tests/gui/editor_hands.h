// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAction>
#include <QFileDialog>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QPointer>
#include <QStatusBar>

#include "tests/gui/editor_support.h"

namespace etak::editor {

/// Calls `act` for the next modal dialog of a class, as soon as it is shown.
template <class Dialog>
void when_asked(const std::function<void(Dialog&)>& act) {
  auto* watch = new QTimer(qApp);
  QObject::connect(watch, &QTimer::timeout, watch, [watch, act] {
    auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr) return;
    // A file dialog that still reads its folder does not accept a file yet: `act` is called again at the next
    // tick.
    const QPointer<Dialog> still(dialog);
    act(*dialog);
    if (still && still->isVisible()) return;
    watch->stop();
    watch->deleteLater();
  });
  watch->start(5);
}

inline void answer(QMessageBox::StandardButton button) {
  when_asked<QMessageBox>([button](QMessageBox& box) {
    if (auto* const chosen = box.button(button))
      chosen->click();  // a question without this button stays open
  });
}

inline void choose_file(const QString& path) {
  when_asked<QFileDialog>([path](QFileDialog& dialog) {
    dialog.selectFile(path);
    static_cast<QDialog&>(dialog).accept();
  });
}

inline QAction* action_named(const QObject& where, const QString& name) {
  for (QAction* each : where.findChildren<QAction*>())
    if (each->text().remove(QLatin1Char('&')).remove(QChar(0x2026)) == name) return each;
  return nullptr;
}

/// Shows the window and makes it the active one, so that its widgets can get the focus.
inline void show_active(TestWindow& window) {
  window->show();
  QApplication::setActiveWindow(window.window.get());
  QVERIFY(QTest::qWaitForWindowActive(window.window.get()));
}

/// The widget of a class that has an accessible name; null where there is none.
template <class Widget>
Widget* named(const QWidget& where, const QString& name) {
  for (Widget* each : where.findChildren<Widget*>())
    if (each->accessibleName() == name) return each;
  return nullptr;
}

/// The message in the status bar of the window.
inline QString told(TestWindow& window) {
  return window->statusBar()->currentMessage();
}

/// Drops files on a widget as the window system does. Returns whether the widget accepted the drag.
inline bool drop(QWidget& widget, const QStringList& files) {
  QMimeData data;
  QList<QUrl> urls;
  for (const QString& each : files) urls << QUrl::fromLocalFile(each);
  data.setUrls(urls);
  const QPoint middle = widget.rect().center();
  QDragEnterEvent enter(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&widget, &enter);
  if (!enter.isAccepted()) return false;
  QDropEvent event(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&widget, &event);
  return true;
}

}  // namespace etak::editor
