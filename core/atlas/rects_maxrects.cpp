// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/rects_maxrects.h"

#include <algorithm>
#include <climits>

#include "core/atlas/rects_lanes.h"

namespace etak::rects {
namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

struct Wanted {
  int width, height, key_bits, area_shift;
  Fit fit;
};

// Index and key of the free rectangle with the least key; -1 where none is large enough.
LANES_FUNCTION std::pair<int, int> least_key(const int* xs, const int* ys, const int* rights, const int* tops,
                                             int count, const Wanted& wanted) {
  Lanes best = {}, where = {}, here = {0, 1, 2, 3, 4, 5, 6, 7};
  best += INT_MAX;
  const int bits = wanted.key_bits, most = (1 << bits) - 1;
  for (int i = 0; i < count; i += lane_count, here += lane_count) {
    Lanes x, y, right, top;
    std::memcpy(&x, xs + i, sizeof x);
    std::memcpy(&y, ys + i, sizeof y);
    std::memcpy(&right, rights + i, sizeof right);
    std::memcpy(&top, tops + i, sizeof top);
    Lanes dx = right - x - wanted.width, dy = top - y - wanted.height;
    const Lanes fits = (dx >= 0) & (dy >= 0);
    dx = fits ? dx : 0;
    dy = fits ? dy : 0;
    Lanes first, second = {};
    int shift = bits;
    switch (wanted.fit) {
      case Fit::short_side:
        first = dx < dy ? dx : dy;
        second = dx < dy ? dy : dx;
        break;
      case Fit::long_side:
        first = dx < dy ? dy : dx;
        second = dx < dy ? dx : dy;
        break;
      case Fit::area:
        first = (dx + wanted.width) * ((dy + wanted.height) >> wanted.area_shift) -
                wanted.width * (wanted.height >> wanted.area_shift);
        shift = 0;
        break;
      default:
        first = y + wanted.height;
        second = x;
        break;
    }
    first = first > (INT_MAX >> (shift + 1)) ? INT_MAX >> (shift + 1) : first;
    second = second > most ? most : second;
    const Lanes key = fits ? (first << shift) + second : INT_MAX;
    where = key < best ? here : where;
    best = key < best ? key : best;
  }
  int key = INT_MAX, index = -1;
  for (int k = 0; k < lane_count; ++k)
    if (best[k] < key || (best[k] == key && key < INT_MAX && where[k] < index)) {
      key = best[k];
      index = where[k];
    }
  return {index, key};
}

// The first free rectangle from `from` on (a multiple of the lane count) whose block of lanes holds one that
// the box cuts; count where none does.
LANES_FUNCTION int next_cut(const int* xs, const int* ys, const int* rights, const int* tops, int from,
                            int count, int x, int y, int right, int top) {
  for (int i = from; i < count; i += lane_count) {
    Lanes fx, fy, fr, ft;
    std::memcpy(&fx, xs + i, sizeof fx);
    std::memcpy(&fy, ys + i, sizeof fy);
    std::memcpy(&fr, rights + i, sizeof fr);
    std::memcpy(&ft, tops + i, sizeof ft);
    const Lanes cut = (fx < right) & (fr > x) & (fy < top) & (ft > y);
    long long any[4];
    std::memcpy(any, &cut, sizeof any);
    if (any[0] | any[1] | any[2] | any[3]) return i;
  }
  return count;
}

LANES_FUNCTION bool contained(const int* xs, const int* ys, const int* rights, const int* tops, int count,
                              int x, int y, int right, int top) {
  for (int i = 0; i < count; i += lane_count) {
    Lanes fx, fy, fr, ft;
    std::memcpy(&fx, xs + i, sizeof fx);
    std::memcpy(&fy, ys + i, sizeof fy);
    std::memcpy(&fr, rights + i, sizeof fr);
    std::memcpy(&ft, tops + i, sizeof ft);
    const Lanes in = (fx <= x) & (fy <= y) & (fr >= right) & (ft >= top);
    long long any[4];
    std::memcpy(any, &in, sizeof any);
    if (any[0] | any[1] | any[2] | any[3]) return true;
  }
  return false;
}

}  // namespace

const char* name_of(Fit fit) {
  switch (fit) {
    case Fit::short_side:
      return "best short side";
    case Fit::long_side:
      return "best long side";
    case Fit::area:
      return "best area";
    case Fit::bottom_left:
      return "bottom left";
    case Fit::contact:
      return "contact";
  }
  return "";
}

