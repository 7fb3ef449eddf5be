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

TEST_CASE("an atlas's page has a table of blocks and shows where they change materials most") {
  AtlasPageData data;
  data.layout.pages.push_back({256, 256, {}});
  CHECK_FALSE(contains(atlas_page(data), "What compression changed"));
  BlockLevel level;
  level.tried = level.format = "BC7";
  level.bytes = level.texels = 65536;
  level.materials.push_back({0, "a <b>", 0.5, 2.25, 8, 53400, true, BlockShaded{1.5, 3.5, 0.02}});
  level.materials.push_back({1, "c", 1.25, 2, 0, 0, false, {}});
  data.blocks = {level, level, level};
  data.blocks[1].level = 1;
  data.blocks[1].bytes = 16384;
  data.blocks[2].texture = Texture::specular_gloss;
  data.blocks[2].format = "RGBA8";
  data.blocks[2].fallback = true;
  CHECK_FALSE(contains(atlas_page(data), "Where it shows"));
  data.block_pictures.push_back(
      {0, "a <b>", {1.5, 3.5, 0.02}, 8, 4, 40, Image8(3, 2, 3), Image8(3, 2, 3), Image8(3, 2, 3)});
  const std::string page = atlas_page(data);
  CHECK(contains(page, "page 0 diffuse_alpha: BC7, 8 bits a texel, 81,920 bytes with its mips</th>"));
  CHECK(contains(page, "errors are those of BC7, which was not kept"));
  CHECK(contains(
      page,
      "<th>a &lt;b&gt;</th><td class=\"num\">0.5</td><td class=\"num\">2.25</td><td class=\"num\">8</td>"
      "<td class=\"num\">53,400</td><td class=\"num\">1.5</td><td class=\"num\">3.5</td>"
      "<td class=\"num\">0.02</td><td>kept</td>"));
  CHECK(count(page, ">not told</td>") == 1);
  CHECK(count(page, ">exact</td>") == 1);
  CHECK(count(page, ">missed</td>") == 2);
  CHECK(count(page, "src=\"data:image/png;base64,") == 3);
  CHECK(contains(page, "white where dE2000 is 4 or more"));
  CHECK(contains(page, "3 x 2 texels at 8, 4 of page 0, seen 40 degrees from the normal"));
}
