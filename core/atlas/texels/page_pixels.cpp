// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/texels/page_pixels.h"

#include <algorithm>
#include <cstring>

namespace etak {

void PagePixels::prepare(Plane& plane, std::size_t bytes, bool covered) {
  if (plane.memory.size() < bytes) {
    plane.memory = PageMemory();
    plane.memory = PageMemory(bytes);
  } else if (plane.used && !covered) {
    std::memset(plane.memory.data(), 0, bytes);
  }
  plane.used = true;
}

int PagePixels::rows(int level) const {
  const int end = slab_.bottom == page_.height ? std::max(1, page_.height >> level) : slab_.bottom >> level;
  return end - first_row(level);
}

void PagePixels::start(const PlannedPage& page, int levels) {
  start(page, levels, {0, page.height, levels, false}, *this);
}

void PagePixels::start(const PlannedPage& page, int levels, const Slab& slab, PagePixels& upper) {
  page_ = page;
  levels_ = levels;
  slab_ = slab;
  upper_ = &upper == this ? nullptr : &upper;
  for (const Texture texture : both_textures) {
    auto& planes = planes_[index_of(texture)];
    planes.resize(static_cast<std::size_t>(levels));
    if (!page.has[index_of(texture)]) continue;
    for (int l = 0; l < levels; ++l) {
      const std::size_t row = 4 * static_cast<std::size_t>(std::max(1, page.width >> l));
      Plane& plane = planes[static_cast<std::size_t>(l)];
      if (l < slab.cut_levels)
        prepare(plane, row * static_cast<std::size_t>(rows(l)), slab.covered);
      else if (slab.top == 0 && upper_ == nullptr)
        prepare(plane, row * static_cast<std::size_t>(std::max(1, page.height >> l)), false);
    }
  }
}

void PagePixels::show_whole_levels() {
  slab_.top = 0;
  slab_.bottom = page_.height;
}

void PagePixels::release() {
  for (auto& planes : planes_) planes.clear();
}

PixelsView8 PagePixels::view(Texture texture, int level) const {
  const int width = std::max(1, page_.width >> level);
  const std::size_t stride = 4 * static_cast<std::size_t>(width);
  const bool whole = level >= slab_.cut_levels;
  const PagePixels& holder = whole && upper_ != nullptr ? *upper_ : *this;
  std::uint8_t* data = nullptr;  // the memory of a texture that this page does not have may be there still
  if (page_.has[index_of(texture)])
    data = holder.planes_[index_of(texture)][static_cast<std::size_t>(level)].memory.data();
  if (data != nullptr && whole) data += stride * static_cast<std::size_t>(first_row(level));
  return {data, stride, width, rows(level), 4};
}

}  // namespace etak
