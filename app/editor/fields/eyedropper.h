// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <functional>
#include <optional>

class QColor;
class QWidget;

namespace etak::editor {

/// Waits for one click anywhere and tells the colour under it. Escape and a right click call it off. Deletes
/// itself.
class Eyedropper : public QObject {
  Q_OBJECT

 public:
  /// `picked` gets nothing when it was called off.
  Eyedropper(QWidget* owner, std::function<void(std::optional<QColor>)> picked);
  ~Eyedropper() override;

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  void finish(std::optional<QColor> color);
  QWidget* owner_;
  std::function<void(std::optional<QColor>)> picked_;
};

/// The colour of the screen's pixel, of the application's own windows where one lies there.
std::optional<QColor> screen_color(const QPoint& global);

}  // namespace etak::editor
