// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/plan.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <tuple>

#include "core/base/error.h"

namespace etak {
namespace {

// A gutter is worth this much of the page area; beyond it regions keep their bare cells and UVs are inset.
// Power-of-two regions are the case: any gutter moves them to the next page size.
constexpr double most_gutter_area = 1.25;

int log2_floor(int value) {
  int out = 0;
  while (value > 1) value >>= 1, ++out;
  return out;
}

int rounded_up(int value, int multiple) {
  return (value + multiple - 1) / multiple * multiple;
}

struct Cells {
  std::vector<RectSize> sizes;
  std::vector<int> gutters, clean;
  int align = 1;
};

// What each region takes with its gutter.
Cells cells_of(const std::vector<Region>& regions, const PlanOptions& options, bool gutters) {
  Cells out;
  for (const Region& region : regions) {
    const int smaller = std::min(region.box.width, region.box.height);
    const int wanted = options.levels == 0 ? 16 : options.levels;
    int clean = std::min(wanted, default_clean_levels(region.box.width, region.box.height));
    // Bilinear filtering of the last clean mip, 2^(clean - 1) texels to one, reads one beyond the edge.
    int gutter = gutters ? std::max(options.least_gutter, 1 << (clean - 1)) : 0;
    if (options.gutter) {
      gutter = *options.gutter;
      clean = gutter == 0 ? clean : std::min(wanted, 1 + log2_floor(gutter));
    }
    if (!gutters && !options.gutter) clean = std::min(wanted, std::max(1, log2_floor(smaller) - 1));
    out.gutters.push_back(gutter);
    out.clean.push_back(clean);
    if (wanted > 1) out.align = std::max(out.align, 1 << (clean - 1));
  }
  // One grid for all cells, so that every texel of every clean mip belongs to one region. A grid coarser than
  // a quarter of the usual region would waste more than the last mips are worth.
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const PixelBox& box = regions[i].box;
    out.sizes.push_back({rounded_up(box.width + 2 * out.gutters[i], out.align),
                         rounded_up(box.height + 2 * out.gutters[i], out.align)});
  }
  return out;
}

std::optional<RectPlace> old_place(const AtlasRect& rect, const Cells& cells, std::size_t i, int gutter) {
  RectPlace place{rect.page, rect.x - gutter, rect.y - gutter, rect.rotated};
  if (place.x < 0 || place.y < 0 || place.x % cells.align != 0 || place.y % cells.align != 0 ||
      rect.gutter != gutter)
    return std::nullopt;
  (void)i;
  return place;
}

class Planner {
 public:
  Planner(const std::vector<Region>& regions, const std::vector<std::string>& names,
          const PlanOptions& options, const AtlasLayout* previous)
      : regions_(regions), names_(names), options_(options), previous_(previous) {}

  Plan best() {
    if (regions_.empty()) return {};
    // A region by itself needs no gutter when the page is of just its size.
    if (regions_.size() == 1 && !options_.may_inset && !options_.gutter && !regions_[0].own_page) {
      Plan plan = empty_plan();
      add_own_page(plan, 0);
      return plan;
    }
    const bool may_inset = options_.may_inset && !options_.gutter;
    if (may_inset && !fits(cells_of(regions_, options_, true))) {
      Plan bare = split(false);
      bare.inset = true;
      return bare;
    }
    Plan out = split(true);
    if (!may_inset) return out;
    Plan bare = split(false);
    bare.inset = true;
    if (static_cast<double>(out.page_texels()) > most_gutter_area * static_cast<double>(bare.page_texels()))
      return bare;
    return out;
  }

 private:
  bool fits(const Cells& cells) const {
    for (std::size_t i = 0; i < regions_.size(); ++i)
      if (!regions_[i].own_page &&
          std::max(cells.sizes[i].width, cells.sizes[i].height) > options_.rects.largest_side)
        return false;
    return true;
  }

  // All regions on common pages, or those that one texture can do without on pages that lack it.
  Plan split(bool gutters) {
    const Cells cells = cells_of(regions_, options_, gutters);
    std::vector<std::size_t> all, groups[3];
    for (std::size_t i = 0; i < regions_.size(); ++i) {
      if (regions_[i].own_page) continue;
      all.push_back(i);
      groups[regions_[i].in[0] && regions_[i].in[1] ? 0 : regions_[i].in[0] ? 1 : 2].push_back(i);
    }
    const bool one_group = groups[0].size() == all.size();
    Plan common = empty_plan();
    add(common, cells, all, {true, true});
    // Regions that lack a texture may be a group of pages by themselves.
    if (!one_group && options_.split_textures) {
      Plan apart = empty_plan();
      add(apart, cells, groups[0], {true, true});
      add(apart, cells, groups[1], {true, false});
      add(apart, cells, groups[2], {false, true});
      if (apart.page_texels() < common.page_texels()) common = std::move(apart);
    }
    for (std::size_t i = 0; i < regions_.size(); ++i)
      if (regions_[i].own_page) add_own_page(common, i);
    return common;
  }

