// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/inspector/texture_section.h"

#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMimeData>

#include "app/document/dropped_pictures.h"
#include "app/document/files.h"
#include "app/document/press_id.h"
#include "app/fields/add_button.h"
#include "app/fields/number_field.h"
#include "app/fields/path_edit.h"
#include "app/viewport/qt_text.h"
#include "app/viewport/viewport.h"

namespace etak::editor {
namespace {

QString title_of(Channel channel) {
  if (channel == Channel::alpha) return QObject::tr("Alpha opacity");
  QString out = text_of(channel);
  out[0] = out[0].toUpper();
  return out;
}

bool is_picture(const QString& path) {
  return kind_of_file(path) == FileKind::picture;
}

}  // namespace

TextureSection::TextureSection(Document& document, QWidget* parent)
    : Section(tr("Textures"), parent), document_(document) {
  for (const Channel channel : all_channels) {
    Row& row = rows_[static_cast<std::size_t>(channel)];
    auto* box = new QWidget(this);
    auto* line = new QHBoxLayout(box);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(3);
    const QString title = title_of(channel);
    row.path = new PathEdit(box);
    row.path->setPlaceholderText(tr("drop a picture here"));
    row.path->setAccessibleName(tr("%1 texture, file").arg(title));
    row.path->setAcceptDrops(false);  // the row takes dropped files; a line would paste their address
    line->addWidget(row.path, 1);
    const auto* open = add_button(*line, "\u2026", tr("Open the %1 texture").arg(title));
    row.look = add_button(*line, tr("2D"), tr("Look at the %1 texture").arg(title));
    row.clear = add_button(*line, "\u2715", tr("Remove the %1 texture").arg(title));
    box->setAcceptDrops(true);
    box->installEventFilter(this);
    box->setProperty("channel", static_cast<int>(channel));
    box->setAccessibleName(tr("%1 texture").arg(title));
    add(title, box,
        channel == Channel::normal ? tr("A normal map: where the surface leans, texel by texel")
        : channel == Channel::emission || channel == Channel::occlusion
            ? tr("A picture that the number above multiplies, where the material is drawn and exported")
            : tr("A picture in the place of the number, where the material is packed and drawn"));
    connect(row.path, &QLineEdit::editingFinished, this,
            [this, channel, path = row.path] { type(channel, *path); });
    connect(open, &QToolButton::clicked, this, [this, channel, title, path = row.path] {
      const QString now = path->text();
      const QString file = QFileDialog::getOpenFileName(
          this, tr("%1 texture").arg(title), now.isEmpty() ? document_.folder() : now,
          tr("Pictures (%1);;All files (*)").arg(picture_patterns()));
      if (!file.isEmpty()) emit dropped(channel, file);
    });
    connect(row.clear, &QToolButton::clicked, this, [this, channel] { set(channel, {}); });
    connect(row.look, &QToolButton::clicked, this, [this, channel] { emit look_asked(drawn_as(channel)); });
  }
  make_scale();
}

void TextureSection::make_scale() {
  scale_ = new QWidget(this);
  scale_->setAccessibleName(tr("UV scale"));
  auto* line = new QHBoxLayout(scale_);
  line->setContentsMargins(0, 0, 0, 0);
  for (const std::size_t axis : {0U, 1U}) {
    auto* box = scales_[axis] = new FineSpinBox(scale_);
    box->setRange(least_uv_scale, most_uv_scale);
    box->setAccessibleName(axis == 0 ? tr("UV scale, U") : tr("UV scale, V"));
    line->addWidget(box);
    connect(box, &FineSpinBox::edited, this, [this, axis](double value, int press) {
      document_.change_material(tr("UV scale"), press, [&](ProjectMaterial& m) { m.uv_scale[axis] = value; });
    });
  }
  add(tr("UV scale"), scale_,
      tr("How often the pictures repeat over the object along U and V, in the viewport and in exports"));
}

QWidget& TextureSection::line_of(Channel channel) {
  return *rows_[static_cast<std::size_t>(channel)].path;
}

bool TextureSection::eventFilter(QObject* object, QEvent* event) {
  if (event->type() == QEvent::DragEnter) {
    auto* drag = static_cast<QDragEnterEvent*>(event);
    const QStringList files = dragged_files(*drag->mimeData());
    if (std::any_of(files.begin(), files.end(), is_picture))
      drag->acceptProposedAction();
    else
      drag->ignore();
    return true;
  }
  if (event->type() == QEvent::Drop) {
    auto* drop = static_cast<QDropEvent*>(event);
    take_drop(static_cast<Channel>(object->property("channel").toInt()), dragged_files(*drop->mimeData()));
    drop->acceptProposedAction();
    return true;
  }
  return Section::eventFilter(object, event);
}

void TextureSection::take_drop(Channel channel, const QStringList& files) {
  const auto first = std::find_if(files.begin(), files.end(), is_picture);
  if (first != files.end()) emit dropped(channel, *first);
  for (auto each = files.begin(); each != files.end(); ++each) {
    if (each == first) continue;
    const QString name = QFileInfo(*each).fileName();
    return emit refused(
        is_picture(*each)
            ? tr("%1: a channel has one picture; %2 was taken").arg(name, QFileInfo(*first).fileName())
            : tr("%1 is no picture; expected %2").arg(name, picture_patterns()));
  }
}

// What is typed is looked at as what is dropped; until it is taken the line says what holds.
void TextureSection::type(Channel channel, QLineEdit& line) {
  const ProjectMaterial* m = document_.material();
  const QString typed = line.text().trimmed();
  const auto& texture = m != nullptr ? m->texture(channel) : std::nullopt;
  const QString now = texture ? qt_text(texture->path) : QString();
  if (typed == now || m == nullptr) return;
  if (typed.isEmpty()) return set(channel, {});
  line.setText(now);
  emit dropped(channel, typed);
}

void TextureSection::set(Channel channel, const QString& path) {
  document_.change_material(
      tr("%1 texture").arg(qt_text(name(channel))), next_press_id(), [&](ProjectMaterial& m) {
        const auto& texture = m.texture(channel);
        if (path.toStdString() == (texture ? texture->path : std::string())) return;
        set_texture(m, channel,
                    path.isEmpty() ? std::nullopt : std::optional(ImageSource{path.toStdString(), {}, {}}));
      });
}

void TextureSection::show_material(const ProjectMaterial* m) {
  for (const std::size_t axis : {0U, 1U}) scales_[axis]->show_value(m != nullptr ? m->uv_scale[axis] : 1);
  rows().setRowVisible(scale_, m != nullptr && m->textures != ProjectMaterial{}.textures);
  for (const Channel channel : all_channels) {
    Row& row = rows_[static_cast<std::size_t>(channel)];
    const bool has = m != nullptr && m->texture(channel).has_value();
    const QString path = has ? qt_text(m->texture(channel)->path) : QString();
    if (row.path->text() != path) row.path->setText(path);
    row.path->setToolTip(path);
    row.clear->setEnabled(has);
    row.look->setEnabled(has);
    // Sets bring these, and a material has either them or the pair's.
    if (channel > Channel::occlusion) rows().setRowVisible(row.path->parentWidget(), has);
  }
}

}  // namespace etak::editor
