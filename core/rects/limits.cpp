// SPDX-License-Identifier: Apache-2.0
#include "core/rects/limits.h"

#include <algorithm>
#include <cmath>

namespace etak::rects {
namespace {

// What an ordinary try of n rectangles may cost. Few rectangles deserve many cheap tries; from some 2,000 on
// the first tries are already within a percent of full.
std::int64_t ordinary_work(int n) {
  const std::int64_t count = n;
  if (count <= 500) return 23'000;
  return std::min(count * count / 10, std::max<std::int64_t>(300'000, 40 * count));
}

}  // namespace

int round_up(std::int64_t value, std::int64_t multiple) {
  return static_cast<int>(std::min<std::int64_t>((value + multiple - 1) / multiple * multiple, INT_MAX / 2));
}

Budget::Budget(int effort, int n, double max_seconds)
    : n_(n),
      timed_(max_seconds > 0),
      end_(std::chrono::steady_clock::now() +
           std::chrono::microseconds(static_cast<std::int64_t>(std::min(max_seconds, 1e9) * 1e6))) {
  allow(effort);
}

void Budget::allow(int effort) {
  allowed_ = tries_left_ = effort;
  work_left_ = effort * ordinary_work(n_);
}

bool Budget::open() {
  if (tries_left_ <= 0 || work_left_ <= 0 || cut_) return false;
  // The first try is made in any case: without it there is no layout.
  cut_ = timed_ && tries_ > 0 && std::chrono::steady_clock::now() > end_;
  return !cut_;
}

void Budget::charge(std::int64_t work) {
  ++tries_;
  --tries_left_;
  work_left_ -= work;
}

bool Budget::would_end(int effort) const {
  const std::int64_t less = allowed_ - effort;
  return tries_left_ <= less || work_left_ <= less * ordinary_work(n_);
}

int Family::full(int side) const {
  return round_up(std::int64_t{side} * unit, multiple) / unit;
}

int Family::smaller(int side) const {
  return (round_up(std::int64_t{side} * unit, multiple) - multiple) / unit;
}

int side_of(const Family& family, const Best& best) {
  return family.width > 0 ? best.height : std::max(best.width, best.height);
}

bool can_hold(const Set& set, bool rotate, int width, int height) {
  if (!rotate) {
    width -= width % set.width_step;
    height -= height % set.height_step;
    return width >= set.widest && height >= set.tallest && std::int64_t{width} * height >= set.area;
  }
  if (std::int64_t{width} * height < set.area || std::min(width, height) < set.longest_short_side)
    return false;
  return std::max(width, height) >= set.longest_side;
}

int least_height(const Set& set, bool rotate, int width) {
  int out = rotate ? set.longest_short_side : set.tallest;
  if (rotate && width < set.longest_side) {
    for (const RectSize& item : set.items) {
      const int longer = std::max(item.width, item.height);
      if (longer > width) out = std::max(out, longer);
    }
  }
  const int usable = rotate ? width : std::max(1, width - width % set.width_step);
  out = std::max(out, round_up(set.area, usable) / usable);
  return rotate ? out : round_up(out, set.height_step);
}

namespace {

// Without rotation, rectangles wider than half the page lie one above the other, and those higher than half
// of it side by side.
bool stacks_fit(const Set& set, int width, int height) {
  std::int64_t up = 0, across = 0;
  for (const RectSize& item : set.items) {
    if (item.width > width - item.width) up += item.height;
    if (item.height > height - item.height) across += item.width;
  }
  return up <= height && across <= width;
}

}  // namespace

int least_square(const Set& set, bool rotate) {
  int side = std::max({1, set.longest_side, static_cast<int>(std::sqrt(static_cast<double>(set.area))) - 1});
  if (!rotate && !stacks_fit(set, side, side)) {
    int bad = side, good = side;
    while (!stacks_fit(set, good, good)) good *= 2;
    while (good - bad > 1) {
      const int middle = bad + (good - bad) / 2;
      (stacks_fit(set, middle, middle) ? good : bad) = middle;
    }
    side = good;
  }
  while (!can_hold(set, rotate, side, side)) ++side;
  return side;
}

}  // namespace etak::rects
