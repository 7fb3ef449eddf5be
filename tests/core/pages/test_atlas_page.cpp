// SPDX-License-Identifier: Apache-2.0
#include "core/pages/atlas_page.h"

#include <catch2/catch.hpp>

#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

AtlasRect rect(const std::string& name, int island, PixelBox crop, int x, int y) {
  AtlasRect out;
  out.name = name;
  out.island = island;
  out.crop = crop;
  out.x = x;
  out.y = y;
  out.width = crop.width;
  out.height = crop.height;
  out.source_width = out.source_height = 128;
  return out;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t out = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++out;
  return out;
}

}  // namespace

TEST_CASE("an atlas's page shows for each picture which of its parts are where") {
  AtlasPageData data;
  data.layout.pages.push_back({256, 256, {}});
  data.layout.rects = {rect("cut", 0, {0, 0, 32, 16}, 4, 8), rect("cut", 1, {64, 32, 16, 64}, 40, 8),
                       rect("same <cut>", 0, {0, 0, 32, 16}, 4, 8),
                       rect("same <cut>", 1, {64, 32, 16, 64}, 40, 8),
                       rect("whole", 0, {0, 0, 128, 128}, 100, 100)};
  for (const char* name : {"cut", "same <cut>", "whole"}) data.layout.materials.emplace_back().name = name;
  const auto maps = source_maps(data.layout);
  REQUIRE(maps.size() == 1);
  CHECK(maps[0].materials == "cut, same <cut>");
  CHECK(count(maps[0].svg, "<title>region ") == 2);
  CHECK(contains(maps[0].svg, "region 1: 16 x 64 at 64, 32 of the picture; page 0, 16 x 64 at 40, 8"));
  // 640 units are 128 texels.
  CHECK(contains(maps[0].svg, R"(x="320.00" y="160.00" width="80.00" height="320.00")"));
  const std::string page = atlas_page(data);
  CHECK(contains(page, "Where the regions come from"));
  CHECK(contains(page, "<figcaption>cut, same &lt;cut&gt;</figcaption>"));
  data.layout.rects.erase(data.layout.rects.begin(), data.layout.rects.begin() + 4);
  CHECK_FALSE(contains(atlas_page(data), "Where the regions come from"));
}
