// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

class QLabel;

namespace etak::editor {

/// A bar over a picture that previews a material of the library. It tells that the material is not in the
/// project, and offers to add it.
class PreviewBar : public QFrame {
  Q_OBJECT

 public:
  ///   picture   the widget that the bar lies on, in its upper left corner
  explicit PreviewBar(QWidget* picture);
  void show_name(const QString& name);

 signals:
  void add_asked();
  void end_asked();

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  void place();
  QLabel* text_;
  QString name_;
};

}  // namespace etak::editor
