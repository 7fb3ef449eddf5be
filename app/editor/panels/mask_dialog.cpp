// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/mask_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "app/document/files.h"
#include "app/document/pictures.h"
#include "app/document/thumbnails.h"
#include "app/editor/panels/inspector/sections.h"
#include "app/fields/path_edit.h"
#include "app/viewport/qt_text.h"
#include "core/color/srgb.h"
#include "core/project/project_pictures.h"

namespace etak::editor {
namespace {

constexpr int ball_side = 260;
constexpr int ball_texels = 512;  // on the longer side of its textures

struct Surveyed {
  MaskSurvey survey;
  QString failure;
};
struct Shown {
  QImage ball;
  QString failure;
};
struct MaskWritten {
  ProjectMaterial material;
  std::vector<std::string> remarks;
  QString failure;
};

// "128", or "#80ff00".
QString text_of_code(const MaskCode& code, bool colors) {
  return colors ? qt_text(hex({code[0], code[1], code[2]})) : QString::number(code[0]);
}

std::optional<MaskCode> code_of_text(const QString& typed) {
  const QString text = typed.trimmed();
  if (text.startsWith(u'#')) {
    std::optional<MaskCode> out;
    (void)failure_of([&] {
      const Srgb8 codes = parse_hex(text.toStdString());
      out = MaskCode{codes.r, codes.g, codes.b};
    });
    return out;
  }
  bool number = false;
  const int grey = text.toInt(&number);
  if (!number || grey < 0 || grey > 255) return std::nullopt;
  MaskCode out{};
  out.fill(static_cast<std::uint8_t>(grey));
  return out;
}

// The ball of what the mask makes, without any file being written.
Shown shown_ball(const MaskedMaterial& masked, const Project& project, const MaterialLibrary& library) {
  Shown out;
  const auto work = [&] {
    const MaterialPair pair = masked_pair(manifest_of(masked, project, library), library, picture_door());
    ProjectMaterial made;
    made.alpha_mode = AlphaMode::opaque;
    // Which channels come from pictures; their texels are those of the pair.
    for (const Channel each : {Channel::diffuse, Channel::specular, Channel::gloss})
      set_texture(made, each, ImageSource{masked.mask, {}, {}});
    out.ball = ball_picture(
        surface_of(made, library), Shape::sphere, ball_side,
        std::make_shared<const SurfaceTextures>(surface_textures(made, pair, picture_door(), ball_texels)));
  };
  out.failure = failure_of(work, QObject::tr("not enough memory for this mask"));
  return out;
}

}  // namespace

MaskDialog::MaskDialog(const Project& project, std::shared_ptr<const MaterialLibrary> library,
                       const QStringList& marked, const QString& folder, QWidget* parent)
    : QDialog(parent),
      project_(project),
      library_(std::move(library)),
      marked_(marked),
      name_(new QLineEdit(tr("Masked"), this)),
      mask_(new PathEdit(this)),
      folder_(new PathEdit(folder, this)),
      ball_(new QLabel(this)),
      note_(quiet_label(tr("What comes out"), this)),
      replace_(new QCheckBox(this)),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this)) {
  setWindowTitle(tr("Materials by mask"));
  setAccessibleName(windowTitle());
  auto* sides = new QHBoxLayout(this);
  auto* column = new QVBoxLayout;
  auto* form = new QFormLayout;
  sides->addLayout(column, 1);
  column->addLayout(form);
  const auto path_row = [&](const QString& title, PathEdit* line, const QString& tip,
                            void (MaskDialog::*ask)()) {
    auto* row = new QHBoxLayout;
    line->setAccessibleName(title);
    line->setToolTip(tip);
    line->setMinimumWidth(300);
    auto* button = new QPushButton(tr("Choose\u2026"), this);
    button->setAccessibleName(tr("Choose, %1").arg(title));
    button->setAutoDefault(false);
    row->addWidget(line, 1);
    row->addWidget(button);
    form->addRow(title, row);
    connect(button, &QPushButton::clicked, this, ask);
  };
  path_row(tr("Mask"), mask_, tr("Picture of greys or ID colours that says which texel is which material"),
           &MaskDialog::choose_mask);
  for (int i = 0; i < static_cast<int>(rows_.size()); ++i) {
    rows_[static_cast<std::size_t>(i)] = add_row(i);
    auto* row = new QHBoxLayout;
    row->addWidget(rows_[static_cast<std::size_t>(i)].code);
    row->addWidget(rows_[static_cast<std::size_t>(i)].material, 1);
    form->addRow(tr("Material %1").arg(i + 1), row);
  }
  name_->setAccessibleName(tr("Name of the new material"));
  form->addRow(tr("Name"), name_);
  path_row(tr("Folder"), folder_, tr("Where the textures and their manifest are written"),
           &MaskDialog::choose_folder);
  replace_->setAccessibleName(tr("Replace files"));
  column->addWidget(replace_);
  column->addWidget(note_);
  column->addStretch(1);
  buttons_->button(QDialogButtonBox::Ok)->setText(tr("&Make"));
  column->addWidget(buttons_);
  ball_->setAccessibleName(tr("Ball of the new material"));
  ball_->setFixedSize(ball_side, ball_side);
  ball_->setAlignment(Qt::AlignCenter);
  sides->addWidget(ball_);
  connect(buttons_, &QDialogButtonBox::accepted, this, &MaskDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(mask_, &QLineEdit::editingFinished, this, [this] {
    if (mask_->text() != surveyed_) take_mask(mask_->text());
  });
  connect(name_, &QLineEdit::textChanged, this, &MaskDialog::show_state);
  connect(folder_, &QLineEdit::textChanged, this, &MaskDialog::show_state);
  connect(replace_, &QCheckBox::toggled, this, &MaskDialog::show_state);
  mask_->setFocus();
  show_wanted();
}

MaskDialog::Row MaskDialog::add_row(int index) {
  Row out{new QLineEdit(this), new QuietComboBox(tr("Material %1").arg(index + 1), this)};
  out.code->setAccessibleName(tr("Code of material %1").arg(index + 1));
  out.code->setToolTip(tr("Its grey in the mask, 0 to 255, or its ID colour, such as #ff0000"));
  out.code->setFixedWidth(90);
  out.material->addItem(tr("none"));
  for (const ProjectMaterial& each : project_.materials)
    if (!has_packed_textures(each)) out.material->addItem(qt_text(each.name));
  if (index < marked_.size())
    out.material->setCurrentIndex(std::max(0, out.material->findText(marked_[index])));
  connect(out.code, &QLineEdit::editingFinished, this, &MaskDialog::show_wanted);
  connect(out.material, &QComboBox::currentIndexChanged, this, &MaskDialog::show_wanted);
  return out;
}

void MaskDialog::choose_mask() {
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Mask"), QFileInfo(mask_->text()).path(), picture_patterns());
  if (!path.isEmpty()) take_mask(path);
}

void MaskDialog::choose_folder() {
  const QString path = QFileDialog::getExistingDirectory(this, tr("Folder"), folder_->text());
  if (!path.isEmpty()) folder_->setText(path);
}

void MaskDialog::take_mask(const QString& path) {
  mask_->setText(path);
  surveyed_ = path;
  if (folder_->text().isEmpty()) folder_->setText(QFileInfo(path).path());
  work(
      [path = path.toStdString()] {
        Surveyed out;
        out.failure = failure_of([&] { out.survey = survey_mask(path, picture_door()); },
                                 QObject::tr("not enough memory for this mask"));
        return out;
      },
      [this, path](const Surveyed& result) {
        if (path != surveyed_) return;
        if (result.failure.isEmpty()) return propose(result.survey);
        fault_ = result.failure;
        show_state();
      });
  show_state();
}

void MaskDialog::propose(const MaskSurvey& survey) {
  for (std::size_t i = 0; i < rows_.size(); ++i)
    rows_[i].code->setText(i < survey.codes.size() ? text_of_code(survey.codes[i], survey.colors)
                                                   : QString());
  show_wanted();
}

MaskedMaterial MaskDialog::wanted(QString& fault) const {
  MaskedMaterial out;
  out.name = name_->text().trimmed().toStdString();
  out.mask = mask_->text().toStdString();
  bool any = false;
  for (const Row& row : rows_) {
    if (row.material->currentIndex() == 0) continue;
    const QString text = row.code->text().trimmed();
    const auto code = code_of_text(text);
    if (!code) {
      fault = tr("%1: %2; expected a grey of 0 to 255, or an ID colour such as #ff0000")
                  .arg(row.code->accessibleName(), text.isEmpty() ? tr("no code") : text);
      return out;
    }
    if (any && text.startsWith(u'#') != out.colors) {
      fault = tr("Codes are all greys or all ID colours");
      return out;
    }
    any = true;
    out.colors = text.startsWith(u'#');
    out.parts.push_back({*code, row.material->currentText().toStdString()});
  }
  if (out.mask.empty())
    fault = tr("Choose a mask");
  else if (out.parts.size() < MaterialMask::least_parts)
    fault = tr("Choose two to four materials of the project; those with textures are not offered");
  else if (out.name.empty())
    fault = tr("The material needs a name");
  return out;
}

// Draws the ball anew.
void MaskDialog::show_wanted() {
  QString fault;
  const MaskedMaterial masked = wanted(fault);
  fault_ = fault;
  if (!fault.isEmpty()) {
    ++asked_;
    ball_->clear();
    return show_state();
  }
  work([masked, project = project_, library = library_] { return shown_ball(masked, project, *library); },
       [this, asked = ++asked_](const Shown& shown) {
         if (asked != asked_) return;
         fault_ = shown.failure;
         ball_->setPixmap(QPixmap::fromImage(shown.ball));
         show_state();
       });
  show_state();
}

void MaskDialog::show_state() {
  QString fault;
  const MaskedMaterial masked = wanted(fault);
  if (fault.isEmpty()) fault = fault_;
  const auto there = masked_files_in(folder_->text().toStdString(), masked);
  replace_->setVisible(!there.empty() && fault.isEmpty());
  if (!there.empty())
    replace_->setText(
        there.size() == 1
            ? tr("&Replace %1").arg(qt_text(there.front()))
            : tr("&Replace %1 files that are there: %2\u2026").arg(there.size()).arg(qt_text(there.front())));
  const bool free = there.empty() || replace_->isChecked();
  note_->setText(
      !fault.isEmpty() ? fault
      : is_busy()
          ? tr("reading the mask\u2026")
          : tr("Each texel is one of the materials, so that no edge has an F0 of neither. Six textures "
               "(F0 and gloss, metal-rough) and their manifest for etak pack are written."));
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(fault.isEmpty() && free && !is_busy());
}

void MaskDialog::accept() {
  QString fault;
  const MaskedMaterial masked = wanted(fault);
  if (!fault.isEmpty() || !fault_.isEmpty() || is_busy()) return;
  work(
      [masked, project = project_, library = library_, folder = folder_->text().toStdString(),
       replace = replace_->isChecked()] {
        MaskWritten out;
        out.failure = failure_of(
            [&] {
              out.material =
                  write_masked(masked, project, *library, picture_door(), folder, replace, out.remarks);
            },
            QObject::tr("not enough memory for these textures"));
        return out;
      },
      [this](const MaskWritten& written) {
        fault_ = written.failure;
        if (!fault_.isEmpty()) return show_state();
        QStringList remarks;
        for (const std::string& each : written.remarks) remarks << qt_text(each);
        emit made(written.material, remarks);
        QDialog::accept();
      });
  show_state();
}

}  // namespace etak::editor
