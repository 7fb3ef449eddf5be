// SPDX-License-Identifier: Apache-2.0
#include "app/document/file_watch.h"

#include <QFileInfo>

#include "app/viewport/qt_text.h"

namespace etak::editor {
namespace {

constexpr int renew_ms = 100, tell_ms = 100;

// Calls `use` with the path of each picture of a material.
template <class Use>
void each_picture(const ProjectMaterial& material, const Use& use) {
  for (const auto& texture : material.textures)
    if (texture) use(QFileInfo(qt_text(texture->path)).absoluteFilePath());
}

}  // namespace

FileWatch::FileWatch(Document& document, QObject* parent) : QObject(parent), document_(document) {
  for (QTimer* each : {&renew_timer_, &tell_timer_}) each->setSingleShot(true);
  renew_timer_.setInterval(renew_ms);
  tell_timer_.setInterval(tell_ms);
  connect(&renew_timer_, &QTimer::timeout, this, &FileWatch::renew);
  connect(&tell_timer_, &QTimer::timeout, this, &FileWatch::tell);
  const auto later = [this] {
    if (!renew_timer_.isActive()) renew_timer_.start();
  };
  connect(&document, &Document::replaced, this, later);
  connect(&document, &Document::materials_removed, this, later);
  connect(&document, &Document::material_changed, this, later);
  connect(&document, &Document::materials_added, this, later);
  connect(&watcher_, &QFileSystemWatcher::fileChanged, this, [this](const QString& path) {
    changed_.insert(path);
    tell_timer_.start();
  });
  connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, later);
}

// Watches all pictures, and the folder of each that is not there. A file that has come back has changed.
void FileWatch::renew() {
  QSet<QString> wanted;
  for (const ProjectMaterial& each : document_.project().materials)
    each_picture(each, [&](const QString& path) {
      wanted << (QFileInfo::exists(path) ? path : QFileInfo(path).absolutePath());
    });
  const QStringList now = watcher_.files() + watcher_.directories();
  const QSet<QString> watched(now.begin(), now.end());
  if (const QSet<QString> old = watched - wanted; !old.isEmpty()) watcher_.removePaths(old.values());
  const QSet<QString> fresh = wanted - watched;
  for (const QString& path : fresh)
    if (watched.contains(QFileInfo(path).absolutePath())) changed_.insert(path);
  if (!fresh.isEmpty()) watcher_.addPaths(fresh.values());
  if (!changed_.isEmpty()) tell_timer_.start();
}

void FileWatch::tell() {
  QStringList materials;
  for (const ProjectMaterial& each : document_.project().materials) {
    bool uses = false;
    each_picture(each, [&](const QString& path) { uses = uses || changed_.contains(path); });
    if (uses) materials << qt_text(each.name);
  }
  changed_.clear();
  // A program that saves a file by replacing it ends the watching of the old one.
  renew_timer_.start();
  if (!materials.isEmpty()) emit changed(materials);
}

}  // namespace etak::editor
