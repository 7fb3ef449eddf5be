// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>

#include "core/image/image.h"

namespace etak {

/// Columns x .. x + width - 1 of rows y .. y + height - 1.
struct PixelBox {
  int x = 0, y = 0, width = 0, height = 0;
  friend bool operator==(const PixelBox&, const PixelBox&) = default;
};

/// Codes that somebody else holds: a whole picture or a box of a page, rows `stride` bytes apart.
template <class Byte>
struct PixelsViewOf {
  Byte* data = nullptr;
  std::size_t stride = 0;
  int width = 0, height = 0, channels = 0;

  Byte* row(int y) const {
    assert(y >= 0 && y < height);
    return data + static_cast<std::size_t>(y) * stride;
  }
  Byte* at(int x, int y) const {
    assert(x >= 0 && x < width);
    return row(y) + static_cast<std::size_t>(x) * static_cast<std::size_t>(channels);
  }
  /// The box must lie inside.
  PixelsViewOf part(const PixelBox& box) const {
    assert(box.x >= 0 && box.y >= 0 && box.width >= 1 && box.height >= 1);
    assert(box.x + box.width <= width && box.y + box.height <= height);
    return {at(box.x, box.y), stride, box.width, box.height, channels};
  }
  operator PixelsViewOf<const Byte>() const { return {data, stride, width, height, channels}; }
};
using PixelsView8 = PixelsViewOf<std::uint8_t>;
using ConstPixelsView8 = PixelsViewOf<const std::uint8_t>;

inline PixelsView8 view(Image8& image) {
  const auto stride = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
  return {image.values.data(), stride, image.width, image.height, image.channels};
}
inline ConstPixelsView8 view(const Image8& image) {
  const auto stride = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
  return {image.values.data(), stride, image.width, image.height, image.channels};
}

}  // namespace etak
