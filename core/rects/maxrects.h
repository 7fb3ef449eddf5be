// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/rects/set.h"

namespace etak::rects {

/// Which free rectangle takes the next one.
enum class Fit { short_side, long_side, area, bottom_left, contact };
inline constexpr int fit_count = 5;
const char* name_of(Fit fit);

/// Maximal rectangles: the free space is the list of all largest free rectangles.
/// Based on
///   J. Jylanki, A thousand ways to pack the bin, 2010 (the list and the rules).
/// A new maximal rectangle lies inside one that was just cut, so it can only be contained in one that was
/// not cut and touches the same side of the box or in another new one on that side; those narrower or lower
/// than anything still to come are left out.
class MaxRects {
 public:
  MaxRects(const Set& set, bool rotate) : set_(set), rotate_(rotate) {}

  /// As Skyline::pack; without `partial` it stops at the first that does not fit.
  Outcome pack(int width, int height, std::span<const int> order, Fit fit, bool partial);
  const std::vector<Spot>& spots() const { return spots_; }

  /// For packing around what lies fixed: begin, occupy what is there, then insert.
  void begin(int width, int height, int least_width, int least_height);
  void occupy(int x, int y, int width, int height);
  bool insert(int width, int height, Fit fit, Spot& spot);

 private:
  struct Free {
    int x, y, right, top;
  };
  struct Found {
    int free = -1;
    int key = 0;
  };
  Found find(int width, int height, Fit fit) const;
  Found find_contact(int width, int height) const;
  void remember(const Free& box);
  int contact(const Free& box) const;
  void keep(int x, int y, int right, int top);

  const Set& set_;
  bool rotate_;
  std::vector<Spot> spots_;
  int page_width_ = 0, page_height_ = 0, key_bits_ = 0, area_shift_ = 0;
  int least_width_ = 1, least_height_ = 1;
  int count_ = 0;
  std::vector<int> x_, y_, right_, top_;  // of the free ones, padded with what nothing fits
  std::vector<int> scratch_;              // for what the last box cuts and touches
  mutable std::int64_t work_ = 0;
  // What lies, for the contact rule, with lists by the line its left, right, lower and upper side is on;
  // lines share slots.
  static constexpr std::size_t line_slots = 1024;
  struct Placed {
    Free box;
    int next_on_line[4];
  };
  std::vector<Placed> placed_;
  std::vector<int> first_on_line_[4];
  std::vector<int> least_after_;
};

}  // namespace etak::rects
