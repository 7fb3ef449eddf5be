// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/drop_table.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHeaderView>
#include <QPushButton>
#include <QTableWidget>

#include "app/editor/panels/inspector/sections.h"
#include "app/viewport/qt_text.h"

namespace etak::editor {
namespace {

enum Column { material_column, file_column, holds_column, channel_column, space_column, remark_column };

QString file_of(const DroppedRow& row) {
  return QFileInfo(qt_text(row.source.path)).fileName();
}

}  // namespace

DropTable::DropTable(DroppedPictures dropped, const QString& onto, QWidget* parent)
    : QDialog(parent),
      dropped_(std::move(dropped)),
      table_(new QTableWidget(static_cast<int>(dropped_.rows.size()), 6, this)),
      fresh_(new QCheckBox(tr("as a &new material"), this)),
      note_(new QLabel(this)),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this)) {
  setWindowTitle(tr("What goes where"));
  setAccessibleName(windowTitle());
  auto* column = new QVBoxLayout(this);
  table_->setAccessibleName(tr("Dropped pictures"));
  table_->setHorizontalHeaderLabels(
      {tr("Material"), tr("File"), tr("Read as"), tr("Goes to"), tr("Colour space"), tr("Remark")});
  table_->verticalHeader()->hide();
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->setTabKeyNavigation(false);
  table_->setColumnHidden(material_column, dropped_.sets.size() == 1);
  fill();
  table_->resizeColumnsToContents();
  table_->horizontalHeader()->setStretchLastSection(true);
  column->addWidget(table_, 1);
  fresh_->setAccessibleName(tr("As a new material"));
  fresh_->setToolTip(tr("Otherwise the pictures go onto %1").arg(onto));
  fresh_->setChecked(onto.isEmpty());
  fresh_->setVisible(!onto.isEmpty() && dropped_.sets.size() == 1);
  column->addWidget(fresh_);
  note_->setAccessibleName(tr("What is wrong"));
  note_->setWordWrap(true);
  column->addWidget(note_);
  buttons_->button(QDialogButtonBox::Ok)->setText(tr("&Take"));
  column->addWidget(buttons_);
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  check();
  const int rows = std::min(14, table_->rowCount());
  resize(820, 170 + rows * table_->rowHeight(0));
}

bool DropTable::makes_new() const {
  return fresh_->isChecked() || dropped_.sets.size() > 1;
}

void DropTable::fill() {
  for (int i = 0; i < table_->rowCount(); ++i) {
    const DroppedRow& row = dropped_.rows[static_cast<std::size_t>(i)];
    const auto text = [&](Column at, const QString& what) {
      auto* item = new QTableWidgetItem(what);
      item->setToolTip(what);
      table_->setItem(i, at, item);
    };
    text(material_column, qt_text(dropped_.sets[row.set]));
    text(file_column, file_of(row));
    table_->item(i, file_column)->setToolTip(qt_text(row.source.path));
    text(holds_column, row.holds);
    text(remark_column, row.remark);
    add_channels(i);
    add_space(i);
  }
}

void DropTable::add_channels(int i) {
  const DroppedRow& row = dropped_.rows[static_cast<std::size_t>(i)];
  auto* box = new QuietComboBox(tr("%1, %2, goes to").arg(file_of(row), row.holds), table_);
  box->addItem(tr("skip"));
  for (const Channel each : all_channels) box->addItem(text_of(each));
  box->setCurrentIndex(row.channel ? 1 + static_cast<int>(*row.channel) : 0);
  box->setEnabled(!row.fixed);
  connect(box, &QComboBox::currentIndexChanged, this, [this, i](int at) {
    DroppedRow& changed = dropped_.rows[static_cast<std::size_t>(i)];
    changed.channel = at == 0 ? std::nullopt : std::optional(all_channels[static_cast<std::size_t>(at - 1)]);
    add_space(i);
    check();
  });
  table_->setCellWidget(i, channel_column, box);
}

// Colours have a transfer curve, normal maps a convention, and numbers neither.
void DropTable::add_space(int i) {
  DroppedRow& row = dropped_.rows[static_cast<std::size_t>(i)];
  auto* box = new QuietComboBox(tr("%1, %2, colour space").arg(file_of(row), row.holds), table_);
  const bool normal = row.channel == Channel::normal, color = row.channel && is_color(*row.channel);
  if (normal) {
    box->addItems({tr("OpenGL"), tr("DirectX")});
    box->setToolTip(tr("Green points up (OpenGL) or down (DirectX)"));
    box->setCurrentIndex(row.green == GreenAxis::directx ? 1 : 0);
  } else if (color) {
    box->addItems({"srgb", "linear", "power-2.2"});
  } else {
    box->addItem(row.channel ? tr("numbers") : QString());
  }
  if (!color) row.source.space.clear();
  if (color) box->setCurrentIndex(std::max(0, box->findText(qt_text(row.source.space))));
  box->setEnabled(normal || color);
  connect(box, &QComboBox::currentIndexChanged, this, [this, i, box, normal](int at) {
    DroppedRow& changed = dropped_.rows[static_cast<std::size_t>(i)];
    if (normal)
      changed.green = at == 1 ? GreenAxis::directx : GreenAxis::opengl;
    else
      changed.source.space = at == 0 ? std::string() : box->currentText().toStdString();
  });
  table_->setCellWidget(i, space_column, box);
}

void DropTable::check() {
  const QString wrong = dropped_.doubles();
  const bool any =
      std::ranges::any_of(dropped_.rows, [](const DroppedRow& row) { return row.channel.has_value(); });
  note_->setText(!wrong.isEmpty() ? wrong : any ? QString() : tr("Nothing of it is taken"));
  note_->setVisible(!note_->text().isEmpty());
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(wrong.isEmpty() && any);
}

}  // namespace etak::editor
