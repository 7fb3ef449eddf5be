// SPDX-License-Identifier: Apache-2.0
#include "core/rects/maxrects.h"

#include <algorithm>
#include <climits>

#include "core/rects/index.h"
#include "core/rects/lanes.h"

namespace etak::rects {
namespace {

struct Wanted {
  int width, height, key_bits, area_shift;
  Fit fit;
};

// Index and key of the free rectangle with the least key; -1 where none is large enough.
LANES_FUNCTION std::pair<int, int> least_key(const FreeRects& free, const Wanted& wanted) {
  const auto [xs, ys, rights, tops, count] = free;
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
  Lanes key = best;
  spread_least(key);
  where = best == key ? where : INT_MAX;
  spread_least(where);
  return {int{where[0]}, int{key[0]}};
}

// The first block from `from` on with a free rectangle that is large enough, and which of its lanes are; 0
// where there is none.
LANES_FUNCTION std::pair<int, unsigned> next_fitting(const FreeRects& free, int from, int width, int height) {
  const auto [xs, ys, rights, tops, count] = free;
  for (int i = from; i < count; i += lane_count) {
    Lanes x, y, right, top;
    std::memcpy(&x, xs + i, sizeof x);
    std::memcpy(&y, ys + i, sizeof y);
    std::memcpy(&right, rights + i, sizeof right);
    std::memcpy(&top, tops + i, sizeof top);
    const unsigned fits = lane_bits((right - x >= width) & (top - y >= height));
    if (fits != 0) return {i, fits};
  }
  return {count, 0};
}

// The pieces that remain of the cut rectangles on one side of the box, and the uncut rectangles that touch
// the line of that side. Only a touching rectangle can contain a piece, because the piece overlaps the box
// along the side and does not reach into it. The common line is not stored; `far` is the opposite end, with
// its sign such that the least number reaches furthest.
struct Side {
  int *far, *low, *high;
  int count;

