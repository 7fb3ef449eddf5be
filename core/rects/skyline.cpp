// SPDX-License-Identifier: Apache-2.0
#include "core/rects/skyline.h"

#include <algorithm>
#include <bit>
#include <climits>
#include <numeric>

#include "core/rects/index.h"
#include "core/rects/lanes.h"

namespace etak::rects {
namespace {

int padded(int count) {
  return (count + lane_count - 1) / lane_count * lane_count;
}

// The leftmost of the lowest segments; ys is padded with INT_MAX.
LANES_FUNCTION int lowest_segment(const int* ys, int count) {
  Lanes best, where, here = {0, 1, 2, 3, 4, 5, 6, 7};
  std::memcpy(&best, ys, sizeof best);
  where = here;
  for (int i = lane_count; i < count; i += lane_count) {
    Lanes y;
    std::memcpy(&y, ys + i, sizeof y);
    here += lane_count;
    const Lanes lower = y < best;
    best = lower ? y : best;
    where = lower ? here : where;
  }
  Lanes lowest = best;
  spread_least(lowest);
  where = best == lowest ? where : INT_MAX;
  spread_least(where);
  return where[0];
}

struct Gap {
  int width, room, left, right;  // room: height up to the page's end; left, right: height of the walls
  int least_width;
  int left_over_shift;  // makes a sixteenth of the gap about 1
};

// The slot with the highest score, or -1 where none fits. Slots behind the last are padded with INT_MAX.
LANES_FUNCTION int best_slot(const int* widths, const int* heights, int count, const Gap& gap,
                             const SkylineRule& rule) {
  constexpr int bias = 1 << 18;
  Lanes best = {}, place = {4095, 4094, 4093, 4092, 4091, 4090, 4089, 4088};
  best -= 1;
  for (int i = 0; i < count; i += lane_count) {
    Lanes w, h;
    std::memcpy(&w, widths + i, sizeof w);
    std::memcpy(&h, heights + i, sizeof h);
    const Lanes fits = (w <= gap.width) & (h <= gap.room);
    const Lanes over = fits ? gap.width - w : 0;
    Lanes score = (over == 0) & rule.exact;
    score += ((h == gap.left) | (h == gap.right)) & rule.flush;
    score += (h == gap.room) & rule.ceiling;
    score -= ((over > 0) & (over < gap.least_width)) & rule.sliver;
    if (rule.left_over > 0) score -= (over >> gap.left_over_shift) * rule.left_over;
    if (rule.late > 0) score -= i / 16 * rule.late;
    score = ((score + bias) << 12) + place;
    score = fits ? score : -1;
    best = score > best ? score : best;
    place -= lane_count;
  }
  best = -best;
  spread_least(best);
  const int key = -best[0];
  return key < 0 ? -1 : 4095 - (key & 4095);
}

}  // namespace

Skyline::Skyline(const Set& set, bool rotate) : set_(set), rotate_(rotate) {
  const int n = set.size();
  for (int i = 0; i < n; ++i) {
    const RectSize& size = set.items[at(i)];
    by_width_.push_back({size.width, size.height, i});
    if (rotate && size.width != size.height) by_width_.push_back({size.height, size.width, i});
  }
  std::sort(by_width_.begin(), by_width_.end(), [](const Entry& a, const Entry& b) {
    return a.width != b.width     ? a.width < b.width
           : a.height != b.height ? a.height < b.height
                                  : a.item > b.item;
  });
  constexpr int most_widths = 1 << 13;
  if (n > 0 && by_width_.back().width < most_widths) {
    ends_.assign(at(by_width_.back().width) + 1, 0);
    for (const Entry& entry : by_width_) ++ends_[at(entry.width)];
    std::partial_sum(ends_.begin(), ends_.end(), ends_.begin());
  }
  const auto height = [&](int i) {
    const RectSize& size = set_.items[at(i)];
    return rotate_ ? std::min(size.width, size.height) : size.height;
  };
  heights_.resize(at(n));
  std::iota(heights_.begin(), heights_.end(), 0);
  std::sort(heights_.begin(), heights_.end(),
            [&](int a, int b) { return height(a) != height(b) ? height(a) < height(b) : a < b; });
  xs_.assign(at(n) + 2 + 2 * lane_count, 0);
  ys_.assign(at(n) + 2 + 2 * lane_count, INT_MAX);
}

void Skyline::offer(std::span<const int> order, const SkylineRule& rule) {
  order_ = order;
  rule_ = rule;
  waiting_.assign(set_.items.size(), 0);
  spots_.assign(set_.items.size(), {-1, 0, false});
  for (const int i : order) waiting_[at(i)] = 1;
  waiting_count_ = order.size();
  leaves_ = 0;
  rule_.window = std::clamp(std::min(rule_.window, static_cast<int>(order.size())), 1, 2000);
  const int room = padded(2 * rule_.window + 2) + lane_count;
  slot_width_.assign(at(room), INT_MAX);
  slot_height_.assign(at(room), INT_MAX);
  slot_item_.assign(at(room), -1);
  slots_ = 0;
  next_ = 0;
  refill();
  narrowest_ = lowest_ = 0;
}

void Skyline::refill() {
  const int most = rotate_ ? 2 * rule_.window : rule_.window;
  while (slots_ < most && next_ < order_.size()) {
    const int item = order_[next_++];
    if (!waiting_[at(item)]) continue;
    const RectSize& size = set_.items[at(item)];
    const auto add = [&](int w, int h) {
      slot_width_[at(slots_)] = w;
      slot_height_[at(slots_)] = h;
      slot_item_[at(slots_++)] = item;
    };
    add(size.width, size.height);
    if (rotate_ && size.width != size.height) add(size.height, size.width);
  }
}

void Skyline::drop(int slot) {
  int first = slot, last = slot + 1;
  const int item = slot_item_[at(slot)];
  if (first > 0 && slot_item_[at(first - 1)] == item) --first;
  if (last < slots_ && slot_item_[at(last)] == item) ++last;
  const std::size_t moved = at(slots_ - last) * sizeof(int);
  std::memmove(&slot_width_[at(first)], &slot_width_[at(last)], moved);
  std::memmove(&slot_height_[at(first)], &slot_height_[at(last)], moved);
  std::memmove(&slot_item_[at(first)], &slot_item_[at(last)], moved);
  const int gone = last - first;
  for (int k = slots_ - gone; k < slots_; ++k) slot_width_[at(k)] = slot_height_[at(k)] = INT_MAX;
  slots_ -= gone;
}

void Skyline::make_tree() {
  leaves_ = static_cast<int>(std::bit_ceil(by_width_.size()));
  tree_.assign(2 * at(leaves_), INT_MAX);
  for (std::size_t i = 0; i < by_width_.size(); ++i)
    if (waiting_[at(by_width_[i].item)]) tree_[at(leaves_) + i] = by_width_[i].height;
  for (std::size_t node = at(leaves_); --node > 0;)
    tree_[node] = std::min(tree_[2 * node], tree_[2 * node + 1]);
}

void Skyline::forget(int entry) {
  std::size_t node = at(leaves_ + entry);
  tree_[node] = INT_MAX;
  while ((node /= 2) > 0) tree_[node] = std::min(tree_[2 * node], tree_[2 * node + 1]);
}

// The last of by_width_[0 .. entry] in the tree that is not higher than `room`, or -1.
int Skyline::last_below(int entry, int room) const {
  if (entry < 0) return -1;
  std::size_t node = at(leaves_ + entry);
  while (tree_[node] > room) {
    while (node % 2 == 0) node /= 2;  // nothing lies before a left child within its parent
    if (node == 1) return -1;
    --node;
  }
  while (node < at(leaves_)) {
    node = 2 * node + 1;
    if (tree_[node] > room) --node;
  }
  return static_cast<int>(node) - leaves_;
}

// How many entries are not wider than the gap.
int Skyline::not_wider(int gap) const {
  if (gap >= by_width_.back().width) return static_cast<int>(by_width_.size());
  if (!ends_.empty()) return ends_[at(gap)];
  const auto end = std::upper_bound(by_width_.begin(), by_width_.end(), gap,
                                    [](int width, const Entry& entry) { return width < entry.width; });
  return static_cast<int>(end - by_width_.begin());
}

// The widest of the rectangles that are not wider than the gap and not higher than the room.
Skyline::Choice Skyline::widest(int gap, int room) {
  if (leaves_ == 0) make_tree();
  for (int entry = not_wider(gap) - 1;;) {
    entry = last_below(entry, room);
    if (entry < 0) return {};
    const Entry& found = by_width_[at(entry)];
    if (waiting_[at(found.item)]) return {found.item, found.width, found.height};
    forget(entry);
  }
}

Skyline::Choice Skyline::choose(int gap, int room, int left, int right) {
  if (gap < least_width_ || room < least_height_) return {};
  int shift = 0;
  while (gap >> shift > 31) ++shift;
  const int slot = best_slot(slot_width_.data(), slot_height_.data(), slots_,
                             {gap, room, left, right, least_width_, shift}, rule_);
  if (slot >= 0) {
    const Choice choice{slot_item_[at(slot)], slot_width_[at(slot)], slot_height_[at(slot)]};
    drop(slot);
    return choice;
  }
  return next_ < order_.size() ? widest(gap, room) : Choice{};
}

// Joins the segment with a neighbour that is now at the same height.
void Skyline::join(int segment) {
  const auto remove = [&](int i) {  // segment i becomes part of i - 1
    std::memmove(&xs_[at(i)], &xs_[at(i + 1)], at(segments_ - i) * sizeof(int));
    std::memmove(&ys_[at(i)], &ys_[at(i + 1)], at(segments_ - i) * sizeof(int));
    --segments_;
  };
  if (segment + 1 < segments_ && ys_[at(segment + 1)] == ys_[at(segment)]) remove(segment + 1);
  if (segment > 0 && ys_[at(segment - 1)] == ys_[at(segment)]) remove(segment);
}

void Skyline::raise(int segment, int to) {
  ys_[at(segment)] = to;
  join(segment);
}

void Skyline::place(int segment, int gap, int left, int right, const Choice& choice) {
  bool at_left = true;
  if (choice.height == left) {
    at_left = true;
  } else if (choice.height == right) {
    at_left = false;
  } else if (rule_.side == 1) {
    at_left = left >= right;
  } else if (rule_.side == 2) {
    at_left = left <= right;
  }
  const int x = at_left ? xs_[at(segment)] : xs_[at(segment)] + gap - choice.width;
  const int y = ys_[at(segment)], top = y + choice.height;
  spots_[at(choice.item)] = {x, y, choice.width != set_.items[at(choice.item)].width};
  waiting_[at(choice.item)] = 0;
  --waiting_count_;
  placed_.push_back(choice.item);
  if (choice.width == gap) {
    ys_[at(segment)] = top;
    join(segment);
    return;
  }
  const auto insert = [&](int i, int from, int height) {  // a segment before what is number i now
    std::memmove(&xs_[at(i + 1)], &xs_[at(i)], at(segments_ + 1 - i) * sizeof(int));
    std::memmove(&ys_[at(i + 1)], &ys_[at(i)], at(segments_ - i) * sizeof(int));
    xs_[at(i)] = from;
    ys_[at(i)] = height;
    ++segments_;
  };
  if (at_left) {
    if (segment > 0 && ys_[at(segment - 1)] == top) {
      xs_[at(segment)] += choice.width;
    } else {
      insert(segment, x, top);
      xs_[at(segment + 1)] = x + choice.width;
    }
  } else if (segment + 1 < segments_ && ys_[at(segment + 1)] == top) {
    xs_[at(segment + 1)] -= choice.width;
  } else {
    insert(segment + 1, x, top);
  }
}

Outcome Skyline::pack(int width, int height, std::span<const int> order, const SkylineRule& rule,
                      bool partial) {
  offer(order, rule);
  std::int64_t spare = std::int64_t{width} * height;
  if (!partial)
    for (const int i : order) {
      const RectSize& size = set_.items[at(i)];
      spare -= std::int64_t{size.width} * size.height;
    }
  return fill(width, height, spare);
}

Outcome Skyline::fill(int width, int height) {
  return fill(width, height, std::int64_t{width} * height);
}

// Fills a page of whose area `spare` may be lost.
Outcome Skyline::fill(int width, int height, std::int64_t spare) {
  Outcome out;
  out.work = 10 * static_cast<std::int64_t>(waiting_count_);
  placed_.clear();
  std::fill(ys_.begin(), ys_.begin() + segments_ + 2, INT_MAX);
  segments_ = 1;
  xs_[0] = 0;
  xs_[1] = width;
  ys_[0] = 0;
  while (waiting_count_ > 0) {
    while (narrowest_ < by_width_.size() && !waiting_[at(by_width_[narrowest_].item)]) ++narrowest_;
    while (lowest_ < heights_.size() && !waiting_[at(heights_[lowest_])]) ++lowest_;
    least_width_ = by_width_[narrowest_].width;
    const RectSize& least = set_.items[at(heights_[lowest_])];
    least_height_ = rotate_ ? std::min(least.width, least.height) : least.height;

    out.work += 80 + 3 * ((slots_ + segments_) / lane_count);
    const int segment = lowest_segment(ys_.data(), segments_);
    const int y = ys_[at(segment)];
    if (y >= height) break;
    const int gap = xs_[at(segment + 1)] - xs_[at(segment)];
    const int room = height - y;
    const int left = segment == 0 ? room : ys_[at(segment - 1)] - y;
    const int right = segment + 1 == segments_ ? room : ys_[at(segment + 1)] - y;
    const Choice choice = choose(gap, room, left, right);
    if (choice.item < 0) {
      const int up = std::min(left, right);
      spare -= std::int64_t{gap} * up;
      if (spare < 0) break;
      raise(segment, y + up);
      continue;
    }
    place(segment, gap, left, right, choice);
    refill();
    out.placed += std::int64_t{choice.width} * choice.height;
    out.height = std::max(out.height, y + choice.height);
    out.width = std::max(out.width, spots_[at(choice.item)].x + choice.width);
  }
  out.all = waiting_count_ == 0;
  return out;
}

}  // namespace etak::rects
