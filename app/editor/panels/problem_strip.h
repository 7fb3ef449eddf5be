// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>
#include <QStringList>

class QLabel;

namespace etak::editor {

/// What went wrong, above the viewport until it is closed by its button or by Esc. It never takes the focus, and
/// several messages stand in the one strip.
class ProblemStrip : public QFrame {
  Q_OBJECT

 public:
  explicit ProblemStrip(QWidget* parent);
  /// Adds a message to what is shown.
  ///   lines   one for each problem; of many the first are shown
  void add(const QString& title, const QStringList& lines);
  void clear();
  QString text() const;  // as it is shown; empty: nothing is

 private:
  QLabel* text_;
};

}  // namespace etak::editor
