// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/rects/set.h"

namespace etak::rects {

/// The rule by which a free rectangle is chosen for the next one.
enum class Fit { short_side, area, bottom_left, contact };
const char* name_of(Fit fit);

/// Free rectangles as columns, which are padded to whole lanes with empty ones.
struct FreeRects {
  int *x, *y, *right, *top;
  int count;
};

/// Maximal rectangles: the free space is the list of all largest free rectangles.
/// Based on
///   J. Jylanki, A thousand ways to pack the bin, 2010 (the list and the rules).
/// Placing a box cuts free rectangles. A new maximal rectangle lies inside one that was just cut, so only two
/// kinds of rectangles can contain it: uncut ones that touch the same side of the box, and other new ones on
/// that side. Free rectangles that are narrower or lower than all rectangles still to come are left out.
class MaxRects {
 public:
  MaxRects(const Set& set, bool rotate) : set_(set), rotate_(rotate) {}

  /// Packs as Skyline::pack does; without `partial` it stops at the first rectangle that does not fit.
  Outcome pack(int width, int height, std::span<const int> order, Fit fit, bool partial);
  const std::vector<Spot>& spots() const { return spots_; }

  /// For packing around rectangles that stay: begin(), occupy() for each of those, then insert().
  void begin(int width, int height, int least_width, int least_height);
  void occupy(int x, int y, int width, int height);
  bool insert(int width, int height, Fit fit, Spot& spot);

 private:
  struct Box {
    int x, y, right, top;
  };
  struct Found {
    int free = -1;
    int key = 0;
  };
  FreeRects free_rects() { return {x_.data(), y_.data(), right_.data(), top_.data(), count_}; }
  Found find(int width, int height, Fit fit);
  Found find_contact(int width, int height);
  void remember(const Box& box);
  int contact(const Box& box);
  void keep(int x, int y, int right, int top);

  const Set& set_;
  bool rotate_;
  std::vector<Spot> spots_;
  int page_width_ = 0, page_height_ = 0, key_bits_ = 0, area_shift_ = 0;
  int least_width_ = 1, least_height_ = 1;
  int count_ = 0;
  std::vector<int> x_, y_, right_, top_;  // of the free rectangles; the padding holds empty ones
  std::vector<int> scratch_;              // the rectangles that the last box cuts and touches
  std::int64_t work_ = 0;
  // The placed boxes, for the contact rule, in lists by the line of the left, right, lower and upper side;
  // several lines share a slot.
  static constexpr std::size_t line_slots = 1024;
  struct Placed {
    Box box;
    int next_on_line[4];
  };
  std::vector<Placed> placed_;
  std::vector<int> first_on_line_[4];
  std::vector<int> least_after_;
};

}  // namespace etak::rects