  void add(int f, int l, int h) {
    far[count] = f;
    low[count] = l;
    high[count++] = h;
  }
  void pad() { std::fill_n(far + count, lane_count, INT_MAX); }
};

struct Cut {
  int x, y, right, top, least_width, least_height;
};

// Takes the rectangles that the box cuts out of the space (the last one fills the gap) and gathers their
// pieces and what touches the box, left, right, below and above of it.
LANES_FUNCTION void cut(FreeRects& space, const Cut& box, Side* pieces, Side* touching) {
  const auto [x, y, right, top, least_width, least_height] = box;
  int *const xs = space.x, *const ys = space.y, *const rights = space.right, *const tops = space.top;
  int count = space.count;
  for (int i = 0; i < count; i += lane_count) {
    unsigned meets = 0;
    for (;;) {
      Lanes fx, fy, fr, ft;
      std::memcpy(&fx, xs + i, sizeof fx);
      std::memcpy(&fy, ys + i, sizeof fy);
      std::memcpy(&fr, rights + i, sizeof fr);
      std::memcpy(&ft, tops + i, sizeof ft);
      meets = lane_bits((fx <= right) & (fr >= x) & (fy <= top) & (ft >= y));
      if (meets == 0) break;
      unsigned cuts = lane_bits((fx < right) & (fr > x) & (fy < top) & (ft > y));
      if (cuts == 0) break;
      while (cuts != 0) {
        const int lane = highest_lane(cuts), k = i + lane, last = --count;
        cuts ^= 1u << lane;
        const int kx = xs[k], ky = ys[k], kr = rights[k], kt = tops[k];
        xs[k] = xs[last];
        ys[k] = ys[last];
        rights[k] = rights[last];
        tops[k] = tops[last];
        xs[last] = ys[last] = INT_MAX / 2;
        rights[last] = tops[last] = -1;
        if (kt - ky >= least_height) {
          if (x > kx && x - kx >= least_width) pieces[0].add(kx, ky, kt);
          if (kr > right && kr - right >= least_width) pieces[1].add(-kr, ky, kt);
        }
        if (kr - kx >= least_width) {
          if (y > ky && y - ky >= least_height) pieces[2].add(ky, kx, kr);
          if (kt > top && kt - top >= least_height) pieces[3].add(-kt, kx, kr);
        }
      }
    }
    for (; meets != 0; meets &= meets - 1) {
      const int k = i + lowest_lane(meets);
      const int kx = xs[k], ky = ys[k], kr = rights[k], kt = tops[k];
      if (ky < top && kt > y) {
        if (kr == x) touching[0].add(kx, ky, kt);
        if (kx == right) touching[1].add(-kr, ky, kt);
      } else if (kx < right && kr > x) {
        if (kt == y) touching[2].add(ky, kx, kr);
        if (ky == top) touching[3].add(-kt, kx, kr);
      }
    }
  }
  space.count = count;
}

// The pieces that lie in no touching rectangle and in no other piece; of equal pieces the first.
LANES_FUNCTION int outermost(const Side& pieces, const Side& touching, int* out) {
  int count = 0;
  if (pieces.count == 1 && touching.count == 0) {
    out[0] = 0;
    return 1;
  }
  for (int i = 0; i < pieces.count; ++i) {
    const int far = pieces.far[i], low = pieces.low[i], high = pieces.high[i];
    Lanes inside = {}, here = {0, 1, 2, 3, 4, 5, 6, 7};
    for (int k = 0; k < touching.count; k += lane_count) {
      Lanes f, l, h;
      std::memcpy(&f, touching.far + k, sizeof f);
      std::memcpy(&l, touching.low + k, sizeof l);
      std::memcpy(&h, touching.high + k, sizeof h);
      inside |= (f <= far) & (l <= low) & (h >= high);
    }
    for (int k = 0; k < pieces.count; k += lane_count, here += lane_count) {
      Lanes f, l, h;
      std::memcpy(&f, pieces.far + k, sizeof f);
      std::memcpy(&l, pieces.low + k, sizeof l);
      std::memcpy(&h, pieces.high + k, sizeof h);
      const Lanes differs = (f != far) | (l != low) | (h != high);
      inside |= (f <= far) & (l <= low) & (h >= high) & (differs | (here < i));
    }
    if (lane_bits(inside) == 0) out[count++] = i;
  }
  return count;
}

}  // namespace

const char* name_of(Fit fit) {
  switch (fit) {
    case Fit::short_side:
      return "best short side";
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
  // Each rectangle leaves at most one piece on each side.
  const std::size_t room = x_.size() + lane_count;
  if (scratch_.size() < 25 * room) scratch_.resize(25 * room);
  Side pieces[4], touching[4];
  int* next = scratch_.data();
  const auto side = [&](Side& s) {
    s = {next, next + room, next + 2 * room, 0};
    next += 3 * room;
  };
  for (Side& s : pieces) side(s);
  for (Side& s : touching) side(s);

  FreeRects space = free_rects();
  cut(space, {x, y, right, top, least_width_, least_height_}, pieces, touching);
  count_ = space.count;
  const int old = count_;
  work_ += 50 + 2 * (old / lane_count);
  for (int k = 0; k < 4; ++k) {
    Side& s = pieces[k];
    if (s.count == 0) continue;
    work_ += std::int64_t{s.count} * (4 + s.count + old / lane_count);
    s.pad();
    touching[k].pad();
    const int kept = outermost(s, touching[k], next);
    for (int i = 0; i < kept; ++i) {
      const int far = s.far[next[i]], low = s.low[next[i]], high = s.high[next[i]];
      switch (k) {
        case 0:
          keep(far, low, x, high);
          break;
        case 1:
          keep(right, low, -far, high);
          break;
        case 2:
          keep(low, far, high, y);
          break;
        default:
          keep(low, top, high, -far);
          break;
      }
    }
  }
}

void MaxRects::remember(const Box& box) {
  const int lines[4] = {box.x, box.right, box.y, box.top};
  Placed placed{box, {}};
  for (std::size_t k = 0; k < 4; ++k) {
    int& first = first_on_line_[k][at(lines[k]) % line_slots];
    placed.next_on_line[k] = first;
    first = static_cast<int>(placed_.size());
  }
  placed_.push_back(placed);
}

// How much of the border of a box touches the border of the page and placed boxes: those whose opposite side
// is on the same line.
int MaxRects::contact(const Box& box) {
  int touch = 0;
  if (box.x == 0) touch += box.top - box.y;
  if (box.right == page_width_) touch += box.top - box.y;
  if (box.y == 0) touch += box.right - box.x;
  if (box.top == page_height_) touch += box.right - box.x;
  int steps = 10;
  const auto follow = [&](std::size_t k, int line, int Box::*side, int Box::*from, int Box::*to) {
    const Placed* const placed = placed_.data();
    for (int i = first_on_line_[k][at(line) % line_slots]; i >= 0; i = placed[i].next_on_line[k], ++steps) {
      const Box& other = placed[i].box;
      if (other.*side == line)
        touch += std::max(0, std::min(other.*to, box.*to) - std::max(other.*from, box.*from));
    }
  };
  follow(0, box.right, &Box::x, &Box::y, &Box::top);
  follow(1, box.x, &Box::right, &Box::y, &Box::top);
  follow(2, box.top, &Box::y, &Box::x, &Box::right);
  follow(3, box.y, &Box::top, &Box::x, &Box::right);
  work_ += 3 * steps;
  return touch;
}

MaxRects::Found MaxRects::find_contact(int width, int height) {
  Found best;
  for (int from = 0; from < count_; from += lane_count) {
    auto [block, fits] = next_fitting(free_rects(), from, width, height);
    from = block;
    for (; fits != 0; fits &= fits - 1) {
      const int i = block + lowest_lane(fits), x = x_[at(i)], y = y_[at(i)];
      const int touch = contact({x, y, x + width, y + height});
      if (best.free < 0 || -touch < best.key) best = {i, -touch};
    }
  }
  return best;
}

MaxRects::Found MaxRects::find(int width, int height, Fit fit) {
  work_ += 12 + 3 * (count_ / lane_count);
  if (fit == Fit::contact) return find_contact(width, height);
  const auto [index, key] = least_key(free_rects(), {width, height, key_bits_, area_shift_, fit});
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
  // The least width and height among the rectangles after each one: none of them fits into a smaller free
  // rectangle, so that is left out.
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
