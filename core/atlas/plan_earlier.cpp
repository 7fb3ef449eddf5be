// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

#include "core/atlas/planning.h"

namespace etak::planning {
namespace {

// The places of cells are those of their gutters' corners, on the grid of all cells.
std::optional<RectPlace> old_place(const EarlierPlace& at, const Cells& cells, int gutter, int left) {
  const RectPlace place{at.page, at.x - gutter - left, at.y - gutter, at.rotated};
  if (place.x < 0 || place.y < 0 || place.x % cells.align != 0 || place.y % cells.align != 0 ||
      at.gutter != gutter)
    return std::nullopt;
  return place;
}

// Boxes of a picture as texels of the level that is stored.
PixelBox box_at(const PixelBox& box, int level) {
  return {box.x >> level, box.y >> level, box.width >> level, box.height >> level};
}

// Where the region lies if a rectangle of the layout is a part of it; none where it is stored at another size.
std::optional<EarlierPlace> place_by(const AtlasRect& rect, const Region& region) {
  const PixelBox box = box_at(region.box, region.shrink), crop = box_at(rect.crop, region.shrink);
  if ((rect.rotated ? rect.height : rect.width) != crop.width ||
      (rect.rotated ? rect.width : rect.height) != crop.height)
    return std::nullopt;
  const int right = crop.x - box.x, down = crop.y - box.y;
  EarlierPlace out{rect.page, rect.x - right, rect.y - down, rect.rotated, rect.gutter, rect.mips};
  if (rect.rotated) {
    out.x = rect.x - (box.height - down - crop.height);
    out.y = rect.y - right;
  }
  return out;
}

// Whether some rectangles hold a run of texels of the level that is stored.
bool hold(const std::vector<const AtlasRect*>& rects, const RowRun& run, int level) {
  for (int x = run.begin; x < run.end;) {
    const auto found = std::ranges::find_if(rects, [&](const AtlasRect* rect) {
      const PixelBox crop = box_at(rect->crop, level);
      return crop.x <= x && x < crop.x + crop.width && crop.y <= run.row && run.row < crop.y + crop.height;
    });
    if (found == rects.end()) return false;
    const PixelBox crop = box_at((*found)->crop, level);
    x = crop.x + crop.width;
  }
  return true;
}

// The place of an outline that lay in the pieces of one island.
std::optional<EarlierPlace> place_in(const std::vector<const AtlasRect*>& island, const Region& region) {
  if (!hold(island, {region.texels[0].row, region.texels[0].begin, region.texels[0].begin + 1},
            region.shrink))
    return std::nullopt;
  const auto all = [&](const RowRun& run) { return hold(island, run, region.shrink); };
  return std::ranges::all_of(region.texels, all) ? place_by(*island[0], region) : std::nullopt;
}

}  // namespace

std::vector<std::optional<EarlierPlace>> earlier_places(const std::vector<Region>& regions,
                                                        const std::vector<std::string>& names,
                                                        const AtlasLayout& layout) {
  std::map<std::tuple<std::string, int, int, int, int>, const AtlasRect*> boxes;
  std::map<std::string, std::map<int, std::vector<const AtlasRect*>>> islands;
  for (const AtlasRect& rect : layout.rects) {
    boxes[{rect.name, rect.crop.x, rect.crop.y, rect.crop.width, rect.crop.height}] = &rect;
    islands[rect.name][rect.island].push_back(&rect);
  }
  std::vector<std::optional<EarlierPlace>> out;
  for (const Region& region : regions) {
    std::optional<EarlierPlace>& place = out.emplace_back();
    const std::string& name = names[region.material];
    const PixelBox& box = region.box;
    if (!region.texels.empty()) {
      for (const auto& [number, island] : islands[name])
        if (!place) place = place_in(island, region);
    } else if (const auto found = boxes.find({name, box.x, box.y, box.width, box.height});
               found != boxes.end()) {
      place = place_by(*found->second, region);
    }
  }
  return out;
}

std::size_t moved(const Planning& in, const PackingPlan& plan) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < in.regions.size(); ++i) {
    const std::optional<EarlierPlace>& old = in.earlier[i];
    const PlannedPlace& now = plan.places[i];
    if (old &&
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
    const std::optional<EarlierPlace>& old = in.earlier[i];
    if (in.regions[i].own_page || !old) continue;
    if (old->mips != cells.clean[i] || old->gutter != cells.gutters[i]) return 0;
    most = std::max(most, old->mips);
  }
  return most;
}

std::optional<PreviousRects> previous_rects(const Planning& in, const Cells& cells,
                                            const std::vector<std::size_t>& which, std::array<bool, 2> has,
                                            bool outlines) {
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
    const std::optional<EarlierPlace>& old = in.earlier[i];
    if (old && page_number.contains(old->page)) {
      const int gutter = cells.gutters[i];
      place = old_place(*old, cells, gutter,
                        columns_left(in.regions[i], cells.sizes[i], gutter, outlines, old->rotated));
      if (place) place->page = page_number[old->page];
    }
    out.places.push_back(place);
  }
  return out;
}

}  // namespace etak::planning
