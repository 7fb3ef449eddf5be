// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QRectF>
#include <QWidget>

#include "app/document/document.h"
#include "app/viewport/background.h"
#include "core/atlas/sources/plane.h"

class QLabel;

namespace etak::editor {

class Histogram;
class QuietComboBox;

/// A flat picture of one channel of the material's textures. The wheel zooms, a drag moves the picture, a
/// double click fits it into the widget. A line tells what the texel under the cursor holds, or the one that the arrow keys
/// have gone to.
class TextureView : public QWidget {
  Q_OBJECT

 public:
  explicit TextureView(Document& document, QWidget* parent = nullptr);
  void show_channel(Channel channel);
  /// Frames a box of the material's pictures, in their own texels, as soon as they are there: until another material or
  /// a double click.
  void show_box(Channel channel, const PixelBox& box);
  /// The box that is framed, in texels of the picture that is shown; empty: none.
  QRectF shown_box() const;
  /// Reads the pictures whose files have changed. The old ones are shown until then.
  void read_again();
  /// Gives files that were decoded already to the next reading of pictures; none: takes them back.
  void take_known(DecodedFiles known);
  /// The textures for the viewport; null where there are none. textures_changed() is emitted when they are
  /// read.
  const std::shared_ptr<const SurfaceTextures>& textures() const { return textures_; }
  bool is_busy() const { return reading_; }
  /// Whether the pictures of the current material are still read, so that textures() are of none.
  bool is_waiting() const { return waiting_; }
  /// The text about the pictures: their size, or why there are none.
  QString summary() const;

 signals:
  void textures_changed();
  /// What is read now, for people; empty: nothing any more.
  void reading(const QString& what);

 private:
  class Sheet;
  struct FilesRead;
  struct PicturesKept;
  void load();
  void wait_for(const ProjectMaterial& material);
  void show_picture();
  void show_texel();

  Document& document_;
  QuietComboBox* channel_;
  QLabel *summary_, *texel_;
  Histogram* histogram_;
  Sheet* sheet_;
  Worker pool_;
  std::optional<ProjectMaterial> loaded_;
  decltype(ProjectMaterial::textures) shown_files_;  // whose pictures are shown, or could not be read
  std::shared_ptr<PicturesKept> kept_;
  DecodedFiles known_;
  bool reading_ = false, waiting_ = false;
  std::array<QImage, all_channels.size()> pictures_;  // one texel for channels that have none
  QSize shown_size_, whole_size_;                     // in which they are shown, and of the files
  std::optional<PixelBox> box_;                       // in texels of the files
  std::shared_ptr<const SurfaceTextures> textures_;
};

}  // namespace etak::editor
