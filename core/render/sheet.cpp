// SPDX-License-Identifier: Apache-2.0
#include "core/render/sheet.h"

#include <algorithm>

#include "core/render/font.h"

namespace etak {
namespace {

constexpr float paper = 0.02f, ink = 0.8f;
constexpr int gap = 4;

Image three_channels(const Image& picture) {
  if (picture.channels == 3) return picture;
  Image out(picture.width, picture.height, 3);
  for (std::size_t i = 0; i < picture.pixel_count(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      out.values[3 * i + c] = picture.values[static_cast<std::size_t>(picture.channels) * i + c];
  return out;
}

}  // namespace

Image laid_out(const Sheet& sheet) {
  int side_x = 0, side_y = 0;
  for (const Image& picture : sheet.pictures) {
    side_x = std::max(side_x, picture.width);
    side_y = std::max(side_y, picture.height);
  }
  std::size_t longest = 0;
  for (const std::string& row : sheet.rows) longest = std::max(longest, row.size());
  const int scale = side_x >= 256 ? 2 : 1;
  const int left = static_cast<int>(longest) * glyph_width * scale + 2 * gap;
  const int top = glyph_height * scale + 2 * gap;
  const auto columns = static_cast<int>(sheet.columns.size()), rows = static_cast<int>(sheet.rows.size());
  Image out(left + columns * (side_x + gap), top + rows * (side_y + gap), 3, paper);
  for (int i = 0; i < columns; ++i) {
    const std::string& label = sheet.columns[static_cast<std::size_t>(i)];
    const int width = static_cast<int>(label.size()) * glyph_width * scale;
    write_text(out, left + i * (side_x + gap) + (side_x - width) / 2, gap, scale, label, ink);
  }
  for (int j = 0; j < rows; ++j) {
    const int y = top + j * (side_y + gap);
    write_text(out, gap, y + (side_y - glyph_height * scale) / 2, scale,
               sheet.rows[static_cast<std::size_t>(j)], ink);
    for (int i = 0; i < columns; ++i) {
      const auto index = static_cast<std::size_t>(j) * sheet.columns.size() + static_cast<std::size_t>(i);
      if (index < sheet.pictures.size() && sheet.pictures[index].width > 0)
        paste(three_channels(sheet.pictures[index]), left + i * (side_x + gap), y, out);
    }
  }
  return out;
}

}  // namespace etak
