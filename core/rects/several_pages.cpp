// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>
#include <tuple>

#include "core/rects/index.h"
#include "core/rects/pack.h"

namespace etak::rects {
namespace {

struct Filler {
  Filler(const Set& s, bool rotate, const Frame& frame, Budget& b)
      : set(s), search(s, rotate, frame.threads, b) {}
  const Set& set;
  Search search;
};

struct Filled {
  std::size_t left = 0;        // rectangles without a place
  std::int64_t last_area = 0;  // in the last page
};

void take(const std::vector<Spot>& spots, int page, Packed& out, std::vector<int>& left) {
  std::vector<int> rest;
  for (const int i : left) {
    if (spots[at(i)].x < 0) {
      rest.push_back(i);
      continue;
    }
    out.spots[at(i)] = spots[at(i)];
    out.page_of[at(i)] = page;
  }
  left.swap(rest);
}

// Fills one page after the other. Gives up when more than `most` pages would be needed, and also at the end
// of the budget unless it `must` give a layout: a part of what more effort would have done is not used.
class PageFiller {
 public:
  PageFiller(Filler& filler, Budget& budget, const std::vector<RectSize>& pages, std::size_t most, bool must)
      : filler_(filler), budget_(budget), pages_(pages), most_(most), must_(must) {
    out_.spots.assign(filler_.set.items.size(), {-1, 0, false});
    out_.page_of.assign(filler_.set.items.size(), -1);
    filled_.left = filler_.set.items.size();
  }

  /// Fills all pages by entry `which` of the portfolio, or (-1) each page by the entry that fills it best.
  Packed fill(int which, Filled& filled) {
    if (which >= 0 && filler_.search.offer(at(which)))
      by_one_offer();
    else
      by_entries(which);
    filled = filled_;
    return std::move(out_);
  }

 private:
  bool goes_on() const { return filled_.left > 0 && out_.pages.size() < most_; }
  bool may_try() const { return must_ || budget_.open(); }
  RectSize next_page() const { return pages_[std::min(out_.pages.size(), pages_.size() - 1)]; }

  // A page that takes nothing is left out; the one after it may be larger in the other direction.
  bool ends_with(std::int64_t area) {
    filled_.last_area = area;
    return area <= 0 && out_.pages.size() >= pages_.size();
  }

  void by_one_offer() {
    std::vector<std::pair<int, Spot>> placed;
    while (goes_on() && may_try()) {
      const RectSize page = next_page();
      const Outcome outcome = filler_.search.fill_next(page.width, page.height, placed);
      const int index = static_cast<int>(out_.pages.size());
      out_.pages.push_back(page);
      for (const auto& [i, spot] : placed) {
        out_.spots[at(i)] = spot;
        out_.page_of[at(i)] = index;
      }
      filled_.left -= placed.size();
      if (ends_with(outcome.placed)) return;
    }
  }

  void by_entries(int which) {
    std::vector<int> left(filler_.set.items.size());
    std::iota(left.begin(), left.end(), 0);
    std::vector<Spot> spots, best_spots;
    const std::size_t tries = which < 0 ? std::min<std::size_t>(8, filler_.search.entries()) : 1;
    while (goes_on()) {
      const RectSize page = next_page();
      std::int64_t best = -1;
      for (std::size_t t = 0; t < tries; ++t) {
        if (!may_try()) return;
        const std::size_t entry = which < 0 ? t : at(which);
        const Outcome outcome = filler_.search.fill(page.width, page.height, left, entry, spots);
        if (outcome.placed <= best) continue;
        best = outcome.placed;
        best_spots.swap(spots);
        if (outcome.all) break;
      }
      const int index = static_cast<int>(out_.pages.size());
      out_.pages.push_back(page);
      take(best_spots, index, out_, left);
      filled_.left = left.size();
      if (ends_with(best)) return;
    }
  }

