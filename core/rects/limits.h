// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <climits>
#include <cstdint>
#include <string>
#include <vector>

#include "core/rects/portfolio.h"

namespace etak::rects {

// How much a search may cost, and the page sides that it tries.

/// The least multiple that is not below `value`; at most INT_MAX / 2.
int round_up(std::int64_t value, std::int64_t multiple);

/// How much may still be tried, counted in tries and in operations, so that it is the same on every machine.
/// Time counts only where it was asked for.
class Budget {
 public:
  ///   effort        tries at most; all of them together take at most `effort` times what one of ordinary
  ///                 cost takes
  ///   max_seconds   0: no clock
  Budget(int effort, int n, double max_seconds);
  void allow(int effort);  // begins again with this effort; the clock and the counts go on
  bool open();             // something is left
  void charge(std::int64_t work);
  bool would_end(int effort) const;  // nothing would be left of this effort
  int tries() const { return tries_; }
  bool cut() const { return cut_; }

 private:
  int n_, tries_left_ = 0, tries_ = 0;
  int allowed_ = 0;
  std::int64_t work_left_ = 0;
  bool timed_, cut_ = false;
  std::chrono::steady_clock::time_point end_;
};

/// The best layout on one page so far, in units.
struct Best {
  bool any = false;
  int width = 0, height = 0;  // extent
  std::vector<Spot> spots;
  std::string method;
};

/// Pages with one free side. In units of `unit` texels; page sides are rounded up to `multiple` texels.
struct Family {
  int width = 0;  // 0: squares
  int least = 1;  // no page with a smaller side holds the set
  int most = 0;   // the largest allowed
  int unit = 1, multiple = 1;
  int below = INT_MAX;  // larger sides are of no use

  int width_at(int side) const { return width > 0 ? width : side; }
  /// The largest side whose page is not larger than that of `side`.
  int full(int side) const;
  /// The largest side with a smaller page; may be below `least`.
  int smaller(int side) const;
};

/// The side of `best` in a family.
int side_of(const Family& family, const Best& best);

/// The least height of a page of that width: by the area, by the largest rectangle, and, without rotation,
/// by a number of which all sides are multiples.
int least_height(const Set& set, bool rotate, int width);
int least_square(const Set& set, bool rotate);
bool can_hold(const Set& set, bool rotate, int width, int height);

}  // namespace etak::rects
