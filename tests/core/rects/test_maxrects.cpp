// SPDX-License-Identifier: Apache-2.0
// Maximal rectangles by themselves, without the search around them.
#include <catch2/catch.hpp>
#include <numeric>

#include "core/rects/maxrects.h"

namespace etak::rects {

namespace {

std::vector<int> all_of(const Set& set) {
  std::vector<int> out(set.items.size());
  std::iota(out.begin(), out.end(), 0);
  return out;
}

}  // namespace

TEST_CASE("every rule of maximal rectangles fills a page that four equal boxes fill") {
  const Set set({{5, 3}, {5, 3}, {5, 3}, {5, 3}});
  for (const Fit fit : {Fit::short_side, Fit::area, Fit::bottom_left, Fit::contact}) {
    MaxRects rule(set, false);
    const Outcome outcome = rule.pack(10, 6, all_of(set), fit, false);
    INFO(name_of(fit));
    CHECK(outcome.all);
    CHECK(outcome.placed == 60);
    CHECK((outcome.width == 10 && outcome.height == 6));
  }
}

TEST_CASE("what does not fit ends a whole try and is left out of a partial one") {
  const Set set({{8, 8}, {6, 6}, {2, 2}});
  MaxRects rule(set, false);
  CHECK(rule.pack(8, 10, all_of(set), Fit::short_side, false).placed == 64);
  const Outcome partial = rule.pack(8, 10, all_of(set), Fit::short_side, true);
  CHECK(!partial.all);
  CHECK(partial.placed == 68);
  CHECK(rule.spots()[1].x == -1);
}

TEST_CASE("a box is turned where only that makes it fit, and only where that is allowed") {
  const Set set({{9, 2}});
  CHECK(!MaxRects(set, false).pack(3, 9, all_of(set), Fit::area, false).all);
  MaxRects rule(set, true);
  CHECK(rule.pack(3, 9, all_of(set), Fit::area, false).all);
  CHECK(rule.spots()[0].rotated);
}

TEST_CASE("boxes go around occupied ones") {
  const Set none;
  MaxRects space(none, false);
  space.begin(10, 10, 1, 1);
  space.occupy(3, 0, 4, 10);
  Spot spot;
  CHECK(!space.insert(4, 4, Fit::short_side, spot));
  REQUIRE(space.insert(3, 10, Fit::short_side, spot));
  CHECK((spot.x == 0 || spot.x == 7));
  const int first = spot.x;
  REQUIRE(space.insert(3, 10, Fit::short_side, spot));
  CHECK(spot.x == 7 - first);
  CHECK(!space.insert(1, 1, Fit::short_side, spot));
}

}  // namespace etak::rects
