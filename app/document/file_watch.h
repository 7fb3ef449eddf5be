// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFileSystemWatcher>
#include <QSet>
#include <QTimer>

#include "app/document/document.h"

namespace etak::editor {

/// Tells when picture files of the project's materials have changed on the disk. A file that is replaced or comes back is
/// watched further.
class FileWatch : public QObject {
  Q_OBJECT

 public:
  explicit FileWatch(Document& document, QObject* parent);

 signals:
  /// Names the materials that use one of the files.
  void changed(const QStringList& materials);

 private:
  void renew();
  void tell();

  Document& document_;
  QFileSystemWatcher watcher_;
  QTimer renew_timer_, tell_timer_;  // once for changes that follow each other closely
  QSet<QString> changed_;
};

}  // namespace etak::editor
