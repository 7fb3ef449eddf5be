// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/page_parts.h"

#include <algorithm>

#include "core/atlas/texels/place_texels.h"
#include "core/base/error.h"
#include "core/image/load.h"
#include "core/validate/files/scene_on_pages.h"

namespace etak {
namespace {

// The rows of a page that a region lies in; those before them are decoded, one by one, and forgotten.
Image8 rows_under(RowSource& page, const AtlasRect& rect, const std::string& label) {
  const int width = page.header().width;
  if (rect.x + rect.width > width || rect.y + rect.height > page.header().height)
    throw Error::at(label, "does not hold the region of " + rect.name + " that the layout names",
                    "a page of the layout's size");
  const std::size_t stride = 4 * static_cast<std::size_t>(width);
  const auto read = [&]<class Value>(Pixels<Value> out, auto rows) {
    for (int y = 0; y < rect.y; ++y) (page.*rows)(out.values.data(), stride, 1);
    (page.*rows)(out.values.data(), stride, rect.height);
    return out;
  };
  if (!page.header().floating) return read(Image8(width, rect.height, 4), &RowSource::read_rows);
  return codes_of({page.header(), read(Image(width, rect.height, 4), &RowSource::read_float_rows)}, true);
}

void put_region(const AtlasRect& rect, Image8& rows, Texture texture, Image8& to) {
  const Image8 part = texels_back(view(rows), {rect.x, 0, rect.width, rect.height}, rect.rotated);
  const auto shown = [](int at, int shown_side, int stored_side) {
    return static_cast<int>(std::int64_t{at} * stored_side / shown_side);
  };
  for (std::size_t p = 0; p < channel_parts.size(); ++p) {
    const std::size_t first = channel_parts[p].first, begin = first_channel(texture);
    if (!rect.holds[p] || first < begin || first >= begin + 4) continue;
    for (int y = 0; y < rect.crop.height; ++y)
      for (int x = 0; x < rect.crop.width; ++x)
        std::copy_n(
            part.at(shown(x, rect.crop.width, part.width), shown(y, rect.crop.height, part.height)).data() +
                (first - begin),
            channel_parts[p].size, to.at(rect.crop.x + x, rect.crop.y + y).data() + (first - begin));
  }
}

FileRole role_of(Texture texture) {
  return texture == Texture::diffuse_alpha ? FileRole::diffuse_alpha : FileRole::specular_gloss;
}

}  // namespace

Pictures put_together(const CheckTarget& target, const PictureOpener& open) {
  const std::vector<AtlasRect>& parts = target.manifest.parts;
  const int width = parts.front().source_width, height = parts.front().source_height;
  Pictures out{Image8(width, height, 4), Image8(width, height, 4), {}};
  for (const AtlasRect& rect : parts) {
    if (rect.source_width != width || rect.source_height != height || rect.crop.x + rect.crop.width > width ||
        rect.crop.y + rect.crop.height > height)
      throw Error::at(target.label, "its regions are of different pictures", "regions of one size");
    for (const Texture texture : both_textures) {
      const std::size_t part = texture == Texture::diffuse_alpha ? 0 : 2;
      const auto file = std::ranges::find(target.files, role_of(texture), &TargetFile::role);
      if ((!rect.holds[part] && !rect.holds[part + 1]) || file == target.files.end()) continue;
      Image8 rows = rows_under(*open(*file), rect, file->label);
      put_region(rect, rows, texture, texture == Texture::diffuse_alpha ? out.a : out.b);
    }
  }
  return out;
}

void put_parts_on_page(const CheckTarget& target, const Evidence& evidence, CheckedFile& file) {
  for (Finding& finding : file.findings) {
    if (!finding.box) continue;
    const auto of = std::ranges::find(target.files, finding.file, &TargetFile::label);
    const bool diffuse = of != target.files.end() && of->role == FileRole::diffuse_alpha;
    std::vector<AtlasRect> rects;
    for (const AtlasRect& rect : target.manifest.parts)
      if (rect.holds[diffuse ? 0 : 2]) rects.push_back(rect);
    put_on_pages(finding, evidence, rects, target.manifest.parts.front().name);
  }
}

}  // namespace etak
