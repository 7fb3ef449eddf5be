// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <functional>
#include <optional>

class QColor;
class QWidget;

namespace etak::editor {

/// Waits for one click anywhere on the screen and reports the colour under it. Escape and a right click
/// cancel it. The object deletes itself at the end.
class Eyedropper : public QObject {
  Q_OBJECT

 public:
  ///   picked   called with the colour; with none where the user has cancelled
  Eyedropper(QWidget* owner, std::function<void(std::optional<QColor>)> picked);
  ~Eyedropper() override;

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  void finish(std::optional<QColor> color);
  QWidget* owner_;
  std::function<void(std::optional<QColor>)> picked_;
};

/// The colour of a pixel of the screen. Where a window of the application lies there, its own pixel is taken.
std::optional<QColor> screen_color(const QPoint& global);

}  // namespace etak::editor
