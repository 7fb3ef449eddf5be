// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/sources/pictures.h"

#include <array>

#include "core/atlas/sources/metallic.h"
#include "core/atlas/sources/strip_reader.h"
#include "core/base/error.h"

namespace etak {

PairPlanes planes_of(const PackInput& m) {
  if (m.metallic) return *m.metallic;
  return {{m.color[0], m.grey[0], m.color[1], m.grey[1]}, false, m.width, m.height};
}

PairRows::PairRows(const PairPlanes& planes, int first) : planes_(&planes) {
  rows_.reserve(files_.size());
  for (std::size_t i = 0; i < files_.size(); ++i) {
    const PlaneRows& rows = rows_.emplace_back(planes.planes[i], files_[i], first);
    if (rows.width() != 0)
      check_size(rows.source(), rows.width(), rows.height(), planes.width, planes.height);
  }
}

void PairRows::read(std::uint8_t* diffuse_alpha, std::uint8_t* specular_gloss) {
  std::array<const std::uint8_t*, 4> at{};
  for (std::size_t i = 0; i < at.size(); ++i) at[i] = rows_[i].width() != 0 ? rows_[i].read(1) : nullptr;
  const auto texels = static_cast<std::size_t>(planes_->width);
  interleave(diffuse_alpha, texels, at[0], rows_[0], at[1], rows_[1]);
  interleave(specular_gloss, texels, at[2], rows_[2], at[3], rows_[3]);
  if (planes_->metallic) convert_metallic(diffuse_alpha, specular_gloss, texels);
}

Image8 normals_of(const PackInput& m, const PixelBox& box) {
  if (m.load_normals) return part_of(m.load_normals(), box);
  FileBytes memory;
  PlaneRows rows(m.normal, memory);
  if (rows.width() != m.width || rows.height() != m.height)
    throw Error::at(m.normal.path,
                    "is " + std::to_string(rows.width()) + " x " + std::to_string(rows.height()),
                    std::to_string(m.width) + " x " + std::to_string(m.height) + ", as " + m.name + " is");
  Image8 out(box.width, box.height, 3);
  const auto pick = rows.pick();
  const auto step = static_cast<std::size_t>(rows.step());
  for (int y = 0; y < box.y + box.height; ++y) {
    const std::uint8_t* row = rows.read(1);
    if (y < box.y) continue;
    for (int x = 0; x < box.width; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        out.at(x, y - box.y)[c] =
            row[static_cast<std::size_t>(box.x + x) * step + static_cast<std::size_t>(pick[c])];
  }
  return out;
}

MaterialPair load_pair(const PackInput& m, std::vector<std::string>& remarks) {
  if (m.convert) return m.convert(remarks);
  MaterialPair out{Image8(m.width, m.height, 4), Image8(m.width, m.height, 4)};
  std::array<FileBytes, 2> files;
  for (const Texture texture : both_textures)
    StripReader(m, texture, files).read(view(out.of(texture)), [](int, int) {});
  return out;
}

}  // namespace etak
