// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/texture_view.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <functional>
#include <list>
#include <optional>
#include <utility>

#include "app/document/pictures.h"
#include "app/editor/panels/histogram.h"
#include "app/editor/panels/inspector/sections.h"
#include "app/editor/panels/texel_text.h"
#include "app/viewport/background.h"
#include "app/viewport/qt_picture.h"
#include "app/viewport/qt_text.h"
#include "core/color/srgb.h"
#include "core/judge/nearest.h"
#include "core/project/project_pictures.h"

namespace etak::editor {
namespace {

constexpr int most_side = 1024;  // larger pictures are reduced to this side
constexpr std::size_t most_texels = std::size_t{128} << 20;

using Pictures = std::array<QImage, all_channels.size()>;

// What a renderer gets of a material stands first among the channels.
bool is_shown(Channel channel) {
  return channel <= Channel::occlusion || channel == Channel::normal;
}

struct Loaded {
  Pictures pictures;  // one texel for channels that have none
  QSize shown_size;   // in which all of them are shown
  QSize whole_size;   // of the files
  std::shared_ptr<const SurfaceTextures> textures;
  QString text;
};

}  // namespace

// The pictures of the files of a material, kept as long as the files and the way in which they are used stay the same.
struct TextureView::FilesRead {
  PicturesKey key;
  Pictures pictures = {};
  QSize shown_size = {};  // of the pictures
  QSize whole_size = {};  // of the files
  std::shared_ptr<const SurfaceTextures> textures = {};
  QString size = {};
};

// Those of the materials that were looked at last, the last one first. Only the worker's thread looks into it.
struct TextureView::PicturesKept {
  static constexpr std::size_t most = 8;  // of 32 MB at the most
  std::list<FilesRead> read;
};

namespace {

template <class Read>
void read_files(const ProjectMaterial& m, const MaterialLibrary& library, const DecodedFiles& decoded,
                Read& read) {
  SurfacePicturesRead made =
      read_surface_textures(m, library, picture_door(), most_side, most_texels, decoded);
  const auto textures = std::make_shared<const SurfaceTextures>(std::move(made.textures));
  read.whole_size = QSize(made.width, made.height);
  read.size = QObject::tr("%1 x %2 texels").arg(read.whole_size.width()).arg(read.whole_size.height());
  for (const Channel channel : all_channels) {
    if (!is_shown(channel) || !gives(m, channel)) continue;
    QImage& picture = read.pictures[static_cast<std::size_t>(channel)];
    picture = qt_image(channel_picture(*textures, channel));
    read.shown_size = read.shown_size.expandedTo(picture.size());
  }
  read.textures = textures;
  (void)KnownMaterials::builtin().f0();  // computed here, so that the first texel is told at once
}

// The codes of a channel without a picture, as they would be packed.
QColor packed_color(const ProjectMaterial& m, const MaterialPair& numbers, Channel channel) {
  if (channel == Channel::emission) return qt_color(srgb_u8(m.emission));
  if (channel == Channel::normal) return {128, 128, 255};
  if (channel == Channel::occlusion) {
    const int grey = to_code(static_cast<float>(m.occlusion));
    return {grey, grey, grey};
  }
  const bool body = channel == Channel::diffuse || channel == Channel::alpha;
  const auto texel = (body ? numbers.diffuse_alpha : numbers.specular_gloss).at(0, 0);
  return is_color(channel) ? QColor(texel[0], texel[1], texel[2]) : QColor(texel[3], texel[3], texel[3]);
}

// The textures of the material as it is now, from the files where those were not read or have changed.
template <class Kept>
Loaded loaded_from(const ProjectMaterial& m, const MaterialLibrary& library, const DecodedFiles& decoded,
                   Kept& kept) {
  Loaded out;
  const auto work = [&] {
    PicturesKey key(m);
    auto& all = kept.read;
    const auto known = std::ranges::find_if(all, [&](const auto& each) { return each.key == key; });
    if (known != all.end()) {
      all.splice(all.begin(), all, known);
    } else {
      std::remove_reference_t<decltype(all)> fresh;
      fresh.push_back({std::move(key)});
      read_files(m, library, decoded, fresh.front());
      all.splice(all.begin(), fresh);
      if (all.size() > Kept::most) all.pop_back();
    }
    const auto& read = all.front();
    out.textures = read.textures;
    out.text = read.size;
    out.pictures = read.pictures;
    out.shown_size = read.shown_size;
    out.whole_size = read.whole_size;
    ProjectMaterial plain = m;
    plain.textures = {};
    const MaterialPair numbers = pictures_of(plain, library, PictureDoor());
    for (const Channel channel : all_channels)
      if (is_shown(channel) && !gives(m, channel)) {
        QImage& picture = out.pictures[static_cast<std::size_t>(channel)];
        picture = QImage(1, 1, QImage::Format_RGB888);
        picture.fill(packed_color(m, numbers, channel));
      }
  };
  const QString failure = failure_of(work, QObject::tr("not enough memory for these pictures"));
  if (!failure.isEmpty()) out.text = failure;
  return out;
}

}  // namespace

class TextureView::Sheet : public QWidget {
 public:
  explicit Sheet(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Texture picture"));
    setFocusPolicy(Qt::StrongFocus);
    setMinimumHeight(60);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  }
  std::function<void(const QPoint& texel)> marked;  // called with a texel, or -1, -1
  const QPoint& texel() const { return marked_; }
  std::function<void()> fitted;  // called where the whole picture is asked for
  //   size   in which a picture of one texel is shown, too
  //   box    that is framed, as a share of the picture; empty: none
  void set_picture(const QImage& picture, const QSize& size, const QRectF& box) {
    picture_ = picture;
    size_ = size;
    if (box != box_ && !box.isEmpty()) zoom_to(box);
    box_ = box;
    update();
  }
  QRectF box() const { return box_; }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.fillRect(rect(), QColor(60, 60, 60));
    if (picture_.isNull()) return;
    painter.setRenderHint(QPainter::SmoothPixmapTransform, shown_rect().width() < 2 * size_.width());
    painter.drawImage(shown_rect(), picture_);
    const QRectF all = shown_rect();
    if (!box_.isEmpty()) {
      const QRectF frame(all.x() + box_.x() * all.width(), all.y() + box_.y() * all.height(),
                         std::max(4.0, box_.width() * all.width()),
                         std::max(4.0, box_.height() * all.height()));
      for (const auto& [color, width] : {std::pair{Qt::black, 4}, {Qt::yellow, 2}}) {
        painter.setPen(QPen(color, width));
        painter.drawRect(frame.adjusted(-2, -2, 2, 2));
      }
    }
    if (!hasFocus() || marked_.x() < 0) return;
    const double w = all.width() / picture_.width(), h = all.height() / picture_.height();
    painter.setPen(QPen(Qt::white, 1));
    painter.drawRect(
        QRectF(all.x() + marked_.x() * w, all.y() + marked_.y() * h, std::max(w, 3.0), std::max(h, 3.0)));
  }
  void keyPressEvent(QKeyEvent* event) override {
    const int x = event->key() == Qt::Key_Right  ? 1
                  : event->key() == Qt::Key_Left ? -1
                                                 : 0,
              y = event->key() == Qt::Key_Down ? 1
                  : event->key() == Qt::Key_Up ? -1
                                               : 0;
    if (picture_.isNull() || (x == 0 && y == 0)) return event->ignore();
    const QPoint from =
        marked_.x() < 0 ? QPoint(picture_.width() / 2, picture_.height() / 2) : marked_ + QPoint(x, y);
    mark({std::clamp(from.x(), 0, picture_.width() - 1), std::clamp(from.y(), 0, picture_.height() - 1)});
  }
  void leaveEvent(QEvent*) override { mark({-1, -1}); }
  void wheelEvent(QWheelEvent* event) override {
    zoom_ = std::clamp(zoom_ * std::pow(1.2, event->angleDelta().y() / 120.0), 0.2, 64.0);
    update();
    event->accept();
  }
  void mousePressEvent(QMouseEvent* event) override { last_ = event->position(); }
  void mouseMoveEvent(QMouseEvent* event) override {
    if (event->buttons() == Qt::NoButton) return mark(texel_at(event->position()));
    shift_ += event->position() - last_;
    last_ = event->position();
    update();
  }
  void mouseDoubleClickEvent(QMouseEvent*) override {
    zoom_ = 1;
    shift_ = {};
    if (fitted) fitted();
    update();
  }

