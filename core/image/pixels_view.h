// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>

#include "core/image/image.h"

namespace etak {

/// A rectangle of pixels: columns x .. x + width - 1 of rows y .. y + height - 1.
struct PixelBox {
  int x = 0, y = 0, width = 0, height = 0;
  std::uint64_t area() const {
    return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  }
  friend bool operator==(const PixelBox&, const PixelBox&) = default;
};

/// The smallest box that holds both.
inline PixelBox around(const PixelBox& a, const PixelBox& b) {
  const int x = std::min(a.x, b.x), y = std::min(a.y, b.y);
  return {x, y, std::max(a.x + a.width, b.x + b.width) - x, std::max(a.y + a.height, b.y + b.height) - y};
}

/// What two boxes have in common; width or height 0 where that is nothing.
inline PixelBox common_part(const PixelBox& a, const PixelBox& b) {
  const int x = std::max(a.x, b.x), y = std::max(a.y, b.y);
  return {x, y, std::max(0, std::min(a.x + a.width, b.x + b.width) - x),
          std::max(0, std::min(a.y + a.height, b.y + b.height) - y)};
}

/// The box with `margin` pixels more on every side.
inline PixelBox grown(const PixelBox& box, int margin) {
  return {box.x - margin, box.y - margin, box.width + 2 * margin, box.height + 2 * margin};
}

/// A view of pixels whose memory belongs to somebody else: a whole picture, or a box of one. Rows are
/// `stride` values apart.
template <class Value>
struct PixelsViewOf {
  Value* data = nullptr;
  std::size_t stride = 0;
  int width = 0, height = 0, channels = 0;

  Value* row(int y) const {
    assert(y >= 0 && y < height);
    return data + static_cast<std::size_t>(y) * stride;
  }
  Value* at(int x, int y) const {
    assert(x >= 0 && x < width);
    return row(y) + static_cast<std::size_t>(x) * static_cast<std::size_t>(channels);
  }
  /// A view of the pixels in `box`, which must lie inside this view.
  PixelsViewOf part(const PixelBox& box) const {
    assert(box.x >= 0 && box.y >= 0 && box.width >= 1 && box.height >= 1);
    assert(box.x + box.width <= width && box.y + box.height <= height);
    return {at(box.x, box.y), stride, box.width, box.height, channels};
  }
  operator PixelsViewOf<const Value>() const { return {data, stride, width, height, channels}; }
};
using PixelsView8 = PixelsViewOf<std::uint8_t>;
using ConstPixelsView8 = PixelsViewOf<const std::uint8_t>;

template <class Value>
PixelsViewOf<Value> view(Pixels<Value>& image) {
  const auto stride = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
  return {image.values.data(), stride, image.width, image.height, image.channels};
}
template <class Value>
PixelsViewOf<const Value> view(const Pixels<Value>& image) {
  const auto stride = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
  return {image.values.data(), stride, image.width, image.height, image.channels};
}

}  // namespace etak