void MaxRects::begin(int width, int height, int least_width, int least_height) {
  page_width_ = width;
  page_height_ = height;
  least_width_ = least_width;
  least_height_ = least_height;
  int bits = 1;
  while (std::max(width, height) >> bits) ++bits;
  key_bits_ = std::min(30 - bits, bits);
  key_bits_ = std::max(1, key_bits_);
  area_shift_ = 0;
  while ((std::int64_t{width} * (height >> area_shift_)) >> 31) ++area_shift_;
  count_ = 0;
  x_.clear();
  y_.clear();
  right_.clear();
  top_.clear();
  if (!placed_.empty() || first_on_line_[0].empty())
    for (auto& lines : first_on_line_) lines.assign(line_slots, -1);
  placed_.clear();
  next_on_line_.clear();
  keep(0, 0, width, height);
}

void MaxRects::keep(int x, int y, int right, int top) {
  if (at(count_) == x_.size()) {
    const std::size_t room = x_.size() + 8 * lane_count;
    x_.resize(room, INT_MAX / 2);
    y_.resize(room, INT_MAX / 2);
    right_.resize(room, -1);
    top_.resize(room, -1);
  }
  x_[at(count_)] = x;
  y_[at(count_)] = y;
  right_[at(count_)] = right;
  top_[at(count_++)] = top;
}

void MaxRects::occupy(int x, int y, int width, int height) {
  const int right = x + width, top = y + height;
  for (auto& side : fresh_) side.clear();
  const auto offer = [&](std::size_t side, int fx, int fy, int fr, int ft) {
    if (fr - fx >= least_width_ && ft - fy >= least_height_) fresh_[side].push_back({fx, fy, fr, ft});
  };
  int i = 0;
  while ((i = next_cut(x_.data(), y_.data(), right_.data(), top_.data(), i, count_, x, y, right, top)) <
         count_) {
    for (int k = std::min(i + lane_count, count_) - 1; k >= i; --k) {
      const Free f{x_[at(k)], y_[at(k)], right_[at(k)], top_[at(k)]};
      if (f.x >= right || f.right <= x || f.y >= top || f.top <= y) continue;
      const int last = --count_;
      x_[at(k)] = x_[at(last)];
      y_[at(k)] = y_[at(last)];
      right_[at(k)] = right_[at(last)];
      top_[at(k)] = top_[at(last)];
      x_[at(last)] = y_[at(last)] = INT_MAX / 2;
      right_[at(last)] = top_[at(last)] = -1;
      if (f.x < x) offer(0, f.x, f.y, x, f.top);
      if (f.right > right) offer(1, right, f.y, f.right, f.top);
      if (f.y < y) offer(2, f.x, f.y, f.right, y);
      if (f.top > top) offer(3, f.x, top, f.right, f.top);
    }
  }
  add_new();
}

// A part left of the box can lie only inside another part left of it (those above and below begin behind it),
// and so on for the other sides.
void MaxRects::add_new() {
  const int old = count_;
  work_ += 50 + 2 * (old / lane_count);
  for (const std::vector<Free>& side : fresh_) {
    const auto fresh = static_cast<std::int64_t>(side.size());
    work_ += fresh * (4 + fresh + old / lane_count);
    for (std::size_t i = 0; i < side.size(); ++i) {
      const Free f = side[i];
      bool inside = false;
      for (std::size_t k = 0; k < side.size() && !inside; ++k) {
        const Free& o = side[k];
        if (o.x > f.x || o.y > f.y || o.right < f.right || o.top < f.top || k == i) continue;
        const bool same = o.x == f.x && o.y == f.y && o.right == f.right && o.top == f.top;
        inside = !same || k < i;  // of equal ones the first stays
      }
      if (inside) continue;
      if (contained(x_.data(), y_.data(), right_.data(), top_.data(), old, f.x, f.y, f.right, f.top))
        continue;
      keep(f.x, f.y, f.right, f.top);
    }
  }
}

void MaxRects::remember(const Free& box) {
  const int lines[4] = {box.x, box.right, box.y, box.top};
  std::array<int, 4> next;
  for (std::size_t k = 0; k < 4; ++k) {
    int& first = first_on_line_[k][at(lines[k]) % line_slots];
    next[k] = first;
    first = static_cast<int>(placed_.size());
  }
  placed_.push_back(box);
  next_on_line_.push_back(next);
}

