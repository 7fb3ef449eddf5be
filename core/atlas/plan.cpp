// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/plan.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "core/atlas/outline_pieces.h"
#include "core/atlas/planning.h"
#include "core/base/error.h"

namespace etak {
namespace {

using planning::block_side, planning::cells_of, planning::fits, planning::log2_floor, planning::rounded_up;
using planning::Cells, planning::Planning;

// Gutters may enlarge the page area up to this factor; beyond it regions get no gutters, and UVs are inset.
// That happens to regions whose sides are powers of two: with any gutter they need the next page size.
constexpr double most_gutter_area = 1.25;

// Pages whose sides are free become whole blocks where that takes less than this share more of their area.
constexpr double most_block_area = 1.02;

// The sides of a page that may grow, as whole blocks where these cost next to nothing.
RectSize in_blocks(const RectSize& page, int largest_side) {
  const RectSize out{rounded_up(page.width, block_side), rounded_up(page.height, block_side)};
  const auto area = [](const RectSize& s) { return static_cast<double>(s.width) * s.height; };
  return std::max(out.width, out.height) <= largest_side && area(out) < most_block_area * area(page) ? out
                                                                                                     : page;
}

struct Attempt {
  bool gutters = true;
  bool apart = false;   // regions that lack a texture go to pages of their own
  int clean_limit = 0;  // clean mips at most; 0: any number
};

// Regions that lack a texture may be a group of pages by themselves.
bool may_be_apart(const Planning& in) {
  return in.options.split_textures && std::any_of(in.regions.begin(), in.regions.end(), [](const Region& r) {
           return !r.own_page && !(r.in[0] && r.in[1]);
         });
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

// Packs as `options` say, and where that is not possible says why.
RectLayout packed_as_said(const Planning& in, const Cells& cells, const std::vector<std::size_t>& which,
                          const std::vector<RectSize>& sizes, const RectOptions& options,
                          const PreviousRects* previous) {
  planning::check_sizes(in, cells, options);
  if (options.form == PageForm::pages || options.form == PageForm::mixed)
    return pack_rects(sizes, options, previous);
  try {
    return pack_rects(sizes, options, previous);
  } catch (const Error&) {
    planning::refuse_too_many(in, cells, which, options);
  }
}

// Packs onto one page of any sides where that was asked for and is possible, else as `options` say.
RectLayout packed(const Planning& in, const Cells& cells, const std::vector<std::size_t>& which,
                  const std::vector<RectSize>& sizes, const RectOptions& options,
                  const PreviousRects* previous) {
  if (!in.options.free_first) return packed_as_said(in, cells, which, sizes, options, previous);
  RectOptions free = options;
  free.form = PageForm::free;
  free.multiple = std::max(options.multiple, block_side);
  try {
    return pack_rects(sizes, free, previous);
  } catch (const Error&) {
    return packed_as_said(in, cells, which, sizes, options, previous);
  }
}

// Packs cells that are no rectangles: one page of any sides.
RectLayout packed_outlines(const Cells& cells, const std::vector<std::size_t>& which,
                           const RectOptions& options, const std::vector<MaskShape>& all,
                           std::optional<PreviousRects> previous) {
  RectOptions units = options;
  const int multiple = std::max(options.multiple, block_side);
  units.multiple = multiple / std::gcd(multiple, cells.align);
  units.largest_side = options.largest_side / cells.align;
  std::vector<MaskShape> shapes;
  for (const std::size_t i : which) shapes.push_back(all[i]);
  if (previous) {
    for (RectSize& page : previous->pages) page = {page.width / cells.align, page.height / cells.align};
    for (std::optional<RectPlace>& place : previous->places)
      if (place) place->x /= cells.align, place->y /= cells.align;
  }
  std::optional<RectLayout> out = pack_masks(shapes, units, previous ? &*previous : nullptr);
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
  const bool outlines = !plan.shapes.empty();
  const std::optional<PreviousRects> previous = planning::previous_rects(in, cells, which, has, outlines);
  const RectLayout layout = outlines
                                ? packed_outlines(cells, which, options, plan.shapes, previous)
                                : packed(in, cells, which, sizes, options, previous ? &*previous : nullptr);
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
    const int left = planning::columns_left(in.regions[i], sizes[k], gutter, outlines, at.rotated);
    plan.places[i] = {first + at.page, at.x + left + gutter,       at.y + gutter, at.rotated, gutter,
                      cells.clean[i],  {at.x, at.y, width, height}};
    if (outlines)
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

// The plan that moves the fewest regions, among those that take little more than `fresh`.
PackingPlan steadiest_plan(const Planning& in, PackingPlan fresh) {
  const double allowed = static_cast<double>(fresh.page_texels()) * (1 + in.options.most_extra_area);
  PackingPlan best = std::move(fresh);
  best.moved = planning::moved(in, best);
  const auto offer = [&](PackingPlan plan) {
    plan.moved = planning::moved(in, plan);
    const auto rank = [](const PackingPlan& p) { return std::make_tuple(p.moved, p.page_texels()); };
    if (static_cast<double>(plan.page_texels()) <= allowed && rank(plan) < rank(best)) best = std::move(plan);
  };
  // A new region with more clean mips than any before it would move all others to a coarser grid.
  const int limits[] = {0, planning::earlier_limit(in)};
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

PackingPlan plan_pages(const std::vector<Region>& regions, const std::vector<std::string>& names,
                       const PlanOptions& options, const AtlasLayout* previous) {
  PackingPlan fresh = least_plan({regions, names, options});
  if (previous == nullptr) return fresh;
  return steadiest_plan(
      {regions, names, options, previous, planning::earlier_places(regions, names, *previous)},
      std::move(fresh));
}

}  // namespace etak
