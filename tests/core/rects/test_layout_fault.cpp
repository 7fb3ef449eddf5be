// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <random>

#include "core/rects/rects.h"
#include "tests/core/rects/rects_support.h"

using namespace etak;
using namespace etak::test;

TEST_CASE("the checker of layouts finds planted faults") {
  const Sizes sizes = {{4, 2}, {4, 2}, {2, 4}};
  RectLayout layout;
  layout.pages = {{8, 8}};
  layout.places = {{0, 0, 0, false}, {0, 4, 0, false}, {0, 0, 2, true}};
  CHECK(layout_fault(sizes, layout) == std::nullopt);
  const auto fault = [&](auto change) {
    RectLayout copy = layout;
    change(copy);
    return layout_fault(sizes, copy).value_or("none");
  };
  CHECK(fault([](RectLayout& l) { l.places[1].x = 3; }) == "rectangles 1 and 2 overlap");
  CHECK(fault([](RectLayout& l) { l.places[2] = {0, 2, 1, false}; }) != "none");
  CHECK(fault([](RectLayout& l) { l.places[1].x = 5; }) == "rectangle 2 lies outside of its page");
  CHECK(fault([](RectLayout& l) { l.places[0].y = -1; }) == "rectangle 1 lies outside of its page");
  CHECK(fault([](RectLayout& l) { l.places[0].page = 1; }) == "rectangle 1 is on page 1 of 1");
  CHECK(fault([](RectLayout& l) { l.places.pop_back(); }) == "2 places for 3 rectangles");
}

TEST_CASE("the checker of layouts agrees with painting on random places") {
  std::mt19937 random(17);
  int sound = 0;
  for (int round = 0; round < 4000; ++round) {
    const Sizes sizes = random_sizes(random, 1 + below(random, 5));
    RectLayout layout;
    layout.pages = {{90, 90}, {40, 90}};
    for (std::size_t i = 0; i < sizes.size(); ++i)
      layout.places.push_back({below(random, 2), below(random, 80), below(random, 80), random() % 2 == 0});
    const bool clean = painted_once(sizes, layout);
    REQUIRE(layout_fault(sizes, layout).has_value() == !clean);
    sound += clean ? 1 : 0;
  }
  CHECK(sound > 200);
}
