// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/sections.h"

#include <QEvent>
#include <QLayout>
#include <QScrollBar>
#include <QTimer>

namespace etak::editor {

QuietComboBox::QuietComboBox(const QString& name, QWidget* parent) : QComboBox(parent) {
  setAccessibleName(name);
  setFocusPolicy(Qt::StrongFocus);
  setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  setMinimumContentsLength(8);
}

void QuietComboBox::wheelEvent(QWheelEvent* event) {
  if (hasFocus())
    QComboBox::wheelEvent(event);
  else
    event->ignore();
}

Section::Section(const QString& title, QWidget* parent)
    : QGroupBox(title, parent), rows_(new QFormLayout(this)) {
  setAccessibleName(title);
  rows_->setContentsMargins(6, 4, 6, 6);
  rows_->setVerticalSpacing(4);
  rows_->setHorizontalSpacing(6);
  rows_->setRowWrapPolicy(QFormLayout::DontWrapRows);
  rows_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
}

void Section::add(const QString& name, QWidget* field) {
  if (field->accessibleName().isEmpty()) field->setAccessibleName(name);
  auto* label = new QLabel(name, this);
  label->setToolTip(field->toolTip());
  label->setBuddy(field);
  rows_->addRow(label, field);
}

void Section::add(QWidget* wide) {
  rows_->addRow(wide);
}

void Section::add_below(const QString& name, QWidget* field) {
  auto* label = new QLabel(name, this);
  label->setToolTip(field->toolTip());
  rows_->addRow(label);
  rows_->addRow(field);
}

PanelScroll::PanelScroll(const QString& name, QWidget* parent) : QScrollArea(parent) {
  setAccessibleName(name);
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFrameShape(QFrame::NoFrame);
}

QSize PanelScroll::minimumSizeHint() const {
  QSize out = QScrollArea::minimumSizeHint();
  if (widget() != nullptr)
    out.setWidth(widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width());
  return out;
}

bool PanelScroll::eventFilter(QObject* object, QEvent* event) {
  // QScrollArea filters the events of its page; by this one it learns that the page needs another size.
  if (object == widget() && event->type() == QEvent::LayoutRequest) {
    updateGeometry();
    // QScrollArea asks for the height of the page before all parts of the page have announced their new
    // heights. It is therefore asked once more, when they have.
    QTimer::singleShot(0, this, [this] {
      QWidget* page = widget();
      if (page == nullptr || page->layout() == nullptr) return;
      page->layout()->activate();
      if (page->height() >= page->heightForWidth(page->width())) return;
      QEvent request(QEvent::LayoutRequest);
      QScrollArea::event(&request);
    });
  }
  return QScrollArea::eventFilter(object, event);
}

QLabel* quiet_label(const QString& name, QWidget* parent) {
  auto* out = new QLabel(parent);
  out->setProperty("quiet", true);
  out->setWordWrap(true);
  out->setTextInteractionFlags(Qt::TextSelectableByMouse);
  out->setAccessibleName(name);
  return out;
}

}  // namespace etak::editor
