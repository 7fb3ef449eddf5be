// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

#include "core/math/functions.h"
#include "core/rects/pack.h"

namespace etak::rects {
namespace {

// The search without rotation comes first and in full even where rotation is allowed. Its layout is then a
// candidate, so that rotation never makes the result worse. The search with rotation starts from that
// layout and gets a part of the tries.
int turned_part(const Frame& frame, int effort) {
  return std::max(1, frame.form == PageForm::strip ? effort / 2 : effort * 3 / 4);
}

int effort_of(const Frame& frame, bool rotate) {
  return rotate ? turned_part(frame, frame.effort) : frame.effort;
}

// The efforts at which rounds with rotation begin: 1, 10, 100 ...
std::vector<int> levels(const Frame& frame) {
  std::vector<int> out;
  for (int level = 1; level <= frame.effort; level *= 10) out.push_back(level);
  return out;
}

std::vector<bool> rotations(const Frame& frame) {
  return frame.rotate ? std::vector<bool>{false, true} : std::vector<bool>{false};
}

// Climbing begins at the layout of this effort, so that a larger one finds what a smaller one does, and has this effort.
constexpr int climbed_at = 100, climb_effort = 1000;

// Of few rectangles, of which a try takes little, where some of the page is empty.
bool worth_climbing(const Set& set, int width, int height) {
  constexpr int most_climbed = 400;
  constexpr double full = 0.995;
  return set.size() <= most_climbed && set.items.front() != set.items.back() &&
         static_cast<double>(set.area) < full * width * height;
}

// More effort never gives a larger page, because a search with less effort makes the first steps of one with
// more. Therefore a round with rotation starts from the layout that the search without rotation had at the
// same effort, not from its last one, and the length of a round depends on nothing else.
//   climbed   gets the layout that effort `climbed_at` ends with; null: not wanted
//   families   of pages without rotation and with it
void search_both(const Set& set, const Frame& frame, const std::array<Family, 2>& families, Budget& budget,
                 Best& best, Best* climbed = nullptr) {
  const auto& [upright, turned] = families;
  const std::vector<int> marks = levels(frame);
  std::vector<Best> seeds;
  if (upright.least <= upright.most) {
    budget.allow(effort_of(frame, false));
    Search search(set, false, frame.threads, budget);
    search.run(upright, best, marks, seeds);
  }
  for (std::size_t i = 0; i < seeds.size() && climbed != nullptr; ++i)
    if (marks[i] == climbed_at) *climbed = seeds[i];
  if (!frame.rotate || turned.least > turned.most) return;
  Search search(set, true, frame.threads, budget);
  Best round;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    if (i < seeds.size() && seeds[i].any &&
        (!round.any || side_of(turned, seeds[i]) < side_of(turned, round)))
      round = std::move(seeds[i]);
    budget.allow(turned_part(frame, marks[i]));
    search.run(turned, round);
    if (climbed != nullptr && marks[i] == climbed_at) *climbed = round;
  }
  if (round.any && (!best.any || side_of(turned, round) < side_of(turned, best))) best = std::move(round);
}

Packed packed(const Best& best, RectSize page) {
  return {{page}, best.spots, std::vector<int>(best.spots.size(), 0), best.method};
}

}  // namespace

int Frame::side_texels(int length) const {
  const std::int64_t texels = std::int64_t{length} * unit;
  return static_cast<int>((texels + multiple - 1) / multiple * multiple);
}

std::optional<Packed> pack_square(const Set& set, const Frame& frame, Budget& budget) {
  std::array<Family, 2> families;
  for (const bool rotate : {false, true}) {
    Family& family = families[rotate];
    family.most = frame.largest;
    family.unit = frame.unit;
    family.multiple = frame.multiple;
    family.least = least_square(set, rotate);
  }
  Best best, climbed;
  search_both(set, frame, families, budget, best, &climbed);
  if (!best.any) return std::nullopt;
  if (climbed.any && worth_climbing(set, side_of(families[0], climbed), side_of(families[0], climbed))) {
    Family& family = families[frame.rotate];
    family.below = side_of(family, climbed);
    budget.allow(climb_effort);
    Best found;
    Search(set, frame.rotate, frame.threads, budget).climb(family, found);
    if (found.any && side_of(family, found) < side_of(family, best)) best = std::move(found);
  }
  const int side = std::max(best.width, best.height);
  return packed(best, {side, side});
}

