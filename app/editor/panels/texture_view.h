// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QThreadPool>
#include <QWidget>

#include "app/editor/document/document.h"

class QLabel;

namespace etak::editor {

class QuietComboBox;

/// A channel of the material's textures, flat. The wheel zooms, a drag moves, a double click fits.
class TextureView : public QWidget {
  Q_OBJECT

 public:
  explicit TextureView(Document& document, QWidget* parent = nullptr);
  ~TextureView() override;
  void show_channel(Channel channel);
  /// Told when the pair was read, for the viewport.
  const std::shared_ptr<const SurfaceTextures>& textures() const { return textures_; }
  bool is_busy() const { return reading_; }
  /// What is told of the pictures: their size, or why there are none.
  QString summary() const;

 signals:
  void textures_changed();

 private:
  class Sheet;
  void load();
  void show_picture();

  Document& document_;
  QuietComboBox* channel_;
  QLabel* summary_;
  Sheet* sheet_;
  QThreadPool pool_;
  std::optional<ProjectMaterial> loaded_;
  bool reading_ = false;
  std::array<QImage, all_channels.size()> pictures_;
  std::shared_ptr<const SurfaceTextures> textures_;
};

}  // namespace etak::editor
