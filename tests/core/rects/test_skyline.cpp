// SPDX-License-Identifier: Apache-2.0
// The best-fit skyline by itself, without the search around it.
#include <catch2/catch.hpp>
#include <numeric>

#include "core/rects/skyline.h"

namespace etak::rects {

TEST_CASE("the lowest gap takes the box of its width, though others come before it") {
  const Set set({{6, 4}, {3, 5}, {4, 4}});
  const std::vector<int> order = {0, 1, 2};
  Skyline rule(set, false);
  const Outcome outcome = rule.pack(10, 9, order, {}, true);
  CHECK(outcome.all);
  CHECK((rule.spots()[0].y == 0 && rule.spots()[2].y == 0));
  CHECK(rule.spots()[1].y == 4);
}

TEST_CASE("a window of one keeps the order") {
  const Set set({{6, 4}, {3, 5}, {4, 4}});
  const std::vector<int> order = {0, 1, 2};
  SkylineRule rule;
  rule.window = 1;
  Skyline skyline(set, false);
  skyline.pack(10, 9, order, rule, true);
  CHECK(skyline.placed()[1] == 1);
}

TEST_CASE("a whole try ends when more area is lost than the page can spare") {
  const Set set({{7, 5}, {7, 5}});
  const std::vector<int> order = {0, 1};
  Skyline rule(set, false);
  CHECK(!rule.pack(10, 8, order, {}, false).all);
  CHECK(rule.pack(10, 10, order, {}, false).all);
}

TEST_CASE("a page takes from the offer what the page before it left") {
  const Set set({{4, 4}, {4, 4}, {4, 4}});
  const std::vector<int> order = {0, 1, 2};
  Skyline rule(set, false);
  rule.offer(order, {});
  CHECK(rule.fill(8, 4).placed == 32);
  const Outcome rest = rule.fill(8, 4);
  CHECK(rest.placed == 16);
  CHECK(rest.all);
}

}  // namespace etak::rects