std::optional<Packed> pack_strip(const Set& set, const Frame& frame, Budget& budget) {
  std::array<Family, 2> families;
  for (const bool rotate : {false, true}) {
    Family& family = families[rotate];
    family.width = frame.side;
    family.most = frame.largest;
    const bool fits = (rotate ? set.longest_short_side : set.widest) <= frame.side;
    family.least = fits ? least_height(set, rotate, frame.side) : frame.largest + 1;
  }
  Best best;
  search_both(set, frame, families, budget, best);
  if (!best.any) return std::nullopt;
  return packed(best, {frame.side, best.height});
}

namespace {

std::int64_t area_of(const Frame& frame, int width, int height) {
  return std::int64_t{frame.side_texels(width)} * frame.side_texels(height);
}

struct Width {
  int width;
  std::int64_t area;  // of the page that the first look found
};

// The largest different widths but for the widest.
std::vector<int> widest_sides(const Set& set) {
  constexpr std::size_t most = 4;
  std::vector<int> out;
  for (const RectSize& item : set.items) out.push_back(item.width);
  std::ranges::sort(out, std::greater());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  if (!out.empty()) out.erase(out.begin());
  out.resize(std::min(out.size(), most));
  return out;
}

// Widths from half to twice the side of a full square, where long thin pages begin.
std::vector<int> widths_to_try(const Set& set, const Frame& frame, bool rotate) {
  std::vector<int> out;
  const double middle = std::sqrt(static_cast<double>(set.area));
  const int least = std::max(1, rotate ? set.longest_short_side : set.widest);
  for (int k = -8; k <= 8; ++k) out.push_back(static_cast<int>(std::ceil(middle * math::exp2(k / 16.0))));
  std::vector<int> sides{set.widest, set.tallest, 2 * set.widest};
  for (const int other : widest_sides(set)) sides.push_back(set.widest + other);
  for (const int side : sides)
    if (side > middle / 2 && side < middle * 2) out.push_back(side);
  for (int& width : out) {
    width = std::clamp(width, least, std::max(least, frame.largest));
    width = std::max(least, width / set.width_step * set.width_step);
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

// A page with two free sides: a first look at many widths, then a search at each of the best. Monotone in the
// effort as search_both is.
class FreeSearch {
 public:
  FreeSearch(const Set& set, const Frame& frame, Budget& budget, bool rotate)
      : set_(set),
        frame_(frame),
        budget_(budget),
        rotate_(rotate),
        search_(set, rotate, frame.threads, budget) {}

  // Looks at each width; layouts that are found go into `best`.
  void look(Best& best) {
    for (const int width : widths_to_try(set_, frame_, rotate_)) {
      const Family family = family_of(width);
      if (width > frame_.largest || family.least > family.most) continue;
      budget_.allow(look_effort);
      Best found;
      search_.look(family, found);
      if (!found.any) continue;
      const std::int64_t area = area_of(frame_, found.width, found.height);
      keep(std::move(found), best);
      seen_.push_back({width, area});
    }
    std::stable_sort(seen_.begin(), seen_.end(),
                     [](const Width& a, const Width& b) { return a.area < b.area; });
    if (seen_.size() > finalists) seen_.resize(finalists);
  }

  // The best of all that is smaller than `bound` within that effort at each width, and within each of
  // `marks`.
  void search(const Best& bound, int effort, std::span<const int> marks, Best& best,
              std::vector<Best>& noted) {
    noted.resize(marks.size());
    std::vector<int> parts;
    for (const int mark : marks) parts.push_back(part(mark));
    for (const Width& candidate : seen_) {
      const Family family = family_below(candidate.width, bound);
      budget_.allow(part(effort));
      Best found;
      std::vector<Best> found_at;
      search_.run(family, found, parts, found_at);
      keep(std::move(found), best);
      for (std::size_t i = 0; i < found_at.size(); ++i) keep(std::move(found_at[i]), noted[i]);
    }
  }

  // A smaller page than `bound`, of its width or of another that looked good, by other orders of the rectangles.
  void climb(const Best& bound, Best& best) {
    if (!worth_climbing(set_, bound.width, bound.height)) return;
    std::vector<int> widths{bound.width};
    for (const Width& each : seen_)
      if (each.width != bound.width) widths.push_back(each.width);
    Best at_best = bound;
    for (const int width : widths) {
      budget_.allow(climb_effort);
      Best found;
      search_.climb(family_below(width, at_best), found);
      keep(std::move(found), at_best);
    }
    keep(std::move(at_best), best);
  }

  void keep(Best&& found, Best& best) const {
    if (found.any &&
        (!best.any || area_of(frame_, found.width, found.height) < area_of(frame_, best.width, best.height)))
      best = std::move(found);
  }

 private:
  static constexpr std::size_t finalists = 6;
  static constexpr int look_effort = 12;
  // A try of few rectangles takes little, so that more of them pay.
  int part(int effort) const { return set_.size() <= most_few ? 4 * effort / 3 : std::max(1, effort / 3); }

  Family family_of(int width) const {
    Family family;
    family.width = width;
    family.most = frame_.largest;
    family.unit = frame_.unit;
    family.multiple = frame_.multiple;
    family.least = least_height(set_, rotate_, width);
    return family;
  }

  // The pages of a width that are smaller than `bound`.
  Family family_below(int width, const Best& bound) const {
    Family family = family_of(width);
    const std::int64_t area = area_of(frame_, bound.width, bound.height);
    const std::int64_t across = frame_.side_texels(width);
    // The first height whose page would be no improvement.
    family.below = static_cast<int>(
        std::min<std::int64_t>((area + across - 1) / across / frame_.unit + 1, INT32_MAX / 2));
    while (family.below > 1 && area_of(frame_, width, family.below - 1) >= area) --family.below;
    return family;
  }

  const Set& set_;
  const Frame& frame_;
  Budget& budget_;
  bool rotate_;
  Search search_;
  std::vector<Width> seen_;
};

}  // namespace

std::optional<Packed> pack_free(const Set& set, const Frame& frame, Budget& budget) {
  const std::vector<int> marks = levels(frame);
  FreeSearch upright(set, frame, budget, false);
  Best looked;
  upright.look(looked);
  Best best = looked;
  std::vector<Best> seeds(marks.size());
  if (looked.any) upright.search(looked, effort_of(frame, false), marks, best, seeds);
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const Best at_mark = !seeds[i].any || area_of(frame, looked.width, looked.height) <
                                              area_of(frame, seeds[i].width, seeds[i].height)
                             ? looked
                             : seeds[i];
    if (marks[i] == climbed_at && at_mark.any) upright.climb(at_mark, best);
  }
  if (frame.rotate) {
    FreeSearch turned(set, frame, budget, true);
    turned.look(looked);
    for (std::size_t i = 0; i < marks.size() && looked.any; ++i) {
      turned.keep(std::move(seeds[i]), looked);
      const Best bound = looked;
      std::vector<Best> none;
      turned.search(bound, turned_part(frame, marks[i]), {}, looked, none);
      if (marks[i] == climbed_at) turned.climb(looked, best);
    }
    turned.keep(std::move(looked), best);
  }
  if (!best.any) return std::nullopt;
  return packed(best, {best.width, best.height});
}

std::optional<Packed> pack_power_of_two(const Set& set, const Frame& frame, Budget& budget) {
  struct Candidate {
    std::int64_t width, height;
  };
  std::vector<Candidate> pages;
  const std::int64_t largest = std::int64_t{frame.largest} * frame.unit + frame.unit - 1;
  for (std::int64_t w = 1; w <= largest; w *= 2)
    for (std::int64_t h = 1; h <= largest; h *= 2)
      if (w % frame.multiple == 0 && h % frame.multiple == 0) pages.push_back({w, h});
  std::sort(pages.begin(), pages.end(), [](const Candidate& a, const Candidate& b) {
    if (a.width * a.height != b.width * b.height) return a.width * a.height < b.width * b.height;
    const std::int64_t long_a = std::max(a.width, a.height), long_b = std::max(b.width, b.height);
    return long_a != long_b ? long_a < long_b : a.width > b.width;  // the squarest first, then the wider
  });
  for (const Candidate& page : pages) {
    const int width = static_cast<int>(page.width / frame.unit),
              height = static_cast<int>(page.height / frame.unit);
    for (const bool rotate : rotations(frame)) {
      if (!can_hold(set, rotate, width, height)) continue;
      Family family;
      family.width = width;
      family.least = family.most = height;
      // Below nine tenths the first few tries decide.
      const double share = static_cast<double>(set.area) / (static_cast<double>(width) * height);
      budget.allow(share < 0.9 ? std::max(1, effort_of(frame, rotate) / 4) : effort_of(frame, rotate));
      Best best;
      Search search(set, rotate, frame.threads, budget);
      search.run(family, best);
      if (best.any) return packed(best, {width, height});
    }
  }
  return std::nullopt;
}

}  // namespace etak::rects
