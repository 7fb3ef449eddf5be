// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/image/pixels_view.h"

namespace etak {

/// Adds to `group`, indices of texels in a picture `width` wide, all those of `box` that are 8-connected to them by
/// texels that `wanted` accepts, and marks these in `seen`, which has an entry for each texel of the picture.
template <class Wanted>
void flood(const PixelBox& box, int width, std::vector<char>& seen, std::vector<std::size_t>& group,
           const Wanted& wanted) {
  for (std::size_t at = 0; at < group.size(); ++at) {
    const int x0 = static_cast<int>(group[at] % static_cast<std::size_t>(width)),
              y0 = static_cast<int>(group[at] / static_cast<std::size_t>(width));
    for (int y = std::max(box.y, y0 - 1); y <= std::min(box.y + box.height - 1, y0 + 1); ++y)
      for (int x = std::max(box.x, x0 - 1); x <= std::min(box.x + box.width - 1, x0 + 1); ++x) {
        const std::size_t near =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
        if (seen[near] != 0 || !wanted(near)) continue;
        seen[near] = 1;
        group.push_back(near);
      }
  }
}

}  // namespace etak
