// SPDX-License-Identifier: Apache-2.0
#include "core/pack/scene/kept_pictures.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/base/bytes/hex.h"
#include "core/image/files/png.h"

namespace etak {
namespace {

using Texel = std::array<std::uint8_t, 4>;

// The values of a texel in the channels that its picture has: of grey the first stands for three.
std::vector<std::uint8_t> in_channels(const Texel& rgba, int channels) {
  if (channels == 2) return {rgba[0], rgba[3]};
  return {rgba.begin(), rgba.begin() + channels};
}

std::string name_of(const std::vector<std::uint8_t>& values) {
  std::string out = "texel_";
  for (const std::uint8_t value : values) append_hex(out, static_cast<char>(value));
  return out + ".png";
}

}  // namespace

std::optional<OneTexel> one_texel_of(RowSource& rows) {
  const PictureHeader& from = rows.header();
  if (from.width * from.height == 1) return std::nullopt;
  std::vector<std::uint8_t> row(4 * static_cast<std::size_t>(from.width));
  Texel first{};
  for (int y = 0; y < from.height; ++y) {
    rows.read_rows(row.data(), row.size(), 1);
    if (y == 0) std::copy_n(row.begin(), 4, first.begin());
    for (std::size_t i = 0; i < row.size(); i += 4)
      if (!std::equal(first.begin(), first.end(), row.data() + i)) return std::nullopt;
  }
  const std::vector<std::uint8_t> values = in_channels(first, from.channels);
  PngOptions png;
  png.level = PngLevel::smallest;
  OneTexel out;
  out.header = {1, 1, from.channels};
  out.rgba = first;
  out.file = png_bytes({out.header, values.data(), values.size()}, png);
  out.name = name_of(values);
  return out;
}

}  // namespace etak
