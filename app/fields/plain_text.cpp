// SPDX-License-Identifier: Apache-2.0
#include "app/fields/plain_text.h"

#include <QApplication>
#include <QEvent>
#include <QLabel>

namespace etak::editor {
namespace {

// Sets the format of every label to plain text when it is polished, which Qt does before a label is shown
// first. Message boxes and tooltips are made of labels too.
class PlainLabels : public QObject {
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* object, QEvent* event) override {
    if (event->type() == QEvent::Polish)
      if (auto* const label = qobject_cast<QLabel*>(object); label && label->textFormat() == Qt::AutoText)
        label->setTextFormat(Qt::PlainText);
    return QObject::eventFilter(object, event);
  }
};

}  // namespace

void show_texts_plain() {
  static QObject* filter = nullptr;
  if (filter != nullptr) return;
  filter = new PlainLabels(qApp);
  qApp->installEventFilter(filter);
}

}  // namespace etak::editor
