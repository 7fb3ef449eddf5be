// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <tuple>

#include "core/rects/rects.h"

namespace etak {

std::size_t RectLayout::page_texels() const {
  std::size_t out = 0;
  for (const RectSize& page : pages)
    out += static_cast<std::size_t>(page.width) * static_cast<std::size_t>(page.height);
  return out;
}

// A line sweeps over x through each page and carries the intervals of y that are covered there.
std::optional<std::string> layout_fault(std::span<const RectSize> sizes, const RectLayout& layout) {
  if (layout.places.size() != sizes.size())
    return std::to_string(layout.places.size()) + " places for " + std::to_string(sizes.size()) +
           " rectangles";
  struct Edge {
    int page, x;
    bool opens;
    std::size_t rect;
  };
  std::vector<Edge> edges;
  const auto width = [&](std::size_t i) {
    return layout.places[i].rotated ? sizes[i].height : sizes[i].width;
  };
  const auto height = [&](std::size_t i) {
    return layout.places[i].rotated ? sizes[i].width : sizes[i].height;
  };
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const RectPlace& place = layout.places[i];
    const std::string name = "rectangle " + std::to_string(i + 1);
    if (place.page < 0 || static_cast<std::size_t>(place.page) >= layout.pages.size())
      return name + " is on page " + std::to_string(place.page) + " of " +
             std::to_string(layout.pages.size());
    const RectSize& page = layout.pages[static_cast<std::size_t>(place.page)];
    if (place.x < 0 || place.y < 0 || place.x > page.width - width(i) || place.y > page.height - height(i))
      return name + " lies outside of its page";
    edges.push_back({place.page, place.x, true, i});
    edges.push_back({place.page, place.x + width(i), false, i});
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::tie(a.page, a.x, a.opens, a.rect) < std::tie(b.page, b.x, b.opens, b.rect);
  });
  std::map<int, std::size_t> open;  // by lower side
  for (const Edge& edge : edges) {
    const int low = layout.places[edge.rect].y;
    if (!edge.opens) {
      open.erase(low);
      continue;
    }
    const auto above = open.lower_bound(low);
    std::optional<std::size_t> hit;
    if (above != open.end() && above->first < low + height(edge.rect)) hit = above->second;
    if (above != open.begin()) {
      const std::size_t below = std::prev(above)->second;
      if (layout.places[below].y + height(below) > low) hit = below;
    }
    if (hit) {
      const auto [first, second] = std::minmax(*hit, edge.rect);
      return "rectangles " + std::to_string(first + 1) + " and " + std::to_string(second + 1) + " overlap";
    }
    open.emplace(low, edge.rect);
  }
  return std::nullopt;
}

}  // namespace etak
