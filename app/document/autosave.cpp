// SPDX-License-Identifier: Apache-2.0
#include "app/document/autosave.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QUuid>

#include "app/viewport/background.h"
#include "core/base/files/file.h"

namespace etak::editor {
namespace {

constexpr int delay_ms = 1000;

// Writes a copy, which is two files: the project with absolute paths, and beside it the path of the project's
// file.
void write_copy(const Project& project, const QString& path, const QString& file) {
  // A folder that cannot be written must not keep the user from working.
  (void)failure_of([&] {
    write_file((file + ".path").toStdString(), path.toStdString(), true);
    write_file(file.toStdString(), format_project(project, ""), true);
  });
}

}  // namespace

Autosave::Autosave(Document& document, const QString& folder, QObject* parent)
    : QObject(parent), document_(document), folder_(folder + "/autosave") {
  pool_.setMaxThreadCount(1);
  QDir().mkpath(folder_);
  file_ = folder_ + '/' + QUuid::createUuid().toString(QUuid::WithoutBraces) + ".json";
  lock_ = std::make_unique<QLockFile>(file_ + ".lock");
  lock_->setStaleLockTime(0);
  lock_->tryLock(0);
  timer_.setSingleShot(true);
  timer_.setInterval(delay_ms);
  connect(&timer_, &QTimer::timeout, this, &Autosave::begin);
  // These signals come before the undo stack counts the change. Whether there is something to keep is
  // therefore asked in begin(), when the time is over.
  // The first change starts the time and later ones do not start it anew: a drag that goes on is kept, too.
  const auto changed = [this] {
    if (!timer_.isActive()) timer_.start();
  };
  connect(&document, &Document::material_changed, this, changed);
  connect(&document, &Document::materials_added, this, changed);
  connect(&document, &Document::materials_removed, this, changed);
  connect(&document, &Document::view_changed, this, changed);
  connect(&document, &Document::replaced, this, changed);
  connect(&document, &Document::saved_changed, this, [this] {
    if (document_.is_saved()) remove();
  });
}

Autosave::~Autosave() {
  remove();
  pool_.waitForDone();
}

void Autosave::remove_stale() const {
  const QDir folder(folder_);
  for (const char* ending : {".lock", ".path"})
    for (const QString& name : folder.entryList({"*.json" + QLatin1String(ending)}, QDir::Files)) {
      const QString copy = folder.filePath(name).chopped(static_cast<qsizetype>(qstrlen(ending)));
      if (copy == file_ || QFile::exists(copy)) continue;
      QLockFile lock(copy + ".lock");
      lock.setStaleLockTime(0);
      if (!lock.tryLock(0)) continue;  // the run of this lock is still alive and has nothing to keep now
      QFile::remove(copy + ".path");
    }
}

std::vector<Recovery> Autosave::left_behind() {
  remove_stale();
  std::vector<Recovery> out;
  const QDir folder(folder_);
  for (const QString& name : folder.entryList({"*.json"}, QDir::Files, QDir::Time)) {
    Recovery one{folder.filePath(name), {}, {}, 0};
    if (one.file == file_) continue;
    QLockFile lock(one.file + ".lock");
    lock.setStaleLockTime(0);
    if (!lock.tryLock(0)) continue;  // the run of this copy is still alive
    QFile path(one.file + ".path");
    if (path.open(QIODevice::ReadOnly)) one.path = QString::fromUtf8(path.readAll());
    one.when = QFileInfo(one.file).lastModified();
    if (QFile copy(one.file); copy.open(QIODevice::ReadOnly))
      one.materials = static_cast<int>(
          QJsonDocument::fromJson(copy.readAll()).object().value("materials").toArray().size());
    out.push_back(one);
  }
  return out;
}

void Autosave::discard(const Recovery& recovery) {
  for (const char* ending : {"", ".path", ".lock"}) QFile::remove(recovery.file + QLatin1String(ending));
}

void Autosave::begin() {
  if (document_.is_saved()) return;
  run_in(pool_, [project = document_.project(), path = document_.path(), file = file_] {
    write_copy(project, path, file);
  });
}

void Autosave::write_now() {
  timer_.stop();
  begin();
}

void Autosave::wait() {
  pool_.waitForDone();
}

void Autosave::remove() {
  timer_.stop();
  // The removal goes into the queue of the pool, behind a copy that is being written.
  run_in(pool_, [file = file_] {
    for (const char* ending : {"", ".path"}) QFile::remove(file + QLatin1String(ending));
  });
}

}  // namespace etak::editor
