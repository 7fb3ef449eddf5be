// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/texture_view.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QVBoxLayout>
#include <cmath>
#include <filesystem>

#include "app/editor/panels/sections.h"
#include "app/viewport/background.h"
#include "app/viewport/qt_text.h"
#include "core/base/error.h"
#include "core/image/image_io.h"
#include "core/project/project_pictures.h"

namespace etak::editor {
namespace {

constexpr int most_side = 1024;  // larger pictures are reduced to this side
constexpr std::size_t most_texels = std::size_t{128} << 20;

QImage rgb_image(const Image8& codes) {
  QImage out(codes.width, codes.height, QImage::Format_RGB888);
  for (int y = 0; y < codes.height; ++y)
    std::copy_n(codes.at(0, y).data(), std::size_t{3} * static_cast<std::size_t>(codes.width),
                out.scanLine(y));
  return out;
}

// The colour of a channel in the first texel.
QColor first_code(const SurfaceTextures& textures, Channel channel) {
  SurfaceTextures texel{Image(1, 1, 4), Image(1, 1, 4)};
  std::copy_n(textures.body.at(0, 0).data(), 4, texel.body.values.begin());
  std::copy_n(textures.gloss.at(0, 0).data(), 4, texel.gloss.values.begin());
  return rgb_image(channel_picture(texel, channel)).pixelColor(0, 0);
}

// When a file was written last, and its size. A file that cannot be asked has neither.
std::vector<std::pair<std::filesystem::file_time_type, std::uintmax_t>> stamps_of(const ProjectMaterial& m) {
  std::vector<std::pair<std::filesystem::file_time_type, std::uintmax_t>> out;
  for (const auto& texture : m.textures) {
    std::error_code none;
    if (texture)
      out.emplace_back(std::filesystem::last_write_time(texture->path, none),
                       std::filesystem::file_size(texture->path, none));
  }
  return out;
}

using Pictures = std::array<QImage, all_channels.size()>;

struct Loaded {
  Pictures pictures;
  std::shared_ptr<const SurfaceTextures> textures;
  QString text;
};

}  // namespace

// What was read of the files, for as long as they and the way in which they are used stay the same. Only the
// worker's thread looks into it.
struct TextureView::FilesRead {
  std::vector<std::pair<std::filesystem::file_time_type, std::uintmax_t>> stamps;
  Pictures pictures;
  std::optional<SurfaceTextures> textures;
  QString size;
};

namespace {

template <class Read>
void read_files(const ProjectMaterial& m, const MaterialLibrary& library, Read& read) {
  read.textures.reset();
  const MaterialPair pair = pictures_of(m, library, picture_door(), most_texels);
  read.size = QObject::tr("%1 x %2 texels").arg(pair.diffuse_alpha.width).arg(pair.diffuse_alpha.height);
  SurfaceTextures textures = surface_textures(pair, most_side);
  for (const Channel channel : all_channels)
    read.pictures[static_cast<std::size_t>(channel)] = rgb_image(channel_picture(textures, channel));
  read.textures = std::move(textures);
}

// The textures of the material as it is now, from the files where those have changed.
template <class Read>
Loaded loaded_from(const ProjectMaterial& m, const MaterialLibrary& library, Read& read) {
  Loaded out;
  try {
    if (auto stamps = stamps_of(m); !read.textures || stamps != read.stamps) {
      read.stamps = std::move(stamps);
      read_files(m, library, read);
    }
    out.textures = std::make_shared<const SurfaceTextures>(with_numbers_of(m, library, *read.textures));
    out.text = read.size;
    out.pictures = read.pictures;
    for (const Channel channel : all_channels)
      if (!m.texture(channel)) {
        QImage& picture = out.pictures[static_cast<std::size_t>(channel)];
        picture.fill(first_code(*out.textures, channel));
      }
  } catch (const Error& error) {
    out.text = QString::fromUtf8(error.what());
  } catch (const std::bad_alloc&) {
    out.text = QObject::tr("not enough memory for these pictures");
  }
  return out;
}

}  // namespace

class TextureView::Sheet : public QWidget {
 public:
  explicit Sheet(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Texture picture"));
    setFocusPolicy(Qt::StrongFocus);
    setMinimumHeight(60);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  }
  void set_picture(const QImage& picture) {
    picture_ = picture;
    update();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.fillRect(rect(), QColor(60, 60, 60));
    if (picture_.isNull()) return;
    const double fit = std::min(double(width()) / picture_.width(), double(height()) / picture_.height());
    const QSizeF size = QSizeF(picture_.size()) * fit * zoom_;
    painter.setRenderHint(QPainter::SmoothPixmapTransform, fit * zoom_ < 2);
    painter.drawImage(
        QRectF(QPointF((width() - size.width()) / 2, (height() - size.height()) / 2) + shift_, size),
        picture_);
  }
  void wheelEvent(QWheelEvent* event) override {
    zoom_ = std::clamp(zoom_ * std::pow(1.2, event->angleDelta().y() / 120.0), 0.2, 64.0);
    update();
    event->accept();
  }
  void mousePressEvent(QMouseEvent* event) override { last_ = event->position(); }
  void mouseMoveEvent(QMouseEvent* event) override {
    shift_ += event->position() - last_;
    last_ = event->position();
    update();
  }
  void mouseDoubleClickEvent(QMouseEvent*) override {
    zoom_ = 1;
    shift_ = {};
    update();
  }

