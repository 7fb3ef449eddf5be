// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "core/judge/target.h"

namespace etak {

/// A tile of an atlas and a box of it, in texels or in blocks of them.
struct TileBox {
  const CheckTile* tile = nullptr;
  PixelBox box;
};

/// By the first row of their boxes, as met_tile() wants them.
inline void sort_by_row(std::vector<TileBox>& boxes) {
  std::ranges::stable_sort(boxes, {}, [](const TileBox& each) { return each.box.y; });
}

/// The first tile behind `at` whose box meets that of `at` on the same page, of those for which `counts` is true; null:
/// none.
template <class Counts>
const CheckTile* met_tile(const std::vector<TileBox>& by_row, std::size_t at, Counts counts) {
  const PixelBox& a = by_row[at].box;
  for (std::size_t i = at + 1; i < by_row.size() && by_row[i].box.y < a.y + a.height; ++i) {
    const PixelBox& b = by_row[i].box;
    if (by_row[at].tile->page == by_row[i].tile->page && b.x < a.x + a.width && a.x < b.x + b.width &&
        b.height > 0 && a.height > 0 && counts(*by_row[i].tile))
      return by_row[i].tile;
  }
  return nullptr;
}

}  // namespace etak
