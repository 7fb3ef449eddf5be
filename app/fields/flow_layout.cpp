// SPDX-License-Identifier: Apache-2.0
#include "app/fields/flow_layout.h"

#include <QWidget>

namespace etak::editor {

FlowLayout::FlowLayout(int gap, QWidget* parent) : QLayout(parent), gap_(gap) {
  setContentsMargins(0, 0, 0, 0);
}

FlowLayout::~FlowLayout() {
  qDeleteAll(items_);
}

QLayoutItem* FlowLayout::takeAt(int index) {
  return index >= 0 && index < items_.size() ? items_.takeAt(index) : nullptr;
}

void FlowLayout::setGeometry(const QRect& rect) {
  QLayout::setGeometry(rect);
  place(rect, true);
}

QSize FlowLayout::minimumSize() const {
  QSize out;
  for (const QLayoutItem* item : items_) out = out.expandedTo(item->minimumSize());
  return out.grownBy(contentsMargins());
}

int FlowLayout::place(const QRect& whole, bool really) const {
  const QMargins margins = contentsMargins();
  const QRect rect = whole.marginsRemoved(margins);
  int x = rect.x(), y = rect.y(), line = 0;
  for (QLayoutItem* item : items_) {
    const QSize size = item->sizeHint();
    if (x > rect.x() && x + size.width() > rect.x() + rect.width()) {
      x = rect.x();
      y += line + gap_;
      line = 0;
    }
    if (really) item->setGeometry({{x, y}, size});
    x += size.width() + gap_;
    line = std::max(line, size.height());
  }
  return y + line - rect.y() + margins.top() + margins.bottom();
}

}  // namespace etak::editor
