// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>
#include <vector>

#include "core/rects/rects.h"

/// What the tests of packing share.
namespace etak::test {

using Sizes = std::vector<RectSize>;

inline int below(std::mt19937& random, int limit) {
  return static_cast<int>(random() % static_cast<unsigned>(limit));
}

/// Sets of several kinds: even sides, powers of two, thin ones, a large one among small ones, equal ones.
inline Sizes random_sizes(std::mt19937& random, int n) {
  Sizes out;
  const int kind = below(random, 5), hi = 2 + below(random, 60);
  for (int i = 0; i < n; ++i) {
    const int a = 1 + below(random, hi), b = 1 + below(random, hi);
    switch (kind) {
      case 0:
        out.push_back({a, b});
        break;
      case 1:
        out.push_back({1 << below(random, 6), 1 << below(random, 6)});
        break;
      case 2:
        out.push_back(i % 2 == 0 ? RectSize{a, 1 + b / 16} : RectSize{1 + b / 16, a});
        break;
      case 3:
        out.push_back(i == 0 ? RectSize{3 * hi, 2 * hi} : RectSize{1 + a / 4, 1 + b / 4});
        break;
      default:
        out.push_back({hi, 1 + hi / 2});
        break;
    }
  }
  return out;
}

/// Paints every page texel by texel: slower than layout_fault and written without it.
inline bool painted_once(const Sizes& sizes, const RectLayout& layout) {
  if (layout.places.size() != sizes.size()) return false;
  std::vector<std::vector<char>> pages;
  for (const RectSize& page : layout.pages)
    pages.emplace_back(static_cast<std::size_t>(page.width) * static_cast<std::size_t>(page.height), 0);
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const RectPlace& place = layout.places[i];
    if (place.page < 0 || static_cast<std::size_t>(place.page) >= pages.size()) return false;
    const RectSize page = layout.pages[static_cast<std::size_t>(place.page)];
    const int w = place.rotated ? sizes[i].height : sizes[i].width;
    const int h = place.rotated ? sizes[i].width : sizes[i].height;
    for (int y = place.y; y < place.y + h; ++y)
      for (int x = place.x; x < place.x + w; ++x) {
        if (x < 0 || y < 0 || x >= page.width || y >= page.height) return false;
        char& texel =
            pages[static_cast<std::size_t>(place.page)][static_cast<std::size_t>(y * page.width + x)];
        if (texel != 0) return false;
        texel = 1;
      }
  }
  return true;
}

inline RectOptions options_for(PageForm form, int side, bool rotate, int effort = 12) {
  RectOptions out;
  out.form = form;
  out.side = side;
  out.rotate = rotate;
  out.effort = effort;
  return out;
}

inline constexpr PageForm forms[] = {PageForm::square, PageForm::power_of_two, PageForm::free,
                                     PageForm::strip,  PageForm::pages,        PageForm::mixed};

}  // namespace etak::test