 private:
  // Brings a part of the picture into the middle, with as much around it on each side.
  void zoom_to(const QRectF& part) {
    zoom_ = 1;
    shift_ = {};
    if (size_.isEmpty() || width() == 0) return;
    const QSizeF all = shown_rect().size();
    zoom_ = std::clamp(
        std::min(width() / (3 * part.width() * all.width()), height() / (3 * part.height() * all.height())),
        1.0, 64.0);
    const QPointF off = QPointF(0.5, 0.5) - part.center();
    shift_ = {off.x() * all.width() * zoom_, off.y() * all.height() * zoom_};
  }
  // Where the whole picture is drawn.
  QRectF shown_rect() const {
    const double fit = std::min(double(width()) / size_.width(), double(height()) / size_.height());
    const QSizeF size = QSizeF(size_) * fit * zoom_;
    return {QPointF((width() - size.width()) / 2, (height() - size.height()) / 2) + shift_, size};
  }
  QPoint texel_at(const QPointF& position) const {
    const QRectF all = shown_rect();
    if (picture_.isNull() || !all.contains(position)) return {-1, -1};
    return {static_cast<int>((position.x() - all.x()) / all.width() * picture_.width()),
            static_cast<int>((position.y() - all.y()) / all.height() * picture_.height())};
  }
  void mark(const QPoint& texel) {
    marked_ = texel;
    update();
    if (marked) marked(texel);
  }

  QPoint marked_{-1, -1};
  QImage picture_;
  QSize size_;
  QRectF box_;
  double zoom_ = 1;
  QPointF shift_, last_;
};

