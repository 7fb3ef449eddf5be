// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/plan.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "core/atlas/outline_pieces.h"
#include "core/base/error.h"
#include "core/base/setting.h"

namespace etak {
namespace {

// Gutters may enlarge the page area up to this factor; beyond it regions get no gutters, and UVs are inset.
// That happens to regions whose sides are powers of two: with any gutter they need the next page size.
constexpr double most_gutter_area = 1.25;

int log2_floor(int value) {
  int out = 0;
  while (value > 1) value >>= 1, ++out;
  return out;
}

int rounded_up(int value, int multiple) {
  return (value + multiple - 1) / multiple * multiple;
}

// Blocks that hardware compresses have so many texels a side.
constexpr int block = 4;
// Pages whose sides are free become whole blocks where that takes less than this share more of their area.
constexpr double most_block_area = 1.02;

// The sides of a page that may grow, as whole blocks where these cost next to nothing.
RectSize in_blocks(const RectSize& page, int largest_side) {
  const RectSize out{rounded_up(page.width, block), rounded_up(page.height, block)};
  const auto area = [](const RectSize& s) { return static_cast<double>(s.width) * s.height; };
  return std::max(out.width, out.height) <= largest_side && area(out) < most_block_area * area(page) ? out
                                                                                                     : page;
}

struct Cells {
  std::vector<RectSize> sizes;
  std::vector<int> gutters, clean;
  int align = 1;
};

// The cell of each region with its gutter.
//   clean_limit   above 0: clean mips at most
Cells cells_of(const std::vector<Region>& regions, const PlanOptions& options, bool gutters,
               int clean_limit = 0) {
  Cells out;
  for (const Region& region : regions) {
    const int smaller = std::min(region.width(), region.height());
    const int wanted = levels_wanted(options.levels, region.levels);
    const int most = clean_limit > 0 ? std::min(clean_limit, wanted) : wanted;
    int clean = clean_levels(region.width(), region.height(), most, options.gutter);
    // Bilinear filtering of the last clean mip, 2^(clean - 1) texels to one, reads one beyond the edge.
    const int needed = gutters ? std::max(options.least_gutter, 1 << (clean - 1)) : 0;
    // A given gutter grows to the grid of the mips: the region itself must begin on it.
    const int gutter = options.gutter ? rounded_up(*options.gutter, 1 << (clean - 1)) : needed;
    if (!gutters && !options.gutter) clean = std::min(most, std::max(1, log2_floor(smaller) - 1));
    out.gutters.push_back(gutter);
    out.clean.push_back(clean);
    if (wanted > 1) out.align = std::max(out.align, 1 << (clean - 1));
  }
  // One grid for all cells, so that every texel of every clean mip belongs to one region. A grid coarser than
  // a quarter of the usual region would waste more than the last mips are worth.
  for (std::size_t i = 0; i < regions.size(); ++i) {
    out.sizes.push_back({rounded_up(regions[i].width() + 2 * out.gutters[i], out.align),
                         rounded_up(regions[i].height() + 2 * out.gutters[i], out.align)});
  }
  return out;
}

std::optional<RectPlace> old_place(const AtlasRect& rect, const Cells& cells, int gutter) {
  RectPlace place{rect.page, rect.x - gutter, rect.y - gutter, rect.rotated};
  if (place.x < 0 || place.y < 0 || place.x % cells.align != 0 || place.y % cells.align != 0 ||
      rect.gutter != gutter)
    return std::nullopt;
  return place;
}

// The regions that are planned, and where they were in an earlier layout.
struct Planning {
  const std::vector<Region>& regions;
  const std::vector<std::string>& names;  // of the materials
  const PlanOptions& options;
  const AtlasLayout* previous = nullptr;    // null: none, or not to be looked at
  std::vector<const AtlasRect*> earlier{};  // by region; null: it is new
};

struct Attempt {
  bool gutters = true;
  bool apart = false;   // regions that lack a texture go to pages of their own
  int clean_limit = 0;  // clean mips at most; 0: any number
};

// The rectangles of the earlier layout that hold what the regions hold.
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

// The side that no region of a page may exceed.
int largest_cell(const RectOptions& options) {
  if (options.form == PageForm::pages) return options.side;
  if (options.form != PageForm::mixed) return options.largest_side;
  int out = 1;
  while (out <= options.side / 2) out *= 2;
  return out;
}

std::string text_of(const RectSize& size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

// The region's material, and its texels with their gutter.
std::string place_of(const Planning& in, const Cells& cells, std::size_t region) {
  const Region& of = in.regions[region];
  std::string out = in.names[of.material] + ": " + text_of({of.width(), of.height()}) + " texels";
  if (cells.gutters[region] > 0)
    out += ", " + text_of(cells.sizes[region]) + " with a gutter of " + std::to_string(cells.gutters[region]);
  return out;
}

// Throws Error for the first region that no page can hold, and says what would hold it.
void check_sizes(const Planning& in, const Cells& cells, const RectOptions& options) {
  const int most = largest_cell(options);
  for (std::size_t i = 0; i < in.regions.size(); ++i) {
    const Region& region = in.regions[i];
    const int side = std::max(cells.sizes[i].width, cells.sizes[i].height);
    if (region.own_page || side <= most) continue;
    std::string help = setting("page") + " " + std::to_string(side);
    if (side <= options.largest_side)
      help = setting("page-form") + " free";
    else if (std::max(region.width(), region.height()) <= most)
      help += " or " + setting("gutter") + " 0";
    throw Error(place_of(in, cells, i) + "; expected at most " + std::to_string(most) + " a side (" + help +
                " would do)");
  }
}

// One page holds each region, but not all of them.
[[noreturn]] void refuse_too_many(const Planning& in, const Cells& cells,
                                  const std::vector<std::size_t>& which, const RectOptions& options) {
  const auto area = [&](std::size_t i) {
    return static_cast<std::uint64_t>(cells.sizes[i].width) *
           static_cast<std::uint64_t>(cells.sizes[i].height);
  };
  std::uint64_t all = 0;
  std::size_t largest = which.front();
  for (const std::size_t i : which) {
    all += area(i);
    if (area(i) > area(largest)) largest = i;
  }
  const std::string side = std::to_string(options.largest_side);
  throw Error(std::to_string(which.size()) + " regions, the largest of " + place_of(in, cells, largest) +
              ", of together " + std::to_string(all) + " texels do not fit one page; expected at most " +
              side + " x " + side + " (" + setting("page-form") + " mixed or a larger " + setting("page") +
              " would do)");
}

bool fits(const Planning& in, const Cells& cells) {
  for (std::size_t i = 0; i < in.regions.size(); ++i)
    if (!in.regions[i].own_page &&
        std::max(cells.sizes[i].width, cells.sizes[i].height) > in.options.rects.largest_side)
      return false;
  return true;
}

// Regions that lack a texture may be a group of pages by themselves.
bool may_be_apart(const Planning& in) {
  return in.options.split_textures && std::any_of(in.regions.begin(), in.regions.end(), [](const Region& r) {
           return !r.own_page && !(r.in[0] && r.in[1]);
         });
}

// Regions of the earlier layout that are the same and lie elsewhere.
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

// The clean mips that unchanged regions had at most; 0 where the choice of mips itself is another one now.
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

PackingPlan empty_plan(const Planning& in) {
  PackingPlan plan;
  plan.places.resize(in.regions.size());
  return plan;
}

void add_own_page(const Planning& in, std::size_t i, PackingPlan& plan) {
  const Region& region = in.regions[i];
  const int width = region.width(), height = region.height();
  const int levels = in.options.levels == 0 ? 16 : in.options.levels;
  const int clean = std::min(levels, 1 + log2_floor(std::max(width, height)));
  plan.places[i] = {static_cast<int>(plan.pages.size()), 0, 0, false, 0, clean, {0, 0, width, height}};
  plan.pages.push_back({width, height, in.options.split_textures ? region.in : std::array{true, true}});
}

// Where the same regions were, on the pages of the same kind.
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

// Packs as `options` say, and where that is not possible says why.
RectLayout packed_as_said(const Planning& in, const Cells& cells, const std::vector<std::size_t>& which,
                          const std::vector<RectSize>& sizes, const RectOptions& options,
                          const PreviousRects* previous) {
  check_sizes(in, cells, options);
  if (options.form == PageForm::pages || options.form == PageForm::mixed)
    return pack_rects(sizes, options, previous);
  try {
    return pack_rects(sizes, options, previous);
  } catch (const Error&) {
    refuse_too_many(in, cells, which, options);
  }
}

// Packs onto one page of any sides where that was asked for and is possible, else as `options` say.
RectLayout packed(const Planning& in, const Cells& cells, const std::vector<std::size_t>& which,
                  const std::vector<RectSize>& sizes, const RectOptions& options,
                  const PreviousRects* previous) {
  if (!in.options.free_first) return packed_as_said(in, cells, which, sizes, options, previous);
  RectOptions free = options;
  free.form = PageForm::free;
  free.multiple = std::max(options.multiple, block);
  try {
    return pack_rects(sizes, free, previous);
  } catch (const Error&) {
    return packed_as_said(in, cells, which, sizes, options, previous);
  }
}

// The same of cells that are no rectangles: one page of any sides.
RectLayout packed_outlines(const Cells& cells, const std::vector<std::size_t>& which,
                           const RectOptions& options, const std::vector<MaskShape>& all) {
  RectOptions units = options;
  const int multiple = std::max(options.multiple, block);
  units.multiple = multiple / std::gcd(multiple, cells.align);
  units.largest_side = options.largest_side / cells.align;
  std::vector<MaskShape> shapes;
  for (const std::size_t i : which) shapes.push_back(all[i]);
  std::optional<RectLayout> out = pack_masks(shapes, units);
  if (!out) throw Error("the outlines of " + std::to_string(which.size()) + " regions fit no page");
  for (RectSize& page : out->pages) page = {page.width * cells.align, page.height * cells.align};
  for (RectPlace& place : out->places) place.x *= cells.align, place.y *= cells.align;
  return std::move(*out);
}

void add_pages(const Planning& in, const Cells& cells, const std::vector<std::size_t>& which,
               std::array<bool, 2> has, PackingPlan& plan) {
  if (which.empty()) return;
  std::vector<RectSize> sizes;
  for (const std::size_t i : which) sizes.push_back(cells.sizes[i]);
  RectOptions options = in.options.rects;
  options.align = std::max(options.align, cells.align);
  if (cells.align > 1 && options.form != PageForm::strip)
    options.multiple = std::max(options.multiple, cells.align);
  const std::optional<PreviousRects> previous = previous_rects(in, cells, which, has);
  const RectLayout layout = plan.shapes.empty()
                                ? packed(in, cells, which, sizes, options, previous ? &*previous : nullptr)
                                : packed_outlines(cells, which, options, plan.shapes);
  const int first = static_cast<int>(plan.pages.size());
  for (RectSize page : layout.pages) {
    if (options.form == PageForm::free || options.form == PageForm::square)
      page = in_blocks(page, options.largest_side);
    plan.pages.push_back({page.width, page.height, has});
  }
  for (std::size_t k = 0; k < which.size(); ++k) {
    const std::size_t i = which[k];
    const RectPlace& at = layout.places[k];
    const int gutter = cells.gutters[i];
    const int width = at.rotated ? sizes[k].height : sizes[k].width;
    const int height = at.rotated ? sizes[k].width : sizes[k].height;
    // The rounding up of a shape's height lies on the left of it where the shape is turned.
    const int left = !plan.shapes.empty() && at.rotated ? width - in.regions[i].height() - 2 * gutter : 0;
    plan.places[i] = {first + at.page, at.x + left + gutter,       at.y + gutter, at.rotated, gutter,
                      cells.clean[i],  {at.x, at.y, width, height}};
    if (!plan.shapes.empty())
      plan.places[i].cell_texels = count_of(plan.shapes[i].runs) * static_cast<std::uint64_t>(cells.align) *
                                   static_cast<std::uint64_t>(cells.align);
  }
  plan.method += (plan.method.empty() ? "" : ", ") + layout.method;
  plan.tries += layout.tries;
  plan.cut_by_time = plan.cut_by_time || layout.cut_by_time;
  plan.kept_previous = plan.kept_previous || layout.kept_previous;
}

// All regions on common pages, or those that one texture can do without on pages that lack it.
PackingPlan plan_with(const Planning& in, const Attempt& attempt) {
  const Cells cells = cells_of(in.regions, in.options, attempt.gutters, attempt.clean_limit);
  std::vector<std::size_t> groups[3];
  for (std::size_t i = 0; i < in.regions.size(); ++i) {
    const auto& has = in.regions[i].in;
    if (!in.regions[i].own_page)
      groups[!attempt.apart || (has[0] && has[1]) ? 0 : has[0] ? 1 : 2].push_back(i);
  }
  PackingPlan plan = empty_plan(in);
  if (std::ranges::any_of(in.regions, [](const Region& r) { return !r.texels.empty(); })) {
    plan.unit = cells.align;
    for (std::size_t i = 0; i < in.regions.size(); ++i)
      plan.shapes.push_back(cell_shape(in.regions[i], cells.gutters[i], cells.clean[i], cells.align));
  }
  add_pages(in, cells, groups[0], {true, true}, plan);
  add_pages(in, cells, groups[1], {true, false}, plan);
  add_pages(in, cells, groups[2], {false, true}, plan);
  for (std::size_t i = 0; i < in.regions.size(); ++i)
    if (in.regions[i].own_page) add_own_page(in, i, plan);
  plan.inset = !attempt.gutters;
  plan.clean_limit = attempt.clean_limit;
  return plan;
}

// The plan of least area, without regard to an earlier layout; with gutters unless they cost too much.
PackingPlan least_plan(const Planning& in) {
  const PlanOptions& options = in.options;
  if (in.regions.empty()) return {};
  // A region by itself needs no gutter when the page is of just its size.
  const auto whole = [&](int side) { return side % options.rects.multiple == 0; };
  if (in.regions.size() == 1 && !options.may_inset && options.bare_alone && !options.gutter &&
      !in.regions[0].own_page && whole(in.regions[0].width()) && whole(in.regions[0].height())) {
    PackingPlan plan = empty_plan(in);
    add_own_page(in, 0, plan);
    return plan;
  }
  const auto smaller = [&](bool gutters) {
    PackingPlan common = plan_with(in, {gutters, false});
    if (!may_be_apart(in)) return common;
    PackingPlan apart = plan_with(in, {gutters, true});
    return apart.page_texels() < common.page_texels() ? apart : common;
  };
  const bool may_inset = options.may_inset && !options.gutter;
  if (may_inset && !fits(in, cells_of(in.regions, options, true))) return smaller(false);
  PackingPlan out = smaller(true);
  if (!may_inset) return out;
  PackingPlan bare = smaller(false);
  if (static_cast<double>(out.page_texels()) > most_gutter_area * static_cast<double>(bare.page_texels()))
    return bare;
  return out;
}

// Of the plans that take little more than `fresh` the one that moves the fewest regions.
PackingPlan steadiest_plan(const Planning& in, PackingPlan fresh) {
  const double allowed = static_cast<double>(fresh.page_texels()) * (1 + in.options.most_extra_area);
  PackingPlan best = std::move(fresh);
  best.moved = moved(in, best);
  const auto offer = [&](PackingPlan plan) {
    plan.moved = moved(in, plan);
    const auto rank = [](const PackingPlan& p) { return std::make_tuple(p.moved, p.page_texels()); };
    if (static_cast<double>(plan.page_texels()) <= allowed && rank(plan) < rank(best)) best = std::move(plan);
  };
  // A new region with more clean mips than any before it would move all others to a coarser grid.
  const int limits[] = {0, earlier_limit(in)};
  for (std::size_t k = 0; k < 2 && best.moved > 0; ++k) {
    if (k > 0 && limits[k] == 0) break;
    for (const bool gutters : {true, false}) {
      if (!gutters && (!in.options.may_inset || in.options.gutter)) continue;
      if (!fits(in, cells_of(in.regions, in.options, gutters, limits[k]))) continue;
      offer(plan_with(in, {gutters, false, limits[k]}));
      if (may_be_apart(in)) offer(plan_with(in, {gutters, true, limits[k]}));
    }
  }
  best.kept_previous = best.kept_previous || best.moved == 0;
  return best;
}

}  // namespace

std::uint64_t PackingPlan::page_texels() const {
  std::uint64_t sum = 0;
  for (const PlannedPage& page : pages)
    sum += static_cast<std::uint64_t>(page.width) * static_cast<std::uint64_t>(page.height) *
           static_cast<std::uint64_t>(int{page.has[0]} + int{page.has[1]});
  return sum;
}

int PackingPlan::clean_levels(int page) const {
  int out = 1;
  for (const PlannedPlace& each : places)
    if (each.page == page) out = std::max(out, each.clean_levels);
  return out;
}

int default_clean_levels(int width, int height) {
  return 1 + log2_floor(std::max(1, std::min(width, height) / 32));
}

int levels_wanted(int asked, int read) {
  constexpr int all = 16;
  return std::min(asked == 0 ? all : asked, read == 0 ? all : read);
}

int clean_levels(int width, int height, int wanted, std::optional<int> gutter) {
  const bool given = gutter && *gutter > 0;
  return std::min(wanted, given ? 1 + log2_floor(*gutter) : default_clean_levels(width, height));
}

PackingPlan plan_pages(const std::vector<Region>& regions, const std::vector<std::string>& names,
                       const PlanOptions& options, const AtlasLayout* previous) {
  PackingPlan fresh = least_plan({regions, names, options});
  if (previous == nullptr) return fresh;
  return steadiest_plan({regions, names, options, previous, earlier_rects(regions, names, *previous)},
                        std::move(fresh));
}

}  // namespace etak
