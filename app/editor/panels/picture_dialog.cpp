// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/picture_dialog.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <algorithm>

#include "app/document/saved_pictures.h"
#include "app/editor/panels/inspector/sections.h"
#include "app/fields/path_edit.h"
#include "core/render/view_moves.h"

namespace etak::editor {
namespace {

constexpr int most_pixels = 8192, most_pictures = 1000;

}  // namespace

PictureDialog::PictureDialog(SavedView view, std::function<QString()> ask, QWidget* parent)
    : QDialog(parent),
      view_(std::move(view)),
      ask_(std::move(ask)),
      background_(new QuietComboBox(tr("Background of the picture"), this)),
      note_(quiet_label(tr("What saving is at"), this)),
      bar_(new QProgressBar(this)),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this)) {
  setWindowTitle(tr("Save the picture"));
  setAccessibleName(windowTitle());
  auto* column = panel_column(this, 6);
  auto* form = new QFormLayout;
  column->addLayout(form);
  const auto add = [&](const QString& title, QWidget* field, const QString& tip) {
    field->setToolTip(tip);
    form->addRow(title, field);
    form->labelForField(field)->setToolTip(tip);
  };
  const auto number = [&](const QString& title, const QString& name, const QString& tip, int most,
                          int value) {
    auto* out = new QSpinBox(this);
    out->setRange(1, most);
    out->setValue(std::clamp(value, 1, most));
    out->setAccessibleName(name);
    add(title, out, tip);
    return out;
  };
  width_ = number(tr("&Width"), tr("Width of the picture"), tr("In pixels, at most %1").arg(most_pixels),
                  most_pixels, view_.size.width());
  height_ = number(tr("&Height"), tr("Height of the picture"),
                   tr("In pixels, at most %1; the object keeps its proportions").arg(most_pixels),
                   most_pixels, view_.size.height());
  background_->addItems({tr("as in the view"), tr("transparent")});
  add(tr("&Background"), background_,
      tr("Transparent: the object alone, with alpha, without what is behind it and without a ground"));
  count_ = number(tr("&Turntable"), tr("Pictures of the turntable"),
                  tr("So many pictures, of a camera that goes once around the object; files get numbers"),
                  most_pictures, 1);
  count_->setSpecialValueText(tr("one picture"));
  count_->setSuffix(tr(" pictures"));
  note_->setText(tr("Drawn as by etak render, refined. PNG of 8 bits a channel."));
  note_->setMinimumWidth(340);
  bar_->setAccessibleName(tr("Progress of saving"));
  bar_->setRange(0, 100);
  bar_->setEnabled(false);
  buttons_->setAccessibleName(tr("Buttons"));
  buttons_->button(QDialogButtonBox::Save)->setText(tr("&Save\u2026"));
  column->addWidget(note_);
  column->addWidget(bar_);
  column->addWidget(buttons_);
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void PictureDialog::accept() {
  if (running_) return;
  for (QSpinBox* each : {width_, height_, count_}) each->interpretText();
  const QString file = ask_();
  if (file.isEmpty()) return;
  QStringList files{file};
  if (const int count = count_->value(); count > 1) {
    files.clear();
    for (int i = 0; i < count; ++i)
      files << QString::fromStdString(on_turntable(file.toStdString(), i, count));
    for (const QString& each : files)
      if (QFileInfo::exists(each))
        return note_->setText(tr("%1 is there already: choose another name").arg(short_path(each)));
  }
  run(files);
}

void PictureDialog::run(const QStringList& files) {
  running_ = true;
  *cancelled_ = false;
  for (QWidget* each :
       {static_cast<QWidget*>(width_), static_cast<QWidget*>(height_), static_cast<QWidget*>(count_),
        static_cast<QWidget*>(background_), static_cast<QWidget*>(buttons_->button(QDialogButtonBox::Save))})
    each->setEnabled(false);
  bar_->setEnabled(true);
  bar_->setValue(0);
  note_->setText(files.size() > 1 ? tr("Drawing %1 pictures").arg(files.size())
                                  : tr("Drawing %1").arg(short_path(files.front())));
  const QPointer<PictureDialog> self(this);
  auto last = std::make_shared<std::atomic<int>>(0);
  const auto done = [self, last](int share) {
    if (last->exchange(share) == share) return;  // each hundredth is shown once
    call_in_ui([self, share] {
      if (self) self->bar_->setValue(share);
    });
  };
  in_background(
      pool_, this,
      [view = view_, size = QSize(width_->value(), height_->value()),
       transparent = background_->currentIndex() == 1, files, cancelled = cancelled_,
       done] { return save_pictures(view, size, transparent, files, *cancelled, done); },
      [this, files](const QString& failure) { show_end(failure, files); });
}

void PictureDialog::show_end(const QString& failure, const QStringList& files) {
  running_ = false;
  if (failure.isEmpty()) {
    emit written(files);
    return QDialog::accept();
  }
  for (QWidget* each : findChildren<QWidget*>()) each->setEnabled(true);
  bar_->setValue(0);
  bar_->setEnabled(false);
  note_->setText(failure);
}

void PictureDialog::reject() {
  if (!running_) return QDialog::reject();
  *cancelled_ = true;
  note_->setText(tr("Cancelling\u2026"));
}

}  // namespace etak::editor
