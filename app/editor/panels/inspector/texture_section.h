// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/document/document.h"
#include "app/editor/panels/inspector/sections.h"

class QToolButton;

namespace etak::editor {

class FineSpinBox;

class PathEdit;

/// A picture file for each of the four channels. The user chooses it in a dialog, drops it on the row, or
/// types its path.
class TextureSection : public Section {
  Q_OBJECT

 public:
  explicit TextureSection(Document& document, QWidget* parent = nullptr);
  void show_material(const ProjectMaterial* material);  // null: none
  /// The line with the path of a channel's picture.
  QWidget& line_of(Channel channel);

 signals:
  void look_asked(etak::Channel channel);
  /// A picture was dropped on the row of a channel.
  void dropped(etak::Channel channel, const QString& file);
  void refused(const QString& why);

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  void make_scale();
  void set(Channel channel, const QString& path);
  void type(Channel channel, QLineEdit& line);
  void take_drop(Channel channel, const QStringList& files);
  struct Row {
    PathEdit* path = nullptr;
    QToolButton *clear = nullptr, *look = nullptr;
  };
  Document& document_;
  std::array<Row, all_channels.size()> rows_;
  QWidget* scale_ = nullptr;
  std::array<FineSpinBox*, 2> scales_{};
};

}  // namespace etak::editor
