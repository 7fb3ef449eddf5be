// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/color/rgb.h"

namespace etak {

/// A picture as numbers: rows from the top, pixels from the left, the channels of a pixel side by side.
///   channels   1: grey; 2: grey and opacity; 3: red, green, blue; 4: these and opacity or another quantity,
///              such as gloss
/// Colour is never multiplied by the last channel, since a fourth channel need not be an opacity.
template <class Value>
struct Pixels {
  int width = 0, height = 0, channels = 0;
  std::vector<Value> values;

  Pixels() = default;
  Pixels(int width_, int height_, int channels_, Value fill = {})
      : width(width_),
        height(height_),
        channels(channels_),
        values(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) *
                   static_cast<std::size_t>(channels_),
               fill) {}

  std::size_t pixel_count() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }

  /// The channels of the pixel in column x of row y.
  std::span<Value> at(int x, int y) {
    return {values.data() + offset(x, y), static_cast<std::size_t>(channels)};
  }
  std::span<const Value> at(int x, int y) const {
    return {values.data() + offset(x, y), static_cast<std::size_t>(channels)};
  }

  friend bool operator==(const Pixels&, const Pixels&) = default;

 private:
  std::size_t offset(int x, int y) const {
    assert(x >= 0 && x < width && y >= 0 && y < height);
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
           static_cast<std::size_t>(channels);
  }
};

/// Values in linear light, or quantities without a curve, of any range.
using Image = Pixels<float>;
/// Codes 0..255 as they are in a file. The picture does not say which transfer curve they are encoded with.
using Image8 = Pixels<std::uint8_t>;
/// Codes 0..65535, likewise.
using Image16 = Pixels<std::uint16_t>;

/// The largest side, in pixels, of pictures that etak makes or reads. A square picture of this side with four
/// float channels takes 4 GiB.
inline constexpr int max_image_side = 16384;

/// Copies `part` into `whole`, with the top left corner of `part` at column x and row y. Pixels that would
/// lie outside of `whole` are left out. Both have the same number of channels.
template <class Value>
void paste(const Pixels<Value>& part, int x, int y, Pixels<Value>& whole) {
  assert(part.channels == whole.channels);
  const int first = std::max(0, -x), last = std::min(part.width, whole.width - x);
  if (first >= last) return;
  for (int row = std::max(0, -y); row < std::min(part.height, whole.height - y); ++row)
    std::copy_n(part.at(first, row).data(), static_cast<std::size_t>((last - first) * part.channels),
                whole.at(x + first, y + row).data());
}

/// The picture in a smaller size: each new pixel is the mean over the area that it covers. Values are
/// averaged as they are, so they must be linear light.
///   width, height   1 up to the sides of `image`
Image shrunk(const Image& image, int width, int height);

/// The 8-bit code of a value v: floor(255 v + 1/2) after clamping v to [0, 1]. NaN gives 0.
std::uint8_t to_code(float value);

/// The 8-bit code nearest to a 16-bit code.
constexpr std::uint8_t rounded_code(std::uint16_t code) {
  return static_cast<std::uint8_t>((code * 255u + 32767u) / 65535u);
}

}  // namespace etak
