// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/problem_strip.h"

#include <QLabel>

#include "app/fields/add_button.h"

namespace etak::editor {
namespace {

constexpr int most_lines = 6, most_shown = 14;

}  // namespace

ProblemStrip::ProblemStrip(QWidget* parent) : QFrame(parent), text_(new QLabel(this)) {
  setAccessibleName(tr("Problems"));
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::ToolTipBase);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 4, 4, 4);
  text_->setAccessibleName(tr("What went wrong"));
  text_->setForegroundRole(QPalette::ToolTipText);
  text_->setTextFormat(Qt::PlainText);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  text_->setWordWrap(true);
  row->addWidget(text_, 1);
  auto* close = add_button(*row, "\u2715", tr("Close the message (Esc)"));
  row->setAlignment(close, Qt::AlignTop);
  connect(close, &QToolButton::clicked, this, &ProblemStrip::clear);
  hide();
}

void ProblemStrip::add(const QString& title, const QStringList& lines) {
  QStringList all = text().split('\n', Qt::SkipEmptyParts);
  if (!all.contains(title)) all << title;
  all += lines.mid(0, most_lines);
  if (lines.size() > most_lines) all << tr("and %1 more").arg(lines.size() - most_lines);
  text_->setText(all.mid(std::max(qsizetype{0}, all.size() - most_shown)).join('\n'));
  show();
}

void ProblemStrip::clear() {
  text_->clear();
  hide();
}

QString ProblemStrip::text() const {
  return text_->text();
}

}  // namespace etak::editor
