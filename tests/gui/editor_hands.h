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

/// Acts on the next dialog of a kind that stops everything else, as soon as it is there.
template <class Dialog>
void when_asked(const std::function<void(Dialog&)>& act) {
  auto* watch = new QTimer(qApp);
  QObject::connect(watch, &QTimer::timeout, watch, [watch, act] {
    auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr) return;
    // A file dialog that still reads its folder takes nothing yet: again at the next tick.
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
    if (auto* const chosen = box.button(button)) chosen->click();  // another question is left alone
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

/// Shows the window as the one in use, so that its widgets have the focus that they are given.
inline void show_active(TestWindow& window) {
  window->show();
  QApplication::setActiveWindow(window.window.get());
  QVERIFY(QTest::qWaitForWindowActive(window.window.get()));
}

/// The widget of a class and an accessible name.
template <class Widget>
Widget* named(const QWidget& where, const QString& name) {
  for (Widget* each : where.findChildren<Widget*>())
    if (each->accessibleName() == name) return each;
  return nullptr;
}

/// What the window says below.
inline QString told(TestWindow& window) {
  return window->statusBar()->currentMessage();
}

/// A drop as the window system brings it; whether it was accepted when it came over the widget.
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
