// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QWidget>

#include "app/editor/document/document.h"
#include "app/viewport/background.h"

class QLabel;

namespace etak::editor {

class QuietComboBox;

/// A flat picture of one channel of the material's textures. The wheel zooms, a drag moves the picture, a
/// double click fits it into the widget.
class TextureView : public QWidget {
  Q_OBJECT

 public:
  explicit TextureView(Document& document, QWidget* parent = nullptr);
  void show_channel(Channel channel);
  /// The textures for the viewport; null where there are none. textures_changed() is emitted when they are
  /// read.
  const std::shared_ptr<const SurfaceTextures>& textures() const { return textures_; }
  bool is_busy() const { return reading_; }
  /// The text about the pictures: their size, or why there are none.
  QString summary() const;

 signals:
  void textures_changed();

 private:
  class Sheet;
  struct FilesRead;
  void take_current();
  void load();
  void show_picture();

  Document& document_;
  QuietComboBox* channel_;
  QLabel* summary_;
  Sheet* sheet_;
  Worker pool_;
  std::optional<ProjectMaterial> loaded_;
  std::shared_ptr<FilesRead> read_;
  bool reading_ = false;
  std::array<QImage, all_channels.size()> pictures_;  // one texel for channels that have none
  QSize shown_size_;                                  // in which they are shown
  std::shared_ptr<const SurfaceTextures> textures_;
};

}  // namespace etak::editor
