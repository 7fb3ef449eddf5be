// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <atomic>
#include <functional>
#include <memory>

#include "app/viewport/background.h"
#include "app/viewport/saved_view.h"

class QDialogButtonBox;
class QLabel;
class QProgressBar;
class QSpinBox;

namespace etak::editor {

class QuietComboBox;

/// Saves a picture of what the viewport shows, of any size, with or without its background, or a turntable of pictures. The
/// renderer of `etak render` draws them on a worker's thread. Cancelled, it leaves none of them.
class PictureDialog : public QDialog {
  Q_OBJECT

 public:
  ///   ask   asks for the name of the file; empty: the user has given up
  PictureDialog(SavedView view, std::function<QString()> ask, QWidget* parent = nullptr);
  ~PictureDialog() override { *cancelled_ = true; }
  void accept() override;  // asks for the name and draws; closes where that went well
  void reject() override;  // while it draws, cancels that
  bool is_running() const { return running_; }

 signals:
  void written(const QStringList& files);

 private:
  void run(const QStringList& files);
  void show_end(const QString& failure, const QStringList& files);

  SavedView view_;
  std::function<QString()> ask_;
  QSpinBox *width_ = nullptr, *height_ = nullptr, *count_ = nullptr;
  QuietComboBox* background_;
  QLabel* note_;
  QProgressBar* bar_;
  QDialogButtonBox* buttons_;
  bool running_ = false;
  std::shared_ptr<std::atomic<bool>> cancelled_ = std::make_shared<std::atomic<bool>>(false);
  Worker pool_;
};

}  // namespace etak::editor
