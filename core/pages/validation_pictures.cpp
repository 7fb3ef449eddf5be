// SPDX-License-Identifier: Apache-2.0
#include "core/pages/validation_pictures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/color/luminance.h"
#include "core/color/srgb.h"
#include "core/judge/pixels/code_tables.h"

namespace etak {
namespace {

// The texels [begin, end) that pixel `at` of `count` covers along a side of `size` texels: at least one.
struct Span {
  int begin, end;
};
Span covered(int at, int count, int size) {
  const auto edge = [&](int i) { return static_cast<int>(std::int64_t{i} * size / count); };
  return {edge(at), std::max(edge(at + 1), edge(at) + 1)};
}

}  // namespace

double decoded(double code, TextureTransfer transfer) {
  return decode_of(transfer, code / 255);
}

double encoded(double linear, TextureTransfer transfer) {
  return 255 * encode_of(transfer, linear);
}

Image8 thumbnail(const Image8& picture, int most) {
  const int longest = std::max({picture.width, picture.height, 1});
  const auto scaled = [&](int side) {
    return longest <= most ? side : std::max(1, static_cast<int>(std::int64_t{side} * most / longest));
  };
  Image8 out(scaled(picture.width), scaled(picture.height), 3);
  std::array<float, 256> light;
  for (std::size_t code = 0; code < 256; ++code)
    light[code] = static_cast<float>(decoded(static_cast<double>(code), TextureTransfer::srgb));
  for (int y = 0; y < out.height; ++y) {
    const Span rows = covered(y, out.height, picture.height);
    for (int x = 0; x < out.width; ++x) {
      const Span columns = covered(x, out.width, picture.width);
      std::array<double, 3> sum{};
      for (int row = rows.begin; row < rows.end; ++row)
        for (int column = columns.begin; column < columns.end; ++column) {
          const auto texel = picture.at(column, row);
          for (std::size_t c = 0; c < 3; ++c) sum[c] += light[texel[picture.channels >= 3 ? c : 0]];
        }
      const double count = double(rows.end - rows.begin) * (columns.end - columns.begin);
      for (std::size_t c = 0; c < 3; ++c)
        out.at(x, y)[c] = to_code(static_cast<float>(srgb_encode(sum[c] / count)));
    }
  }
  return out;
}

Image8 heat_map(const Image8& marks, int width, int height) {
  Image8 out(width, height, 4);
  for (int y = 0; y < height; ++y) {
    const Span rows = covered(y, height, marks.height);
    for (int x = 0; x < width; ++x) {
      const Span columns = covered(x, width, marks.width);
      std::array<int, 3> count{};
      for (int row = rows.begin; row < rows.end; ++row)
        for (int column = columns.begin; column < columns.end; ++column)
          ++count[std::min<std::uint8_t>(marks.at(column, row)[0], 2)];
      const double all = count[0] + count[1] + count[2];
      const auto texel = out.at(x, y);
      // The opacity begins at 35 %, so that a single texel of a large picture can still be seen.
      const auto opacity = [&](int part) {
        return to_code(static_cast<float>(0.35 + 0.6 * std::sqrt(part / all)));
      };
      constexpr std::array<std::uint8_t, 3> red{230, 20, 20}, yellow{255, 214, 0};
      if (count[2] == 0 && count[1] == 0) continue;
      std::ranges::copy(count[2] > 0 ? red : yellow, texel.begin());
      texel[3] = opacity(count[2] > 0 ? count[2] : count[1]);
    }
  }
  return out;
}

std::array<std::size_t, 256> f0_histogram(const Image8& specular, const Image8& diffuse,
                                          TextureTransfer transfer) {
  std::array<std::size_t, 256> out{};
  std::array<double, 256> light;
  for (std::size_t code = 0; code < 256; ++code) light[code] = decoded(static_cast<double>(code), transfer);
  // A luminance from edge[k] to edge[k + 1] is counted at code k.
  std::array<double, 256> edge;
  for (std::size_t code = 0; code < 256; ++code)
    edge[code] = decoded(static_cast<double>(code) - 0.5, transfer);
  edge[0] = 0;
  const bool masked =
      diffuse.channels == 4 && diffuse.width == specular.width && diffuse.height == specular.height;
  const auto channels = static_cast<std::size_t>(specular.channels);
  for (std::size_t i = 0; i < specular.pixel_count(); ++i) {
    if (masked && diffuse.values[4 * i + 3] == 0) continue;
    const std::uint8_t* texel = specular.values.data() + i * channels;
    const std::uint8_t r = texel[0], g = channels >= 3 ? texel[1] : r, b = channels >= 3 ? texel[2] : r;
    if (r == g && g == b) {
      ++out[r];
      continue;
    }
    const double y = luminance_of(light[r], light[g], light[b]);
    const auto above = std::upper_bound(edge.begin(), edge.end(), y);
    ++out[static_cast<std::size_t>(above - edge.begin()) - 1];
  }
  return out;
}

}  // namespace etak
