// SPDX-License-Identifier: Apache-2.0
#include "core/rects/rects.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <random>
#include <tuple>

#include "tests/core/rects/rects_support.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

bool power_of_two(int value) {
  return value > 0 && (value & (value - 1)) == 0;
}

}  // namespace

TEST_CASE("rectangles never overlap nor leave their page, for any form, rotation, alignment and multiple") {
  std::mt19937 random(20240711);
  int packed = 0;
  for (int round = 0; round < 500; ++round) {
    const Sizes sizes = random_sizes(random, below(random, 60));
    for (const PageForm form : forms) {
      RectOptions options = options_for(form, 256, round % 2 == 0, 1 + below(random, 12));
      if (round % 3 == 1) options.align = 4;
      if (round % 3 == 2) options.multiple = 4;
      const RectLayout layout = pack_rects(sizes, options);
      INFO("round " << round << ", form " << static_cast<int>(form) << ", " << layout.method);
      REQUIRE(painted_once(sizes, layout));
      REQUIRE(layout_fault(sizes, layout) == std::nullopt);
      REQUIRE(layout.pages.empty() == sizes.empty());
      for (const RectPlace& place : layout.places) {
        REQUIRE(place.x % options.align == 0);
        REQUIRE(place.y % options.align == 0);
        REQUIRE((options.rotate || !place.rotated));
      }
      for (const RectSize& page : layout.pages) {
        if (form != PageForm::strip) {
          REQUIRE(page.width % options.multiple == 0);
          REQUIRE(page.height % options.multiple == 0);
        }
        if (form == PageForm::square) REQUIRE(page.width == page.height);
        if (form == PageForm::strip) REQUIRE(page.width == 256);
        if (form == PageForm::pages) REQUIRE(page == RectSize{256, 256});
        if (form == PageForm::power_of_two || form == PageForm::mixed)
          REQUIRE((power_of_two(page.width) && power_of_two(page.height)));
        if (form == PageForm::mixed) REQUIRE(std::max(page.width, page.height) <= 256);
      }
      if (form != PageForm::pages && form != PageForm::mixed) REQUIRE(layout.pages.size() <= 1);
      ++packed;
    }
  }
  CHECK(packed == 3000);
}

TEST_CASE(
    "a layout does not depend on the order of the input, and equal sizes lie in the order of their indices") {
  std::mt19937 random(7);
  for (int round = 0; round < 40; ++round) {
    const Sizes sizes = random_sizes(random, 5 + below(random, 80));
    std::vector<std::size_t> order(sizes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), random);
    Sizes shuffled;
    for (const std::size_t i : order) shuffled.push_back(sizes[i]);
    for (const PageForm form : forms) {
      const RectOptions options = options_for(form, 256, round % 2 == 0);
      const RectLayout a = pack_rects(sizes, options), b = pack_rects(shuffled, options);
      REQUIRE(a.pages == b.pages);
      REQUIRE(a.method == b.method);
      using Row = std::tuple<int, int, int, int, int, bool>;
      const auto rows = [](const Sizes& s, const RectLayout& layout) {
        std::vector<Row> out;
        for (std::size_t i = 0; i < s.size(); ++i) {
          const RectPlace& p = layout.places[i];
          out.push_back({s[i].width, s[i].height, p.page, p.x, p.y, p.rotated});
        }
        std::sort(out.begin(), out.end());
        return out;
      };
      REQUIRE(rows(sizes, a) == rows(shuffled, b));
      for (std::size_t i = 0; i < sizes.size(); ++i)
        for (std::size_t k = i + 1; k < sizes.size(); ++k)
          if (sizes[i] == sizes[k]) {
            const RectPlace &p = a.places[i], &q = a.places[k];
            REQUIRE(std::tie(p.page, p.y, p.x) < std::tie(q.page, q.y, q.x));
          }
    }
  }
}

TEST_CASE("threads and a second run give the same layout") {
  std::mt19937 random(11);
  for (const int n : {40, 300, 900}) {
    Sizes sizes;
    for (int i = 0; i < n; ++i) sizes.push_back({4 + below(random, 90), 4 + below(random, 90)});
    for (const PageForm form : forms)
      for (const bool rotate : {false, true}) {
        RectOptions options = options_for(form, 512, rotate, n > 500 ? 10 : 60);
        const RectLayout one = pack_rects(sizes, options);
        CHECK(pack_rects(sizes, options).places == one.places);
        for (const unsigned threads : {2u, 3u}) {
          options.threads = threads;
          const RectLayout many = pack_rects(sizes, options);
          CHECK(many.places == one.places);
          CHECK(many.pages == one.pages);
          CHECK(many.tries == one.tries);
          CHECK(many.method == one.method);
        }
      }
  }
}

TEST_CASE("rotation never makes a layout larger") {
  std::mt19937 random(3);
  for (int round = 0; round < 60; ++round) {
    const Sizes sizes = random_sizes(random, 1 + below(random, 70));
    for (const PageForm form : forms) {
      const RectLayout upright = pack_rects(sizes, options_for(form, 256, false));
      const RectLayout turned = pack_rects(sizes, options_for(form, 256, true));
      INFO("round " << round << ", form " << static_cast<int>(form));
      REQUIRE(turned.page_texels() <= upright.page_texels());
    }
  }
}