  Filler& filler_;
  Budget& budget_;
  const std::vector<RectSize>& pages_;
  std::size_t most_;
  bool must_;
  Packed out_;
  Filled filled_;
};

// The entries by which all pages are filled, in the order of the tries: the best one for each page (-1), then
// single entries; where there must be a layout, the first entry comes before these.
std::vector<int> ways(std::size_t entries, bool must) {
  std::vector<int> out = {-1};
  for (std::size_t which = 0; which < entries; ++which) out.push_back(static_cast<int>(which));
  if (must) std::swap(out[0], out[1]);
  return out;
}

std::int64_t texels_of(const Packed& packed, const Frame& frame) {
  std::int64_t out = 0;
  for (const RectSize& page : packed.pages) {
    const auto power = [&](int length) {
      return std::int64_t{std::bit_ceil(static_cast<unsigned>(frame.side_texels(length)))};
    };
    out += power(page.width) * power(page.height);
  }
  return out;
}

// Makes each page as small as the extent of its rectangles.
void shrink(const Set& set, Packed& packed) {
  for (RectSize& page : packed.pages) page = {};
  for (std::size_t i = 0; i < packed.spots.size(); ++i) {
    RectSize& page = packed.pages[at(packed.page_of[i])];
    const Spot& spot = packed.spots[i];
    const RectSize& size = set.items[i];
    page.width = std::max(page.width, spot.x + (spot.rotated ? size.height : size.width));
    page.height = std::max(page.height, spot.y + (spot.rotated ? size.width : size.height));
  }
}

// What a layout of several pages is judged by: how many they are, or their texels when each is cut down to
// powers of two.
enum class Cost { pages, texels };

Packed fill_pages(const Set& set, const Frame& frame, int width, int height, Cost cost, Budget& budget) {
  const std::int64_t page = std::int64_t{width} * height;
  const auto unit_area = std::int64_t{frame.unit} * frame.unit;
  const std::int64_t least =
      cost == Cost::texels ? set.area * unit_area : std::max<std::int64_t>(1, (set.area + page - 1) / page);
  const std::vector<RectSize> page_of_all = {{width, height}};
  Packed best;
  std::int64_t best_cost = 0, best_last = 0;
  for (const bool rotate : {false, true}) {
    if (rotate ? !frame.rotate : set.widest > width || set.tallest > height) continue;
    budget.allow(frame.effort + frame.effort / 4);  // a part of it ends in the middle of a page and is lost
    Filler filler(set, rotate, frame, budget);
    for (const int which : ways(filler.search.entries(), best.pages.empty())) {
      const bool must = best.pages.empty();
      if (!must && (!budget.open() || best_cost <= least)) break;
      Filled filled;
      const std::size_t most = must || cost == Cost::texels ? set.items.size() : best.pages.size();
      Packed packed = PageFiller(filler, budget, page_of_all, most, must).fill(which, filled);
      if (filled.left > 0) continue;
      if (cost == Cost::texels) shrink(set, packed);
      const std::int64_t found =
          cost == Cost::texels ? texels_of(packed, frame) : static_cast<std::int64_t>(packed.pages.size());
      // Among layouts of equal cost the one with the emptiest last page is kept: it has most room left.
      if (!must && std::tie(found, filled.last_area) >= std::tie(best_cost, best_last)) continue;
      packed.method = which < 0 ? "the fullest of 8 rules for each page"
                                : portfolio(set.size(), rotate)[at(which)].name();
      best = std::move(packed);
      best_cost = found;
      best_last = filled.last_area;
    }
  }
  return best;
}

}  // namespace

Packed pack_pages(const Set& set, const Frame& frame, int width, int height, Budget& budget) {
  return fill_pages(set, frame, width, height, Cost::pages, budget);
}

namespace {

// Pages of powers of two with `total` texels, the largest first: full ones, then halves by halves.
std::vector<RectSize> pages_of(std::int64_t total, int side, std::int64_t grain, bool lying) {
  std::vector<RectSize> out;
  int w = side, h = side;
  while (total >= grain) {
    const std::int64_t area = std::int64_t{w} * h;
    if (area <= total) {
      out.push_back({w, h});
      total -= area;
      continue;
    }
    if (area <= grain) break;
    if (w == h) {
      (lying ? h : w) /= 2;
    } else {
      w = h = std::min(w, h);
    }
  }
  return out;
}

}  // namespace

Packed pack_mixed(const Set& set, const Frame& frame, Budget& budget) {
  const int side_texels = power_below(frame.side_in_texels);
  const int side = side_texels / frame.unit;
  Packed best = fill_pages(set, frame, side, side, Cost::texels, budget);
  best.method = "pages of one size, " + best.method;
  std::int64_t best_texels = texels_of(best, frame);

  const std::int64_t full = std::int64_t{side_texels} * side_texels;
  const std::int64_t unit_area = std::int64_t{frame.unit} * frame.unit;
  // The smallest step of the total: fine where there are few pages.
  std::int64_t grain = std::max<std::int64_t>(1, full / 256);
  while (grain * 512 < set.area * unit_area) grain *= 2;
  for (int pass = 0; pass < (frame.rotate ? 2 : 1); ++pass) {
    const bool rotate = pass == 1;
    budget.allow(frame.effort + frame.effort / 4);  // a part of it ends in the middle of a page and is lost
    Filler filler(set, rotate, frame, budget);
    const auto holds = [&](std::int64_t total) {
      const std::size_t rules = std::min<std::size_t>(4, filler.search.entries());
      for (const bool lying : {true, false}) {
        std::vector<RectSize> pages = pages_of(total, side_texels, grain, lying);
        if (pages.empty()) continue;
        for (RectSize& page : pages) page = {page.width / frame.unit, page.height / frame.unit};
        for (const int which : ways(rules, false)) {
          if (!budget.open()) return false;
          Filled filled;
          Packed packed = PageFiller(filler, budget, pages, pages.size(), false).fill(which, filled);
          if (filled.left > 0) continue;
          drop_empty(packed.pages, packed.page_of, [](int& page) -> int& { return page; });
          shrink(set, packed);
          const std::int64_t texels = texels_of(packed, frame);
          if (texels < best_texels) {
            packed.method =
                "sizes halved down, " + (which < 0 ? std::string("the fullest of 8 rules for each page")
                                                   : portfolio(set.size(), rotate)[at(which)].name());
            best = std::move(packed);
            best_texels = texels;
          }
          return true;
        }
      }
      return false;
    };
    // Totals from the least upward, with longer and longer steps.
    std::int64_t total = (set.area * unit_area + grain - 1) / grain * grain;
    for (std::int64_t step = grain; total < best_texels && budget.open(); total += step) {
      if (holds(total)) break;
      if (total > step * 32) step *= 2;
    }
  }
  return best;
}

}  // namespace etak::rects
