// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/rects/maxrects.h"
#include "core/rects/skyline.h"

namespace etak::rects {

/// One way to pack: a placement rule and the order the rectangles are offered in.
struct Try {
  bool skyline = true;
  bool transposed = false;  // width and height swapped: builds from the left instead of from below
  SkylineRule rule;
  Fit fit = Fit::short_side;
  Key key = Key::area;
  std::string name() const;
};

/// So many rectangles have a portfolio of their own, of many cheap tries.
inline constexpr int most_few = 700;

/// The tries that are worth making for n rectangles, the most promising first.
std::vector<Try> portfolio(int n, bool rotate);

/// Every order and fit of MaxRects, from below and from the left.
std::vector<Try> every_max_rects();

}  // namespace etak::rects
