// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/rii/axis_pages.h"

#include <catch2/catch.hpp>

using namespace etak;

TEST_CASE("a page and the reader of its axis take the same part of the file's name: the last one") {
  CHECK(axis_of_page("X/nk/Author-e-1.5-o.yml")->name == "ordinary");
  const auto pages = axis_pages("X/nk/Author-e-o-21C.yml");
  REQUIRE(pages.size() == 2);
  CHECK(pages[0].path == "X/nk/Author-e-o-21C.yml");
  CHECK(pages[1].path == "X/nk/Author-e-e-21C.yml");
  CHECK(pages[0].weight == 2 * pages[1].weight);
  CHECK(axis_pages("a-o/Author.yml").empty());
  CHECK(axis_of_page("o.yml") == nullptr);
}