// How much of the border of a box lies against the page and the boxes placed: those whose opposite side is on
// the same line.
int MaxRects::contact(const Free& box) const {
  int touch = 0;
  if (box.x == 0) touch += box.top - box.y;
  if (box.right == page_width_) touch += box.top - box.y;
  if (box.y == 0) touch += box.right - box.x;
  if (box.top == page_height_) touch += box.right - box.x;
  int steps = 10;
  const auto follow = [&](std::size_t k, int line, int Free::*side, int Free::*from, int Free::*to) {
    for (int i = first_on_line_[k][at(line) % line_slots]; i >= 0; i = next_on_line_[at(i)][k], ++steps) {
      const Free& other = placed_[at(i)];
      if (other.*side == line)
        touch += std::max(0, std::min(other.*to, box.*to) - std::max(other.*from, box.*from));
    }
  };
  follow(0, box.right, &Free::x, &Free::y, &Free::top);
  follow(1, box.x, &Free::right, &Free::y, &Free::top);
  follow(2, box.top, &Free::y, &Free::x, &Free::right);
  follow(3, box.y, &Free::top, &Free::x, &Free::right);
  work_ += 3 * steps;
  return touch;
}

MaxRects::Found MaxRects::find_contact(int width, int height) const {
  Found best;
  for (int i = 0; i < count_; ++i) {
    const int x = x_[at(i)], y = y_[at(i)], right = x + width, top = y + height;
    if (right > right_[at(i)] || top > top_[at(i)]) continue;
    const int touch = contact({x, y, right, top});
    if (best.free < 0 || -touch < best.key) best = {i, -touch};
  }
  return best;
}

MaxRects::Found MaxRects::find(int width, int height, Fit fit) const {
  work_ += 12 + 3 * (count_ / lane_count);
  if (fit == Fit::contact) return find_contact(width, height);
  const auto [index, key] = least_key(x_.data(), y_.data(), right_.data(), top_.data(), count_,
                                      {width, height, key_bits_, area_shift_, fit});
  return {key == INT_MAX ? -1 : index, key};
}

bool MaxRects::insert(int width, int height, Fit fit, Spot& spot) {
  Found found = find(width, height, fit);
  bool turned = false;
  if (rotate_ && width != height) {
    const Found other = find(height, width, fit);
    if (other.free >= 0 && (found.free < 0 || other.key < found.key)) {
      found = other;
      turned = true;
    }
  }
  if (found.free < 0) return false;
  spot = {x_[at(found.free)], y_[at(found.free)], turned};
  const int w = turned ? height : width, h = turned ? width : height;
  if (fit == Fit::contact) remember({spot.x, spot.y, spot.x + w, spot.y + h});
  occupy(spot.x, spot.y, w, h);
  return true;
}

Outcome MaxRects::pack(int width, int height, std::span<const int> order, Fit fit, bool partial) {
  Outcome out;
  spots_.assign(set_.items.size(), {-1, 0, false});
  // Least width and height among those after each, to leave out free rectangles that none of them fits.
  const std::size_t n = order.size();
  least_after_.resize(2 * n + 2);
  int* const least_w = least_after_.data();
  int* const least_h = least_w + n + 1;
  least_w[n] = least_h[n] = INT_MAX;
  for (std::size_t k = n; k-- > 0;) {
    const RectSize& size = set_.items[at(order[k])];
    const int shorter = std::min(size.width, size.height);
    least_w[k] = std::min(least_w[k + 1], rotate_ ? shorter : size.width);
    least_h[k] = std::min(least_h[k + 1], rotate_ ? shorter : size.height);
  }
  begin(width, height, 1, 1);
  work_ = 10 * static_cast<std::int64_t>(n);
  out.all = true;
  for (std::size_t k = 0; k < n; ++k) {
    const RectSize& size = set_.items[at(order[k])];
    least_width_ = least_w[k + 1];
    least_height_ = least_h[k + 1];
    Spot& spot = spots_[at(order[k])];
    if (!insert(size.width, size.height, fit, spot)) {
      out.all = false;
      if (!partial) break;
      continue;
    }
    const int w = spot.rotated ? size.height : size.width, h = spot.rotated ? size.width : size.height;
    out.placed += std::int64_t{w} * h;
    out.width = std::max(out.width, spot.x + w);
    out.height = std::max(out.height, spot.y + h);
  }
  out.work = work_;
  return out;
}

}  // namespace etak::rects