 private:
  QImage picture_;
  double zoom_ = 1;
  QPointF shift_, last_;
};

TextureView::TextureView(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      channel_(new QuietComboBox(tr("Texture channel"), this)),
      summary_(quiet_label(tr("About the textures"), this)),
      sheet_(new Sheet(this)) {
  setAccessibleName(tr("Textures"));
  pool_.setMaxThreadCount(1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  auto* row = new QHBoxLayout;
  for (const Channel each : all_channels) channel_->addItem(qt_text(name(each)));
  row->addWidget(channel_);
  row->addWidget(summary_, 1);
  column->addLayout(row);
  column->addWidget(sheet_, 1);
  connect(channel_, &QComboBox::currentIndexChanged, this, &TextureView::show_picture);
  connect(&document, &Document::current_changed, this, &TextureView::load);
  connect(&document, &Document::replaced, this, &TextureView::load);
  connect(&document, &Document::material_changed, this, &TextureView::load);
  load();
}

TextureView::~TextureView() {
  pool_.clear();
  pool_.waitForDone();
}

QString TextureView::summary() const {
  return summary_->text();
}

void TextureView::show_channel(Channel channel) {
  channel_->setCurrentIndex(static_cast<int>(channel));
}

void TextureView::load() {
  const ProjectMaterial* m = document_.material();
  if (m == nullptr || !has_textures(*m)) {
    const bool had = textures_ != nullptr;
    loaded_.reset();
    read_.reset();
    reading_ = false;
    textures_.reset();
    pictures_ = {};
    summary_->setText(tr("no textures: drop pictures on the viewport or on the channels in the inspector"));
    show_picture();
    if (had) emit textures_changed();
    return;
  }
  // The texels do not depend on the name, the models and their parameters.
  ProjectMaterial key = *m;
  key.name.clear();
  key.specular_model.clear();
  key.diffuse_model.clear();
  key.parameters.clear();
  if (loaded_ == key) return;
  loaded_ = key;
  // Numbers alone need no file: a drag of a slider reads none.
  ProjectMaterial files;
  files.textures = m->textures;
  files.alpha_mode = m->alpha_mode;
  files.alpha_cutoff = m->alpha_cutoff;
  if (!read_ || files_ != files) read_ = std::make_shared<FilesRead>();
  files_ = files;
  pool_.clear();
  reading_ = true;
  in_background(
      pool_, this,
      [m = *m, library = document_.library(), read = read_] { return loaded_from(m, *library, *read); },
      [this, key](Loaded loaded) {
        if (loaded_ != key) return;
        reading_ = false;
        pictures_ = std::move(loaded.pictures);
        textures_ = std::move(loaded.textures);
        summary_->setText(loaded.text);
        show_picture();
        emit textures_changed();
      });
}

void TextureView::show_picture() {
  sheet_->set_picture(pictures_[static_cast<std::size_t>(std::max(0, channel_->currentIndex()))]);
}

}  // namespace etak::editor
