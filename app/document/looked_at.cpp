// SPDX-License-Identifier: Apache-2.0
#include "app/document/looked_at.h"

#include <QFileInfo>
#include <algorithm>
#include <atomic>

#include "app/document/dropped_pictures.h"
#include "app/document/pictures.h"
#include "app/viewport/background.h"
#include "app/viewport/qt_text.h"
#include "core/base/files/file.h"
#include "core/base/parallel.h"
#include "core/image/load.h"
#include "core/image/picture_bytes.h"
#include "core/maps/map_survey.h"

namespace etak::editor {
namespace {

// Texels of dropped pictures that are kept decoded until they are shown: 4 to 16 bytes each.
constexpr std::int64_t most_kept_texels = std::int64_t{64} << 20;

GreenAxis green_by(const FileToLookAt& file, const Looked& looked) {
  const auto* codes = looked.file.picture ? std::get_if<Image8>(&looked.file.picture->pixels) : nullptr;
  return codes != nullptr ? measured_green(survey_normals(*rows_of(*codes), {})).axis : green_of(file.path);
}

}  // namespace

QString picture_failure(const QString& path, PictureHeader* header) {
  const std::string file = path.toStdString(), name = QFileInfo(path).fileName().toStdString();
  QString out = failure_of(
      [&] {
        const std::string bytes = read_file(file, largest_picture_bytes);
        check_whole(bytes, picture_format(bytes, name), name);
        const auto png = PngReader::open(bytes, name);
        const PictureHeader said = png ? png->header() : picture_door().header(file);
        if (header != nullptr) *header = said;
      },
      QObject::tr("%1: not enough memory").arg(qt_text(name)));
  return out.replace(path, qt_text(name));
}

GreenAxis green_of(const std::string& path) {
  GreenAxis out = GreenAxis::unsaid;
  (void)failure_of(
      [&] { out = measured_green(survey_normals(*open_picture(path, picture_door()), {})).axis; });
  return out;
}

LookedAt looked_at(std::vector<FileToLookAt> files) {
  LookedAt out;
  std::erase_if(files, [&](const FileToLookAt& each) { return !out.try_emplace(each.path).second; });
  // Those that take longest come first.
  std::stable_partition(files.begin(), files.end(), [](const FileToLookAt& each) { return each.green; });
  std::atomic<std::int64_t> room = most_kept_texels;
  parallel_chunks(files.size(), thread_count(0), 1, [&](std::size_t i, std::size_t, unsigned) {
    Looked& at = out.at(files[i].path);
    // What is decoded is whole. What cannot be decoded is looked at again for what is wrong with it.
    (void)failure_of([&] {
      at.file.stamp = stamp_of(files[i].path);
      at.header = picture_header(files[i].path, picture_door());
      if (at.header.strips && (room -= std::int64_t{at.header.width} * at.header.height) >= 0)
        at.file.picture = std::make_shared<const Picture>(load_picture(files[i].path, picture_door()));
    });
    if (at.file.picture)
      at.header = at.file.picture->header;
    else
      at.failure = picture_failure(qt_text(files[i].path), &at.header);
    if (files[i].green && at.failure.isEmpty()) at.green = green_by(files[i], at);
  });
  return out;
}

}  // namespace etak::editor
