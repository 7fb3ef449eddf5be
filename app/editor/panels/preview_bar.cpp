// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/preview_bar.h"

#include <QEvent>
#include <QLabel>

#include "app/fields/add_button.h"

namespace etak::editor {

PreviewBar::PreviewBar(QWidget* picture) : QFrame(picture), text_(new QLabel(this)) {
  setAccessibleName(tr("Preview"));
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 3, 4, 3);
  text_->setAccessibleName(tr("What is looked at"));
  row->addWidget(text_);
  connect(add_button(*row, tr("Add"), tr("Add the material that is looked at to the project")),
          &QToolButton::clicked, this, &PreviewBar::add_asked);
  connect(add_button(*row, "\u2715", tr("End the preview (Esc)")), &QToolButton::clicked, this,
          &PreviewBar::end_asked);
  picture->installEventFilter(this);
  hide();
}

void PreviewBar::show_name(const QString& name) {
  name_ = name;
  place();
  show();
  raise();
}

bool PreviewBar::eventFilter(QObject* object, QEvent* event) {
  if (event->type() == QEvent::Resize) place();
  return QFrame::eventFilter(object, event);
}

void PreviewBar::place() {
  // In the corner, where the bar covers neither the object nor the name that the picture shows at its top.
  const int most = std::max(12 * fontMetrics().averageCharWidth(), parentWidget()->width() / 4);
  text_->setText(fontMetrics().elidedText(name_, Qt::ElideRight, most) + '\n' + tr("not in the project"));
  text_->setToolTip(name_);
  adjustSize();
  move(6, 6);
}

}  // namespace etak::editor
