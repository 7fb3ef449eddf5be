// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/inspector/sections.h"

#include <QEvent>
#include <QLayout>
#include <QScrollBar>
#include <QStylePainter>
#include <QTimer>

namespace etak::editor {

QuietComboBox::QuietComboBox(const QString& name, QWidget* parent) : QComboBox(parent) {
  setAccessibleName(name);
  setFocusPolicy(Qt::StrongFocus);
  setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  setMinimumContentsLength(8);
}

void QuietComboBox::show_items(const QStringList& items) {
  bool same = count() == items.size();
  for (int i = 0; same && i < count(); ++i) same = itemText(i) == items[i];
  if (same) return;
  clear();
  addItems(items);
}

void QuietComboBox::wheelEvent(QWheelEvent* event) {
  if (hasFocus())
    QComboBox::wheelEvent(event);
  else
    event->ignore();
}

void QuietComboBox::paintEvent(QPaintEvent*) {
  QStylePainter painter(this);
  QStyleOptionComboBox option;
  initStyleOption(&option);
  const QRect field =
      style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this);
  option.currentText = fontMetrics().elidedText(option.currentText, Qt::ElideRight, field.width());
  painter.drawComplexControl(QStyle::CC_ComboBox, option);
  painter.drawControl(QStyle::CE_ComboBoxLabel, option);
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

QLabel* Section::label_for(const QString& name, QWidget* field, const QString& tip) {
  if (!tip.isEmpty()) field->setToolTip(tip);
  if (field->accessibleName().isEmpty()) field->setAccessibleName(name);
  auto* out = new QLabel(name, this);
  out->setToolTip(field->toolTip());
  out->setBuddy(field);
  return out;
}

QLabel* Section::label_of(const QWidget& field) const {
  for (QLabel* each : findChildren<QLabel*>(Qt::FindDirectChildrenOnly))
    if (each->buddy() == &field) return each;
  return nullptr;
}

void Section::add(const QString& name, QWidget* field, const QString& tip) {
  rows_->addRow(label_for(name, field, tip), field);
}

QLabel* Section::add_badge(QWidget& field) {
  QWidget* beside = &field;
  int row = 0;
  QFormLayout::ItemRole role = QFormLayout::FieldRole;
  rows_->getWidgetPosition(beside, &row, &role);
  if (role == QFormLayout::SpanningRole) {
    beside = label_of(field);
    rows_->getWidgetPosition(beside, &row, &role);
  }
  rows_->removeWidget(beside);
  auto* line = new QHBoxLayout;
  line->setSpacing(2);
  auto* out = new QLabel(this);
  out->setAccessibleName(tr("Findings about %1").arg(field.accessibleName()));
  out->setFixedWidth(fontMetrics().horizontalAdvance(QChar(0x26a0)) + 4);
  line->addWidget(beside, beside == &field ? 1 : 0);
  line->addWidget(out);
  if (beside != &field) line->addStretch(1);
  rows_->setLayout(row, role, line);
  return out;
}

void Section::add(QWidget* wide) {
  rows_->addRow(wide);
}

QHBoxLayout& Section::add_line(const QString& name) {
  auto* row = new QWidget(this);
  row->setAccessibleName(name);
  auto* out = new QHBoxLayout(row);
  out->setContentsMargins(0, 0, 0, 0);
  add(row);
  return *out;
}

void Section::add_below(const QString& name, QWidget* field, const QString& tip) {
  rows_->addRow(label_for(name, field, tip));
  rows_->addRow(field);
}

QVBoxLayout* panel_column(QWidget* panel, int spacing) {
  auto* out = new QVBoxLayout(panel);
  out->setContentsMargins(4, 4, 4, 4);
  out->setSpacing(spacing);
  return out;
}

PanelScroll::PanelScroll(const QString& name, const QString& page, QWidget* parent) : QScrollArea(parent) {
  setAccessibleName(name);
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFrameShape(QFrame::NoFrame);
  auto* inside = new QWidget(this);
  inside->setAccessibleName(page);
  column_ = panel_column(inside, 6);
  setWidget(inside);
}

Section& PanelScroll::add_section(const QString& title) {
  auto* out = new Section(title, this);
  column_->addWidget(out);
  return *out;
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

void set_steady_text(QLabel& label, const QString& text, bool same) {
  label.setMinimumHeight(same && label.isVisible() ? label.height() : 0);
  label.setText(text);
}

}  // namespace etak::editor
