// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <memory>
#include <vector>

#include "app/editor/document/document.h"

namespace etak::editor {

/// A state that a run left behind when it was killed.
struct Recovery {
  QString file;  // the saved state
  QString path;  // of the project it belongs to; empty: never saved
  QDateTime when;
  int materials = 0;
};
enum class RecoveryChoice { recover, keep, discard };

/// Keeps a copy of unsaved changes in a folder of its own, a moment after each, and takes it away once they
/// are saved or given up. A lock beside each copy tells runs that live from those that died.
class Autosave : public QObject {
  Q_OBJECT

 public:
  Autosave(Document& document, const QString& folder, QObject* parent = nullptr);
  ~Autosave() override;

  /// What dead runs left; locks and names that they left without a copy are removed. Call once, before this
  /// run has anything of its own.
  std::vector<Recovery> left_behind();
  /// Removes a copy that was taken up or declined.
  static void discard(const Recovery& recovery);

  /// Begins to write the copy now: before a save, so that the last state survives whatever happens in it.
  void write_now();
  /// Until what was begun is on the disk: for the thread that saves, not for that of windows.
  void wait();
  void set_delay(int milliseconds) { timer_.setInterval(milliseconds); }
  QString file() const { return file_; }

 private:
  void begin();
  void remove();
  void remove_stale() const;

  Document& document_;
  QString folder_, file_;
  std::unique_ptr<QLockFile> lock_;
  QTimer timer_;
  QThreadPool pool_;
};

}  // namespace etak::editor
