// SPDX-License-Identifier: Apache-2.0
// Packing beside the layout of an earlier run.
#include <catch2/catch.hpp>
#include <random>

#include "core/rects/rects.h"
#include "tests/core/rects/rects_support.h"

using namespace etak;
using namespace etak::test;

TEST_CASE("with the previous layout removing a rectangle never enlarges, and what stays stays where it was") {
  std::mt19937 random(5);
  for (int round = 0; round < 30; ++round) {
    for (const PageForm form : forms) {
      Sizes sizes = random_sizes(random, 20 + below(random, 40));
      const RectOptions options = options_for(form, 256, round % 2 == 0);
      RectLayout layout = pack_rects(sizes, options);
      while (sizes.size() > 1) {
        const auto gone = static_cast<std::ptrdiff_t>(random() % sizes.size());
        PreviousRects previous{layout.pages, {}, 0.05};
        for (const RectPlace& place : layout.places) previous.places.push_back(place);
        sizes.erase(sizes.begin() + gone);
        previous.places.erase(previous.places.begin() + gone);
        RectLayout next = pack_rects(sizes, options, &previous);
        INFO("round " << round << ", form " << static_cast<int>(form) << ", " << sizes.size() << " left");
        REQUIRE(next.page_texels() <= layout.page_texels());
        REQUIRE(layout_fault(sizes, next) == std::nullopt);
        if (next.kept_previous && next.pages.size() == layout.pages.size()) REQUIRE(next.moved == 0);
        layout = std::move(next);
        if (random() % 4 == 0) break;
      }
    }
  }
}

TEST_CASE(
    "a new rectangle goes into a gap or a slightly larger page; others stay within the stated share of area") {
  std::mt19937 random(9);
  int kept = 0, fresh = 0;
  for (int round = 0; round < 30; ++round)
    for (const PageForm form : forms) {
      Sizes sizes = random_sizes(random, 30 + below(random, 30));
      const RectOptions options = options_for(form, 256, round % 2 == 0);
      const RectLayout before = pack_rects(sizes, options);
      PreviousRects previous{before.pages, {}, 0.10};
      for (const RectPlace& place : before.places) previous.places.push_back(place);
      sizes.push_back({1 + below(random, 12), 1 + below(random, 12)});
      previous.places.push_back(std::nullopt);
      const RectLayout after = pack_rects(sizes, options, &previous);
      const RectLayout alone = pack_rects(sizes, options);
      REQUIRE(layout_fault(sizes, after) == std::nullopt);
      REQUIRE(static_cast<double>(after.page_texels()) <= 1.10 * static_cast<double>(alone.page_texels()));
      (after.kept_previous ? kept : fresh) += 1;
      if (!after.kept_previous) continue;
      CHECK(after.moved == 0);
      for (std::size_t i = 0; i + 1 < sizes.size(); ++i) REQUIRE(after.places[i] == before.places[i]);
    }
  CHECK(kept > fresh);
}

TEST_CASE("a previous layout that is not one is not kept") {
  const Sizes sizes = {{10, 10}, {10, 10}};
  PreviousRects previous{{{20, 10}}, {RectPlace{0, 0, 0, false}, RectPlace{0, 5, 0, false}}, 1.0};
  const RectLayout layout = pack_rects(sizes, options_for(PageForm::free, 0, false), &previous);
  CHECK_FALSE(layout.kept_previous);
  CHECK(layout_fault(sizes, layout) == std::nullopt);
  CHECK(layout.moved >= 1);
}
