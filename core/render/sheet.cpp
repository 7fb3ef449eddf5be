// SPDX-License-Identifier: Apache-2.0
#include "core/render/sheet.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "core/base/text/text.h"
#include "core/color/delta_e.h"
#include "core/math/mat3.h"
#include "core/render/display.h"
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

// Colours of the map at 0, 1/3, 2/3 and all of its scale, linear.
constexpr std::array<Vec3, 4> map_colors{
    {{0, 0, 0}, {0.16, 0.01, 0.22}, {0.85, 0.16, 0.02}, {1, 0.95, 0.55}}};

Lab displayed_color(const Image& picture, std::size_t pixel, double exposure, Tone tone) {
  Vec3 linear = toned(&picture.values[static_cast<std::size_t>(picture.channels) * pixel], exposure, tone);
  for (double& each : linear) each = std::clamp(each, 0.0, 1.0);
  return to_lab(to_rgb(linear));
}

}  // namespace

Vec3 difference_color(double de) {
  const double place = std::clamp(de / largest_shown_de, 0.0, 1.0) * (map_colors.size() - 1);
  const auto first = std::min(static_cast<std::size_t>(place), map_colors.size() - 2);
  Vec3 out;
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = std::lerp(map_colors[first][c], map_colors[first + 1][c], place - static_cast<double>(first));
  return out;
}

DifferencePicture difference_picture(const Image& reference, const Image& picture, double exposure,
                                     Tone tone) {
  assert(reference.width == picture.width && reference.height == picture.height && picture.channels == 4);
  DifferencePicture out{Image(picture.width, picture.height, 3, paper)};
  std::size_t judged = 0;
  for (std::size_t i = 0; i < picture.pixel_count(); ++i) {
    if (picture.values[4 * i + 3] < 1) continue;
    const double de = delta_e2000(displayed_color(reference, i, exposure, tone),
                                  displayed_color(picture, i, exposure, tone));
    const Vec3 color = difference_color(de);
    for (std::size_t c = 0; c < 3; ++c) out.map.values[3 * i + c] = static_cast<float>(color[c]);
    out.mean_de += de;
    out.max_de = std::max(out.max_de, de);
    ++judged;
  }
  if (judged > 0) out.mean_de /= static_cast<double>(judged);
  return out;
}

Image beside(const Image& picture, const DifferencePicture& difference) {
  Image out(2 * picture.width, picture.height, 3, paper);
  paste(three_channels(picture), 0, 0, out);
  paste(difference.map, picture.width, 0, out);
  const int scale = std::max(1, picture.width / 64);
  write_text(out, picture.width + gap, picture.height - glyph_height * scale, scale,
             "DE " + fixed(difference.mean_de, 1), ink);
  return out;
}

Image laid_out(const Sheet& sheet) {
  int side_x = 0, side_y = 0;
  for (const Image& picture : sheet.pictures) {
    side_x = std::max(side_x, picture.width);
    side_y = std::max(side_y, picture.height);
  }
  std::size_t longest = 0;
  for (const std::string& row : sheet.rows) longest = std::max(longest, row.size());
  const int scale = std::max(1, side_x / 85);  // legible where a screen shows half of the pixels
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