  void add_own_page(Plan& plan, std::size_t i) const {
    const PixelBox& box = regions_[i].box;
    const int levels = options_.levels == 0 ? 16 : options_.levels;
    const int clean = std::min(levels, 1 + log2_floor(std::max(box.width, box.height)));
    plan.places[i] = {static_cast<int>(plan.pages.size()), 0, 0, false, 0, clean,
                      {0, 0, box.width, box.height}};
    plan.pages.push_back(
        {box.width, box.height, options_.split_textures ? regions_[i].in : std::array{true, true}});
  }

  Plan empty_plan() const {
    Plan plan;
    plan.places.resize(regions_.size());
    return plan;
  }

  void add(Plan& plan, const Cells& cells, const std::vector<std::size_t>& which, std::array<bool, 2> has) {
    if (which.empty()) return;
    std::vector<RectSize> sizes;
    for (const std::size_t i : which) sizes.push_back(cells.sizes[i]);
    RectOptions options = options_.rects;
    options.align = std::max(options.align, cells.align);
    if (cells.align > 1 && options.form != PageForm::strip)
      options.multiple = std::max(options.multiple, cells.align);
    const std::optional<PreviousRects> previous = previous_rects(cells, which, has);
    const RectLayout layout = packed(sizes, options, previous ? &*previous : nullptr);
    const int first = static_cast<int>(plan.pages.size());
    for (const RectSize& page : layout.pages) plan.pages.push_back({page.width, page.height, has});
    for (std::size_t k = 0; k < which.size(); ++k) {
      const std::size_t i = which[k];
      const RectPlace& at = layout.places[k];
      const int gutter = cells.gutters[i];
      const int width = at.rotated ? sizes[k].height : sizes[k].width;
      const int height = at.rotated ? sizes[k].width : sizes[k].height;
      plan.places[i] = {first + at.page,
                        at.x + gutter,
                        at.y + gutter,
                        at.rotated,
                        gutter,
                        cells.clean[i],
                        {at.x, at.y, width, height}};
    }
    plan.method += (plan.method.empty() ? "" : ", ") + layout.method;
    plan.tries += layout.tries;
    plan.cut_by_time = plan.cut_by_time || layout.cut_by_time;
    plan.kept_previous = plan.kept_previous || layout.kept_previous;
    plan.moved += layout.moved;
  }

  // One page of any sides where that was asked for and is possible, else several.
  RectLayout packed(const std::vector<RectSize>& sizes, const RectOptions& options,
                    const PreviousRects* previous) const {
    if (!options_.free_first) return pack_rects(sizes, options, previous);
    RectOptions free = options;
    free.form = PageForm::free;
    free.multiple = std::max(options.multiple, 4);
    try {
      return pack_rects(sizes, free, previous);
    } catch (const Error&) {
      return pack_rects(sizes, options, previous);
    }
  }

  // Where the same regions were, on the pages of the same kind.
  std::optional<PreviousRects> previous_rects(const Cells& cells, const std::vector<std::size_t>& which,
                                              std::array<bool, 2> has) const {
    if (previous_ == nullptr) return std::nullopt;
    PreviousRects out;
    std::map<int, int> page_number;  // in the old layout: among the pages of this kind
    for (std::size_t p = 0; p < previous_->pages.size(); ++p) {
      const AtlasPage& page = previous_->pages[p];
      if (page.files[0].empty() == has[0] || page.files[1].empty() == has[1]) continue;
      page_number[static_cast<int>(p)] = static_cast<int>(out.pages.size());
      out.pages.push_back({page.width, page.height});
    }
    std::map<std::tuple<std::string, int, int, int, int>, const AtlasRect*> old;
    for (const AtlasRect& rect : previous_->rects)
      old[{rect.name, rect.crop.x, rect.crop.y, rect.crop.width, rect.crop.height}] = &rect;
    for (const std::size_t i : which) {
      const PixelBox& box = regions_[i].box;
      const auto found = old.find({names_[regions_[i].material], box.x, box.y, box.width, box.height});
      std::optional<RectPlace> place;
      if (found != old.end() && page_number.contains(found->second->page)) {
        place = old_place(*found->second, cells, i, cells.gutters[i]);
        if (place) place->page = page_number[found->second->page];
      }
      out.places.push_back(place);
    }
    return out;
  }

  const std::vector<Region>& regions_;
  const std::vector<std::string>& names_;
  const PlanOptions& options_;
  const AtlasLayout* previous_;
};

}  // namespace

std::uint64_t Plan::page_texels() const {
  std::uint64_t sum = 0;
  for (const Page& page : pages)
    sum += static_cast<std::uint64_t>(page.width) * static_cast<std::uint64_t>(page.height) *
           static_cast<std::uint64_t>(int{page.has[0]} + int{page.has[1]});
  return sum;
}

int default_clean_levels(int width, int height) {
  return 1 + log2_floor(std::max(1, std::min(width, height) / 32));
}

Plan plan_pages(const std::vector<Region>& regions, const std::vector<std::string>& names,
                const PlanOptions& options, const AtlasLayout* previous) {
  return Planner(regions, names, options, previous).best();
}

}  // namespace etak
