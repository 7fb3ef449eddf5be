// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/pack_dialog.h"

#include <QFontDatabase>
#include <QLabel>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <filesystem>

#include "app/document/pictures.h"
#include "app/viewport/background.h"
#include "core/base/error.h"
#include "core/base/files/output.h"
#include "core/findings/output/formats.h"
#include "core/pack/pack.h"
#include "core/project/project_pack.h"
#include "core/validate/check_pack.h"

namespace etak::editor {
namespace {

struct Done {
  bool written = false;
  QString text;
};

// The configuration with which `etak pack -o folder` checks an atlas when it is called in the folder around
// it.
PackCheckOptions check_options(const std::string& folder, unsigned threads) {
  PackCheckOptions out;
  const std::string layout = folder + "/layout.json";
  out.config = read_config(find_config(layout));
  if (out.config.file.empty())
    out.config.root =
        std::filesystem::absolute(layout).lexically_normal().parent_path().parent_path().string();
  out.threads = threads;
  out.version = ETAK_VERSION;
  return out;
}

}  // namespace

PackDialog::PackDialog(const Project& project, std::shared_ptr<const MaterialLibrary> library,
                       const QString& label, const QString& folder, QWidget* parent)
    : QDialog(parent),
      project_(project),
      library_(std::move(library)),
      label_(label),
      folder_(folder),
      bar_(new QProgressBar(this)),
      text_(new QLabel(tr("Packing %1 materials into %2").arg(project.materials.size()).arg(folder), this)),
      report_(new QPlainTextEdit(this)),
      button_(new QPushButton(tr("Cancel"), this)) {
  setWindowTitle(tr("Pack the atlas"));
  setAccessibleName(tr("Pack the atlas"));
  auto* column = new QVBoxLayout(this);
  text_->setWordWrap(true);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  text_->setAccessibleName(tr("What packing is at"));
  text_->setMinimumWidth(420);
  // The report is a table, so its font has a fixed width.
  report_->setReadOnly(true);
  report_->setTabChangesFocus(true);
  report_->setLineWrapMode(QPlainTextEdit::WidgetWidth);
  report_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  report_->setAccessibleName(tr("Report of packing"));
  report_->setMinimumSize(680, 220);
  report_->hide();
  bar_->setRange(0, 0);
  bar_->setAccessibleName(tr("Progress"));
  button_->setAccessibleName(tr("Cancel packing"));
  column->addWidget(text_);
  column->addWidget(bar_);
  column->addWidget(report_, 1);
  column->addWidget(button_, 0, Qt::AlignRight);
  connect(button_, &QPushButton::clicked, this, [this] {
    if (running_)
      reject();
    else
      accept();
  });
}

void PackDialog::start() {
  running_ = true;
  PackOptions options;
  options.input.pictures.door = picture_door();
  options.run.threads = static_cast<unsigned>(std::max(1, QThread::idealThreadCount()));
  options.run.version = ETAK_VERSION;
  options.output.overwrite = false;
  options.run.cancelled = [flag = cancelled_] { return flag->load(); };
  // The bar is updated at every hundredth, so that thousands of regions do not flood the user interface with
  // calls.
  const QPointer<PackDialog> self(this);
  auto last_share = std::make_shared<std::size_t>(0);
  options.run.progress = [self, last_share](std::size_t done, std::size_t all) {
    const std::size_t share = all == 0 ? 0 : 100 * done / all;
    if (share == *last_share) return;
    *last_share = share;
    call_in_ui([self, share] {
      if (!self) return;
      self->bar_->setRange(0, 100);
      self->bar_->setValue(static_cast<int>(share));
    });
  };
  in_background(
      pool_, this,
      [project = project_, library = library_, label = label_.toStdString(), folder = folder_.toStdString(),
       options]() mutable {
        Done out;
        try {
          PackCheck check(folder, check_options(folder, options.run.threads));
          check.attach(options);
          options.check.beside = [&](PackResult& packed, OutputFolder*) -> std::unique_ptr<Output> {
            check.finish(packed);
            return nullptr;
          };
          const PackResult report =
              pack(packed_manifest(project, *library), label, folder, options, *library);
          out.written = true;
          out.text = QString::fromStdString(report_text(report, false) + validation_text(*check.report()));
          for (const std::string& remark : report.remarks) out.text += QString::fromStdString(remark) + '\n';
        } catch (const PackCancelled&) {
          out.text = QObject::tr("Cancelled: nothing was written.");
        } catch (const Error& error) {
          out.text = QString::fromUtf8(error.what());
        } catch (const std::bad_alloc&) {
          out.text = QObject::tr("Not enough memory: nothing was written.");
        }
        return out;
      },
      [this](const Done& done) {
        running_ = false;
        bar_->setRange(0, 1);
        bar_->setValue(done.written ? 1 : 0);
        if (done.written) {
          text_->setText(tr("Packed into %1").arg(folder_));
          report_->setPlainText(done.text.trimmed());
          report_->show();
          adjustSize();
        } else {
          text_->setText(done.text.trimmed());
        }
        button_->setText(tr("Close"));
        button_->setAccessibleName(tr("Close"));
        emit finished_packing(done.written);
      });
}

void PackDialog::reject() {
  if (!running_) return QDialog::reject();
  *cancelled_ = true;
  button_->setText(tr("Cancelling\u2026"));
}

QString PackDialog::result_text() const {
  return (text_->text() + '\n' + report_->toPlainText()).trimmed();
}

}  // namespace etak::editor