TextureView::TextureView(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      channel_(new QuietComboBox(tr("Texture channel"), this)),
      summary_(quiet_label(tr("About the textures"), this)),
      texel_(quiet_label(tr("Texel under the cursor"), this)),
      histogram_(new Histogram(this)),
      sheet_(new Sheet(this)) {
  setAccessibleName(tr("Textures"));
  auto* column = panel_column(this, 6);
  auto* row = new QHBoxLayout;
  for (const Channel each : all_channels)
    if (is_shown(each)) channel_->addItem(qt_text(name(each)), static_cast<int>(each));
  row->addWidget(channel_);
  row->addWidget(summary_, 1);
  row->addWidget(histogram_, 1);
  column->addLayout(row);
  column->addWidget(sheet_, 1);
  column->addWidget(texel_);
  texel_->setText(QString(QChar::Space));  // keeps its line
  sheet_->marked = [this](const QPoint&) { show_texel(); };
  sheet_->fitted = [this] {
    box_.reset();
    show_picture();
  };
  // Before load() is, so that a box of the material before is gone.
  connect(&document, &Document::current_changed, this, [this] { box_.reset(); });
  connect(channel_, &QComboBox::currentIndexChanged, this, &TextureView::show_picture);
  connect(&document, &Document::current_changed, this, &TextureView::load);
  connect(&document, &Document::replaced, this, [this] {
    kept_.reset();
    load();
  });
  connect(&document, &Document::material_changed, this, &TextureView::load);
  load();
}

QString TextureView::summary() const {
  return summary_->text();
}

void TextureView::show_channel(Channel channel) {
  channel_->setCurrentIndex(channel_->findData(static_cast<int>(drawn_as(channel))));
}

void TextureView::show_box(Channel channel, const PixelBox& box) {
  box_ = box;
  show_channel(channel);
  show_picture();
}

QRectF TextureView::shown_box() const {
  const QRectF part = sheet_->box();
  return {part.x() * shown_size_.width(), part.y() * shown_size_.height(), part.width() * shown_size_.width(),
          part.height() * shown_size_.height()};
}

void TextureView::take_known(DecodedFiles known) {
  known_ = std::move(known);
}

void TextureView::read_again() {
  loaded_.reset();
  load();
}

// The pictures of the material before are not shown with the numbers of this one. The viewport keeps its frame until
// those of this one are there.
void TextureView::wait_for(const ProjectMaterial& material) {
  waiting_ = true;
  textures_.reset();
  pictures_ = {};
  const auto count =
      std::ranges::count_if(material.textures, [](const auto& each) { return each.has_value(); });
  const QString what =
      count == 1 ? tr("reading 1 picture\u2026") : tr("reading %1 pictures\u2026").arg(count);
  summary_->setText(what);
  show_picture();
  emit reading(what);
}

void TextureView::show_texel() {
  const auto channel = static_cast<Channel>(channel_->currentData().toInt());
  const ProjectMaterial* m = document_.material();
  const bool has = textures_ != nullptr && m != nullptr && gives(*m, channel);
  const QString text = has ? texel_text(*textures_, channel, sheet_->texel()) : QString();
  texel_->setText(text.isEmpty() ? QString(QChar::Space) : text);
}

void TextureView::load() {
  const ProjectMaterial* m = document_.material();
  if (m == nullptr || !has_textures(*m)) {
    const bool had = textures_ != nullptr || waiting_;
    if (waiting_) emit reading({});
    loaded_.reset();
    shown_files_ = {};
    reading_ = waiting_ = false;
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
  key.uv_scale = {1, 1};
  if (loaded_ == key) return;
  loaded_ = key;
  if (!kept_) kept_ = std::make_shared<PicturesKept>();
  pool_.clear();
  reading_ = true;
  if (m->textures != shown_files_) wait_for(*m);
  in_background(
      pool_, this,
      [m = *m, library = document_.library(), kept = kept_, decoded = std::exchange(known_, {})] {
        return loaded_from(m, *library, decoded, *kept);
      },
      [this, key](Loaded loaded) {
        if (loaded_ != key) return;
        const bool other = loaded.textures != textures_ || waiting_;
        if (waiting_) emit reading({});
        reading_ = waiting_ = false;
        shown_files_ = key.textures;
        pictures_ = std::move(loaded.pictures);
        shown_size_ = loaded.shown_size;
        whole_size_ = loaded.whole_size;
        textures_ = std::move(loaded.textures);
        summary_->setText(loaded.text);
        show_picture();
        if (other) emit textures_changed();
      });
}

void TextureView::show_picture() {
  const auto channel = static_cast<Channel>(channel_->currentData().toInt());
  const QImage& picture = pictures_[static_cast<std::size_t>(channel)];
  QRectF box;
  if (box_ && !picture.isNull() && !whole_size_.isEmpty())
    box = {double(box_->x) / whole_size_.width(), double(box_->y) / whole_size_.height(),
           double(box_->width) / whole_size_.width(), double(box_->height) / whole_size_.height()};
  sheet_->set_picture(picture, shown_size_, box);
  histogram_->show_picture(picture, channel == Channel::specular);
  show_texel();
}

}  // namespace etak::editor
