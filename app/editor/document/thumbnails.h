// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCache>
#include <QImage>
#include <QObject>
#include <QPixmap>
#include <QSet>
#include <QThreadPool>
#include <functional>

#include "core/render/scene.h"

namespace etak::editor {

/// Small pictures of materials, rendered by core on threads of their own and kept in memory and on disk.
class Thumbnails : public QObject {
  Q_OBJECT

 public:
  /// What is to be drawn, made on a worker's thread: its text tells one picture from another on disk, its
  /// surface is asked for only where the disk has none. Both may throw etak::Error.
  struct Subject {
    std::function<std::string()> text;
    std::function<SurfaceValues()> surface;
  };

  /// `folder` for the files; empty: none are kept.
  Thumbnails(const QString& folder, QObject* parent = nullptr);
  ~Thumbnails() override;

  /// The picture if there is one; otherwise nothing, the work is begun and ready() tells of it.
  ///   key   who asks, without shape and size
  QPixmap get(const QString& key, Shape shape, int side, double ratio,
              const std::function<Subject()>& subject);
  void forget(const QString& key);
  bool is_idle() const { return waiting_.isEmpty(); }

 signals:
  void ready(const QString& key);

 private:
  QString folder_;
  QCache<QString, QPixmap> pictures_;
  QSet<QString> waiting_;
  QThreadPool pool_;
};

}  // namespace etak::editor
