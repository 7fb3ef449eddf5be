// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <memory>
#include <vector>

#include "app/document/document.h"

namespace etak::editor {

/// A copy of unsaved changes that a run left behind when it was killed.
struct Recovery {
  QString file;  // path of the copy
  QString path;  // file of the project; empty: the project was never saved
  QDateTime when;
  int materials = 0;
};
enum class RecoveryChoice { recover, keep, discard };

/// Keeps a copy of unsaved changes in a folder of its own. The copy is written a moment after each change and
/// removed once the changes are saved or given up. A lock beside each copy tells runs that are alive from
/// runs that were killed.
class Autosave : public QObject {
  Q_OBJECT

 public:
  Autosave(Document& document, const QString& folder, QObject* parent = nullptr);
  ~Autosave() override;

  /// The copies of runs that were killed. Locks and paths that such runs left without a copy are removed.
  /// Call it once, before this run has written a copy.
  std::vector<Recovery> left_behind();
  /// Removes a copy that the user has recovered or does not want.
  static void discard(const Recovery& recovery);

  /// Begins to write the copy now. Called before a save, so that the last state is kept if the save fails.
  void write_now();
  /// Waits until everything that was begun is on the disk. The thread that saves may call it, but not the
  /// user-interface thread.
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
