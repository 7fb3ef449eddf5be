// SPDX-License-Identifier: Apache-2.0
#include "app/document/thumbnails.h"

#include <QCryptographicHash>
#include <QDir>
#include <QPainter>

#include "app/document/files.h"
#include "app/viewport/background.h"
#include "app/viewport/qt_picture.h"
#include "core/base/error.h"
#include "core/brdf/models.h"
#include "core/render/cpu_renderer.h"

namespace etak::editor {
namespace {

// Part of the names of the files. It changes when the pictures change, so that older files are not used.
constexpr const char* make = "etak-thumbnail-5";
constexpr int most_pictures = 4000;

QImage thumbnail(const Thumbnails::Subject& subject, Shape shape, int side, const QString& folder) {
  try {
    QString file;
    if (!folder.isEmpty()) {
      QCryptographicHash hash(QCryptographicHash::Sha1);
      hash.addData(QByteArray::fromStdString(make + subject.text()));
      file = folder + QStringLiteral("/%1-%2%3.png")
                          .arg(QString::fromLatin1(hash.result().toHex()))
                          .arg(side)
                          .arg(shape == Shape::quad ? "f" : QString());
      if (QImage kept(file); !kept.isNull() && kept.width() == side) return kept;
    }
    const QImage out = ball_picture(subject.surface(), shape, side);
    // A cache that cannot be written is not reported, because it only saves time.
    if (!file.isEmpty() && QDir().mkpath(folder)) (void)save_png(out, file);
    return out;
  } catch (const Error&) {
    QImage none(side, side, QImage::Format_RGB888);
    none.fill(Qt::darkGray);
    return none;
  }
}

QString picture_key(const QString& key, Shape shape) {
  return key + (shape == Shape::quad ? "|flat" : "|sphere");
}

}  // namespace

QImage ball_picture(const SurfaceValues& surface, Shape shape, int side,
                    std::shared_ptr<const SurfaceTextures> textures) {
  Scene scene;
  scene.shape = shape;
  scene.surface = surface;
  scene.textures = std::move(textures);
  scene.width = scene.height = side;
  scene.lights = studio_lights();
  const auto environment = studio_environment(scene.lights.environment, scene.lights.environment_scale, 1);
  scene.background = {0.05, 0.05, 0.05};
  scene.specular = find_model(default_specular);
  scene.diffuse = find_model(default_diffuse);
  scene.specular_values = model_values(*scene.specular, surface, {});
  scene.diffuse_values = model_values(*scene.diffuse, surface, {});
  Image8 codes;
  render_cpu_codes(scene, environment.get(), 1, codes);
  const QImage whole = qt_image(codes);
  if (shape != Shape::sphere) return whole;
  // The ball alone, which lies on the list in its own colour.
  QImage out(whole.size(), QImage::Format_ARGB32_Premultiplied);
  out.fill(Qt::transparent);
  QPainter painter(&out);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QBrush(whole));
  painter.drawEllipse(QPointF(side / 2.0, side / 2.0), side / 2.2, side / 2.2);
  return out;
}

Thumbnails::Thumbnails(const QString& folder, QObject* parent)
    : QObject(parent),
      folder_(folder),
      pictures_(most_pictures),
      pool_(std::max(1, QThread::idealThreadCount() - 1)) {}

QPixmap Thumbnails::get(const QString& key, Shape shape, int side, double ratio,
                        const std::function<Subject()>& subject) {
  const QString whole = picture_key(key, shape);
  if (const QPixmap* known = pictures_.object(whole)) return *known;
  if (waiting_.contains(whole)) return {};
  waiting_.insert(whole);
  const int pixels = static_cast<int>(side * ratio);
  in_background(
      pool_, this,
      [subject = subject(), shape, pixels, folder = folder_] {
        let_others_go_first();
        return thumbnail(subject, shape, pixels, folder);
      },
      [this, whole, key, ratio](const QImage& image) {
        waiting_.remove(whole);
        auto* pixmap = new QPixmap(QPixmap::fromImage(image));
        pixmap->setDevicePixelRatio(ratio);
        pictures_.insert(whole, pixmap);
        emit ready(key);
      });
  return {};
}

}  // namespace etak::editor
