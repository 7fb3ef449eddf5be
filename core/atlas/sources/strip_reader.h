// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/atlas/sources/plane.h"
#include "core/atlas/sources/sources.h"
#include "core/atlas/texels/page_memory.h"
#include "core/atlas/texels/page_pixels.h"

namespace etak {

/// Reads the two planes of a texture in strips and interleaves them.
class StripReader {
 public:
  /// Opens the planes; Error where a file is no longer as large as when it was looked at.
  StripReader(const PackInput& m, Texture texture, std::array<FileBytes, 2>& files);

  /// The next rows of the picture, into all of `out`; act(first row, rows) for each strip.
  template <class Act>
  void read(const PixelsView8& out, Act act) {
    const int rows = static_cast<int>(std::max<std::size_t>(1, strip_bytes / (8 * width_)));
    for (int y = 0; y < out.height; y += rows) {
      const int count = std::min(rows, out.height - y);
      const std::uint8_t* c = color_.width() != 0 ? color_.read(count) : nullptr;
      const std::uint8_t* g = grey_.width() != 0 ? grey_.read(count) : nullptr;
      const std::size_t color_stride = c == nullptr ? 0 : width_ * static_cast<std::size_t>(color_.step());
      const std::size_t grey_stride = g == nullptr ? 0 : width_ * static_cast<std::size_t>(grey_.step());
      for (int i = 0; i < count; ++i)
        interleave(out.row(y + i), width_, c == nullptr ? c : c + static_cast<std::size_t>(i) * color_stride,
                   color_, g == nullptr ? g : g + static_cast<std::size_t>(i) * grey_stride, grey_);
      act(y, count);
    }
  }

  std::size_t clamped() const { return color_.clamped() + grey_.clamped(); }

 private:
  // Rows are decoded and interleaved in strips that stay in the second-level cache.
  static constexpr std::size_t strip_bytes = std::size_t{192} << 10;

  std::size_t width_;
  PlaneRows color_, grey_;
};

}  // namespace etak
