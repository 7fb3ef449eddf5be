// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>
#include <memory>

#include "app/editor/theme.h"
#include "app/editor/window.h"

namespace etak::editor {

/// A window that reads no settings of the user and leaves no files behind.
struct TestWindow {
  QTemporaryDir folder;
  std::unique_ptr<Window> window;

  explicit TestWindow(bool cpu = false) {
    WindowOptions options;
    options.cpu_viewport = cpu;
    options.remember = false;
    options.data_folder = folder.path();
    options.cache_folder = folder.path();
    window = std::make_unique<Window>(options);
    window->autosave().set_delay(20);
  }
  Window* operator->() { return window.get(); }
  Window& operator*() { return *window; }
  QString file(const QString& name) const { return folder.filePath(name); }

  /// Waits until all files are read and written and all materials are checked.
  bool settle(int most_ms = 60000) {
    return QTest::qWaitFor([this] { return !window->is_busy() && window->validator().is_idle(); }, most_ms);
  }
};

/// Writes a file.
inline void write(const QString& path, const QByteArray& bytes) {
  QFile file(path);
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(bytes);
}

/// Turns the wheel over the middle of a widget.
inline void turn_wheel(QWidget& widget, int notches, Qt::KeyboardModifiers keys = Qt::NoModifier) {
  const QPointF middle = QRectF(widget.rect()).center();
  QWheelEvent event(middle, widget.mapToGlobal(middle), {}, {0, 120 * notches}, Qt::NoButton, keys,
                    Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&widget, &event);
}

/// Drags with the left button, in several steps as a user does.
inline void drag(QWidget& widget, const QPoint& from, const QPoint& to,
                 Qt::KeyboardModifiers keys = Qt::NoModifier) {
  constexpr int steps = 8;
  QTest::mousePress(&widget, Qt::LeftButton, keys, from);
  for (int i = 1; i <= steps; ++i) {
    const QPoint at = from + (to - from) * i / steps;
    QMouseEvent move(QEvent::MouseMove, at, widget.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, keys);
    QCoreApplication::sendEvent(&widget, &move);
    QTest::qWait(5);
  }
  QTest::mouseRelease(&widget, Qt::LeftButton, keys, to);
}

}  // namespace etak::editor
