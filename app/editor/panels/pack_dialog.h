// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <atomic>
#include <memory>

#include "app/viewport/background.h"
#include "core/project/project.h"

class QLabel;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;

namespace etak::editor {

/// Packs the atlas of a project on a worker's thread and shows the progress. The user can cancel the work,
/// which leaves the folder as it was. The report ends with the findings of the validator, as that of etak
/// pack does.
class PackDialog : public QDialog {
  Q_OBJECT

 public:
  PackDialog(const Project& project, std::shared_ptr<const MaterialLibrary> library, const QString& label,
             const QString& folder, QWidget* parent = nullptr);
  ~PackDialog() override { *cancelled_ = true; }

  void start();
  void reject() override;  // while it packs, cancels the work
  bool is_running() const { return running_; }
  QString result_text() const;

 signals:
  void finished_packing(bool written);

 private:
  Project project_;
  std::shared_ptr<const MaterialLibrary> library_;
  QString label_, folder_;
  std::shared_ptr<std::atomic<bool>> cancelled_ = std::make_shared<std::atomic<bool>>(false);
  Worker pool_;
  QProgressBar* bar_;
  QLabel* text_;
  QPlainTextEdit* report_;
  QPushButton* button_;
  bool running_ = false;
};

}  // namespace etak::editor
