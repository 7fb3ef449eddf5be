// SPDX-License-Identifier: Apache-2.0
#include "app/fields/eyedropper.h"

#include <QApplication>
#include <QColor>
#include <QImage>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPixmap>
#include <QScreen>
#include <QWidget>

namespace etak::editor {

std::optional<QColor> screen_color(const QPoint& global) {
  if (QWidget* widget = QApplication::widgetAt(global)) {
    // The pixel is taken from the window itself, because some desktops do not allow to grab the screen.
    const QPoint place = widget->mapFromGlobal(global);
    const QPixmap one = widget->grab(QRect(place, QSize(1, 1)));
    if (!one.isNull()) return one.toImage().pixelColor(0, 0);
  }
  QScreen* screen = QApplication::screenAt(global);
  if (screen == nullptr) return std::nullopt;
  const QPoint place = global - screen->geometry().topLeft();
  const QPixmap one = screen->grabWindow(0, place.x(), place.y(), 1, 1);
  if (one.isNull()) return std::nullopt;
  return one.toImage().pixelColor(0, 0);
}

Eyedropper::Eyedropper(QWidget* owner, std::function<void(std::optional<QColor>)> picked)
    : QObject(owner), owner_(owner), picked_(std::move(picked)) {
  owner_->grabMouse(Qt::CrossCursor);
  owner_->grabKeyboard();
  owner_->installEventFilter(this);
}

Eyedropper::~Eyedropper() {
  owner_->releaseMouse();
  owner_->releaseKeyboard();
}

bool Eyedropper::eventFilter(QObject*, QEvent* event) {
  if (event->type() == QEvent::MouseButtonPress) {
    const auto* press = static_cast<QMouseEvent*>(event);
    finish(press->button() == Qt::LeftButton ? screen_color(press->globalPosition().toPoint())
                                             : std::nullopt);
    return true;
  }
  if (event->type() == QEvent::ShortcutOverride) {
    event->accept();  // Escape goes to the eyedropper, even where it is a shortcut
    return true;
  }
  if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    finish(std::nullopt);
    return true;
  }
  return event->type() == QEvent::MouseButtonRelease || event->type() == QEvent::MouseMove;
}

void Eyedropper::finish(std::optional<QColor> color) {
  owner_->removeEventFilter(this);
  if (picked_) picked_(color);
  deleteLater();
}

}  // namespace etak::editor
