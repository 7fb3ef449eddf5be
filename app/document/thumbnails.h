// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCache>
#include <QImage>
#include <QObject>
#include <QPixmap>
#include <QSet>
#include <functional>
#include <memory>

#include "app/viewport/background.h"
#include "core/render/scene.h"

namespace etak::editor {

/// A picture of a material in the studio's light, drawn by the calling thread; of a sphere the ball alone, on nothing.
///   textures   null: none
QImage ball_picture(const SurfaceValues& surface, Shape shape, int side,
                    std::shared_ptr<const SurfaceTextures> textures = nullptr);

/// Small pictures of materials, which core renders on threads of their own. They are kept in memory and on
/// disk.
class Thumbnails : public QObject {
  Q_OBJECT

 public:
  /// The material of a picture. Both functions are called on a worker's thread and may throw Error: `text`
  /// identifies the picture on disk; `surface` is called only where the disk has no picture.
  struct Subject {
    std::function<std::string()> text;
    std::function<SurfaceValues()> surface;
  };

  ///   folder   folder of the files; empty: none are kept
  Thumbnails(const QString& folder, QObject* parent = nullptr);

  /// The picture, if it is there. Otherwise an empty one: the work is then begun, and ready() is emitted at
  /// its end.
  ///   key   identifies the material, without shape and size
  QPixmap get(const QString& key, Shape shape, int side, double ratio,
              const std::function<Subject()>& subject);
  bool is_idle() const { return waiting_.isEmpty(); }

 signals:
  void ready(const QString& key);

 private:
  QString folder_;
  QCache<QString, QPixmap> pictures_;
  QSet<QString> waiting_;
  Worker pool_;
};

}  // namespace etak::editor