TEST_CASE("degenerate sets are packed exactly") {
  const auto page = [](const Sizes& sizes, PageForm form, int side = 0, bool rotate = false) {
    const RectLayout layout = pack_rects(sizes, options_for(form, side, rotate));
    REQUIRE(layout_fault(sizes, layout) == std::nullopt);
    REQUIRE(layout.pages.size() == 1);
    return layout.pages[0];
  };
  for (const PageForm form : forms) {
    const RectLayout none = pack_rects({}, options_for(form, 64, true));
    CHECK(none.pages.empty());
    CHECK(none.places.empty());
    CHECK(none.page_texels() == 0);
  }
  CHECK(page({{1, 1}}, PageForm::square) == RectSize{1, 1});
  CHECK(page({{1, 1}}, PageForm::power_of_two) == RectSize{1, 1});
  CHECK(page({{1, 1}}, PageForm::mixed, 64) == RectSize{1, 1});
  CHECK(page({{1, 1}}, PageForm::strip, 7) == RectSize{7, 1});
  CHECK(page({{1, 16384}}, PageForm::free) == RectSize{1, 16384});
  CHECK(page({{16384, 16384}}, PageForm::power_of_two) == RectSize{16384, 16384});
  CHECK(page({{100, 3}}, PageForm::strip, 3, true) == RectSize{3, 100});
  CHECK(page({{5, 7}, {5, 7}}, PageForm::square) == RectSize{10, 10});
  CHECK(page(Sizes(100, {7, 7}), PageForm::square) == RectSize{70, 70});
  CHECK(page(Sizes(64, {32, 32}), PageForm::power_of_two) == RectSize{256, 256});
  CHECK(page(Sizes(50, {1, 20}), PageForm::strip, 50) == RectSize{50, 20});
  CHECK(page(Sizes(12, {30, 20}), PageForm::free).width * page(Sizes(12, {30, 20}), PageForm::free).height ==
        7200);
  CHECK(pack_rects(Sizes(5, {64, 64}), options_for(PageForm::pages, 128, false)).pages.size() == 2);
}

TEST_CASE("the cheapest mix of power-of-two pages beats one power of two") {
  // Five quarters of a 128 x 128 page: 256 x 128 as one page, 128 x 128 and 64 x 64 as a mix.
  const Sizes sizes(5, {64, 64});
  const RectLayout mix = pack_rects(sizes, options_for(PageForm::mixed, 128, false));
  CHECK(mix.page_texels() == 5u * 64 * 64);
  CHECK(pack_rects(sizes, options_for(PageForm::power_of_two, 0, false)).page_texels() == 8u * 64 * 64);
}

TEST_CASE("sides that are multiples of four are the least such sides") {
  RectOptions options = options_for(PageForm::square, 0, false);
  options.multiple = 4;
  CHECK(pack_rects(Sizes{{5, 7}}, options).pages[0] == RectSize{8, 8});
  CHECK(pack_rects(Sizes{{9, 3}, {9, 6}}, options).pages[0] == RectSize{12, 12});
  options.form = PageForm::free;
  CHECK(pack_rects(Sizes{{5, 7}}, options).pages[0] == RectSize{8, 8});
}

TEST_CASE("what cannot be packed is refused by name") {
  const auto error = [](const Sizes& sizes, RectOptions options) {
    return test::error_of([&] { pack_rects(sizes, options); });
  };
  const RectOptions free = options_for(PageForm::free, 0, false);
  CHECK(test::contains(error({{4, 4}, {0, 3}}, free), "rectangle 2: 0 x 3; expected sides of 1 to 16384"));
  CHECK(test::contains(error({{16385, 1}}, free), "rectangle 1: 16385 x 1"));
  CHECK(test::contains(error({{9, 4}}, options_for(PageForm::strip, 8, false)),
                       "at most as wide as the strip, 8"));
  CHECK(error({{9, 4}}, options_for(PageForm::strip, 8, true)).empty());
  CHECK(test::contains(error({{65, 4}}, options_for(PageForm::pages, 64, true)), "64 x 64"));
  CHECK(test::contains(error({{65, 4}}, options_for(PageForm::mixed, 100, true)), "64 x 64"));
  CHECK(test::contains(error({{1, 1}}, options_for(PageForm::strip, 0, false)), "page side: 0"));
  RectOptions small = free;
  small.largest_side = 10;
  CHECK(test::contains(error(Sizes(5, {6, 6}), small), "do not fit one page of at most 10 x 10"));
  for (const PageForm form : {PageForm::square, PageForm::power_of_two}) {
    small.form = form;
    CHECK_FALSE(error(Sizes(5, {6, 6}), small).empty());
  }
  RectOptions odd = options_for(PageForm::power_of_two, 0, false);
  odd.multiple = 6;
  CHECK(test::contains(error({{1, 1}}, odd), "multiple: 6"));
  RectOptions none = free;
  none.effort = 0;
  CHECK(test::contains(error({{1, 1}}, none), "effort: 0"));
}
