// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/atlas/rects_pack.h"

namespace etak::rects {
namespace {

// The search without rotation comes first and in full even where rotation is allowed: what it finds is then a
// candidate, so that rotation never hurts. The second search starts from there.
int effort_of(const Frame& frame, bool rotate) {
  if (!rotate) return frame.effort;
  return std::max(1, frame.form == PageForm::strip ? frame.effort / 2 : frame.effort * 3 / 4);
}

std::vector<bool> rotations(const Frame& frame) {
  return frame.rotate ? std::vector<bool>{false, true} : std::vector<bool>{false};
}

Packed packed(const Best& best, Page page) {
  return {{page}, best.spots, std::vector<int>(best.spots.size(), 0), best.method};
}

}  // namespace

int Frame::side_texels(int length) const {
  const std::int64_t texels = std::int64_t{length} * unit;
  return static_cast<int>((texels + multiple - 1) / multiple * multiple);
}

int power_of_two_texels(const Frame& frame, int length) {
  const int texels = frame.side_texels(length);
  int out = 1;
  while (out < texels) out *= 2;
  return out;
}

std::optional<Packed> pack_square(const Set& set, const Frame& frame, Budget& budget) {
  Best best;
  for (const bool rotate : rotations(frame)) {
    budget.allow(effort_of(frame, rotate));
    Family family;
    family.most = frame.largest;
    family.unit = frame.unit;
    family.multiple = frame.multiple;
    family.least = least_square(set, rotate);
    if (family.least > family.most) continue;
    Search search(set, rotate, frame.threads, budget);
    search.run(family, best);
  }
  if (!best.any) return std::nullopt;
  const int side = std::max(best.width, best.height);
  return packed(best, {side, side});
}

std::optional<Packed> pack_strip(const Set& set, const Frame& frame, Budget& budget) {
  Best best;
  for (const bool rotate : rotations(frame)) {
    if ((rotate ? set.longest_short_side : set.widest) > frame.side) continue;
    budget.allow(effort_of(frame, rotate));
    Family family;
    family.width = frame.side;
    family.most = frame.largest;
    family.least = least_height(set, rotate, frame.side);
    if (family.least > family.most) continue;
    Search search(set, rotate, frame.threads, budget);
    search.run(family, best);
  }
  if (!best.any) return std::nullopt;
  return packed(best, {frame.side, best.height});
}

namespace {

std::int64_t area_of(const Frame& frame, int width, int height) {
  return std::int64_t{frame.side_texels(width)} * frame.side_texels(height);
}

struct Width {
  int width;
  std::int64_t area;  // of what a first look found
};

// Widths from half to twice the side of a full square, where long thin pages begin.
std::vector<int> widths_to_try(const Set& set, const Frame& frame, bool rotate) {
  std::vector<int> out;
  const double middle = std::sqrt(static_cast<double>(set.area));
  const int least = std::max(1, rotate ? set.longest_short_side : set.widest);
  for (int k = -8; k <= 8; ++k) out.push_back(static_cast<int>(std::ceil(middle * std::exp2(k / 16.0))));
  for (const int side : {set.widest, set.tallest, 2 * set.widest})
    if (side > middle / 2 && side < middle * 2) out.push_back(side);
  for (int& width : out) {
    width = std::clamp(width, least, std::max(least, frame.largest));
    width = std::max(least, width / set.width_step * set.width_step);
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace

std::optional<Packed> pack_free(const Set& set, const Frame& frame, Budget& budget) {
  constexpr std::size_t finalists = 6;
  Best best;
  std::int64_t best_area = INT64_MAX;
  for (const bool rotate : rotations(frame)) {
    Search search(set, rotate, frame.threads, budget);
    const auto family_of = [&](int width) {
      Family family;
      family.width = width;
      family.most = frame.largest;
      family.unit = frame.unit;
      family.multiple = frame.multiple;
      family.least = least_height(set, rotate, width);
      return family;
    };
    const auto keep = [&](const Best& found) {
      const std::int64_t area = area_of(frame, found.width, found.height);
      if (area >= best_area) return;
      best = found;
      best_area = area;
    };
    const std::vector<int> widths = widths_to_try(set, frame, rotate);
    std::vector<Width> seen;
    for (const int width : widths) {
      const Family family = family_of(width);
      if (width > frame.largest || family.least > family.most) continue;
      budget.allow(std::max(4, effort_of(frame, rotate) / 8));
      Best found;
      search.look(family, found);
      if (!found.any) continue;
      keep(found);
      seen.push_back({width, area_of(frame, found.width, found.height)});
    }
    std::stable_sort(seen.begin(), seen.end(),
                     [](const Width& a, const Width& b) { return a.area < b.area; });
    if (seen.size() > finalists) seen.resize(finalists);
    for (const Width& candidate : seen) {
      Family family = family_of(candidate.width);
      // The first height whose page would be no improvement.
      const std::int64_t across = frame.side_texels(candidate.width);
      family.below = static_cast<int>(
          std::min<std::int64_t>((best_area + across - 1) / across / frame.unit + 1, INT32_MAX / 2));
      while (family.below > 1 && area_of(frame, candidate.width, family.below - 1) >= best_area)
        --family.below;
      budget.allow(effort_of(frame, rotate) / 3);
      Best found;
      search.run(family, found);
      if (found.any) keep(found);
    }
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
    return long_a != long_b ? long_a < long_b : a.width > b.width;  // the squarest first, then lying
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
