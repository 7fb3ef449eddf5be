// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

#include "core/atlas/planning.h"

namespace etak::planning {
namespace {

std::optional<RectPlace> old_place(const AtlasRect& rect, const Cells& cells, int gutter) {
  RectPlace place{rect.page, rect.x - gutter, rect.y - gutter, rect.rotated};
  if (place.x < 0 || place.y < 0 || place.x % cells.align != 0 || place.y % cells.align != 0 ||
      rect.gutter != gutter)
    return std::nullopt;
  return place;
}

}  // namespace

std::vector<const AtlasRect*> earlier_rects(const std::vector<Region>& regions,
                                            const std::vector<std::string>& names,
                                            const AtlasLayout& layout) {
  std::map<std::tuple<std::string, int, int, int, int>, const AtlasRect*> known;
  for (const AtlasRect& rect : layout.rects)
    known[{rect.name, rect.crop.x, rect.crop.y, rect.crop.width, rect.crop.height}] = &rect;
  std::vector<const AtlasRect*> out;
  for (const Region& region : regions) {
    const PixelBox& box = region.box;
    const auto found = known.find({names[region.material], box.x, box.y, box.width, box.height});
    const AtlasRect* const old = found == known.end() ? nullptr : found->second;
    const bool same = old != nullptr && (old->rotated ? old->height : old->width) == region.width() &&
                      (old->rotated ? old->width : old->height) == region.height();
    out.push_back(same ? old : nullptr);
  }
  return out;
}

std::size_t moved(const Planning& in, const PackingPlan& plan) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < in.regions.size(); ++i) {
    const AtlasRect* old = in.earlier[i];
    const PlannedPlace& now = plan.places[i];
    if (old != nullptr &&
        std::tie(old->page, old->x, old->y, old->rotated) != std::tie(now.page, now.x, now.y, now.rotated))
      ++count;
  }
  return count;
}

int earlier_limit(const Planning& in) {
  const bool gutters = !std::any_of(in.previous->rects.begin(), in.previous->rects.end(),
                                    [](const AtlasRect& rect) { return rect.inset > 0; });
  const Cells cells = cells_of(in.regions, in.options, gutters);
  int most = 0;
  for (std::size_t i = 0; i < in.regions.size(); ++i) {
    const AtlasRect* old = in.regions[i].own_page ? nullptr : in.earlier[i];
    if (old == nullptr) continue;
    if (old->mips != cells.clean[i] || old->gutter != cells.gutters[i]) return 0;
    most = std::max(most, old->mips);
  }
  return most;
}

std::optional<PreviousRects> previous_rects(const Planning& in, const Cells& cells,
                                            const std::vector<std::size_t>& which, std::array<bool, 2> has) {
  if (in.previous == nullptr) return std::nullopt;
  PreviousRects out;
  std::map<int, int> page_number;  // in the old layout: among the pages of this kind
  for (std::size_t p = 0; p < in.previous->pages.size(); ++p) {
    const AtlasPage& page = in.previous->pages[p];
    if (page.files[0].empty() == has[0] || page.files[1].empty() == has[1]) continue;
    page_number[static_cast<int>(p)] = static_cast<int>(out.pages.size());
    out.pages.push_back({page.width, page.height});
  }
  out.most_extra_area = std::numeric_limits<double>::max();  // the area of the whole plan is judged later
  for (const std::size_t i : which) {
    std::optional<RectPlace> place;
    const AtlasRect* old = in.earlier[i];
    if (old != nullptr && page_number.contains(old->page)) {
      place = old_place(*old, cells, cells.gutters[i]);
      if (place) place->page = page_number[old->page];
    }
    out.places.push_back(place);
  }
  return out;
}

}  // namespace etak::planning
