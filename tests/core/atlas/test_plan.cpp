// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "core/atlas/plan.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

std::vector<std::string> region_names(std::size_t count) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < count; ++i) out.push_back("m" + std::to_string(i));
  return out;
}

Region region(std::size_t material, int width, int height) {
  return {material, {0, 0, width, height}, {true, true}, false};
}

PlanOptions plan_options(int side) {
  PlanOptions out;
  out.rects.form = PageForm::mixed;
  out.rects.side = out.rects.largest_side = side;
  return out;
}

// No two cells share a texel, none leaves its page, each region and its gutter lie in their cell.
std::string fault_of(const PackingPlan& plan, const std::vector<Region>& regions) {
  for (std::size_t p = 0; p < plan.pages.size(); ++p) {
    const PlannedPage& page = plan.pages[p];
    std::vector<bool> taken(static_cast<std::size_t>(page.width) * static_cast<std::size_t>(page.height));
    for (std::size_t i = 0; i < regions.size(); ++i) {
      const PlannedPlace& at = plan.places[i];
      if (at.page != static_cast<int>(p)) continue;
      const PixelBox& box = regions[i].box;
      const int width = at.rotated ? box.height : box.width, height = at.rotated ? box.width : box.height;
      const PixelBox& cell = at.cell;
      if (cell.x < 0 || cell.y < 0 || cell.x + cell.width > page.width || cell.y + cell.height > page.height)
        return "outside";
      if (at.x - at.gutter < cell.x || at.y - at.gutter < cell.y ||
          at.x + width + at.gutter > cell.x + cell.width || at.y + height + at.gutter > cell.y + cell.height)
        return "out of its cell";
      for (int y = cell.y; y < cell.y + cell.height; ++y)
        for (int x = cell.x; x < cell.x + cell.width; ++x) {
          const std::size_t texel = static_cast<std::size_t>(y) * static_cast<std::size_t>(page.width) +
                                    static_cast<std::size_t>(x);
          if (taken[texel]) return "overlap";
          taken[texel] = true;
        }
    }
  }
  return "";
}

}  // namespace

TEST_CASE("64 power-of-two regions fill one page by default, without gutters but with insets") {
  std::vector<Region> regions;
  for (std::size_t i = 0; i < 64; ++i) regions.push_back(region(i, 64, 64));
  const PackingPlan plan = plan_pages(regions, region_names(64), plan_options(512));
  REQUIRE(plan.pages.size() == 1);
  CHECK(plan.pages[0].width * plan.pages[0].height == 512 * 512);
  CHECK(plan.inset);
  CHECK(fault_of(plan, regions).empty());
}

TEST_CASE("regions of the largest page's size need no gutter to fit") {
  const PackingPlan plan = plan_pages({region(0, 256, 256)}, region_names(1), plan_options(256));
  CHECK(plan.pages.size() == 1);
  CHECK(plan.places[0].gutter == 0);
}

TEST_CASE("cells never overlap or leave the page, and mips never share a texel") {
  std::mt19937 random(3);
  for (int round = 0; round < 60; ++round) {
    std::vector<Region> regions;
    const std::size_t count = 1 + random() % 30;
    for (std::size_t i = 0; i < count; ++i) {
      regions.push_back(
          region(i, 1 + static_cast<int>(random() % 150), 1 + static_cast<int>(random() % 150)));
      regions.back().in = {random() % 4 != 0, true};
    }
    PlanOptions o = plan_options(512);
    o.rects.rotate = round % 2 == 0;
    o.levels = static_cast<int>(random() % 5);
    if (round % 3 == 0) o.gutter = static_cast<int>(random() % 8);
    const PackingPlan plan = plan_pages(regions, region_names(count), o);
    CHECK(fault_of(plan, regions) == "");
    int clean = 1;
    for (const PlannedPlace& at : plan.places) clean = std::max(clean, at.clean_levels);
    for (const PlannedPlace& at : plan.places) {
      CHECK(plan.pages[static_cast<std::size_t>(at.page)].has[1]);
      if (o.levels == 1) continue;
      CHECK(at.cell.x % (1 << (clean - 1)) == 0);
      CHECK(at.x % (1 << (at.clean_levels - 1)) == 0);
      CHECK(at.y % (1 << (at.clean_levels - 1)) == 0);
      CHECK(at.cell.width % (1 << (clean - 1)) == 0);
    }
  }
}

TEST_CASE("regions that lack a texture share pages that lack it, where that is smaller") {
  std::vector<Region> regions;
  for (std::size_t i = 0; i < 8; ++i) {
    regions.push_back(region(i, 128, 128));
    regions.back().in = {true, i < 4};
  }
  PlanOptions o = plan_options(512);
  const PackingPlan apart = plan_pages(regions, region_names(8), o);
  o.split_textures = false;
  const PackingPlan common = plan_pages(regions, region_names(8), o);
  CHECK(apart.page_texels() < common.page_texels());
  CHECK(apart.page_texels() == 12 * 128 * 128);
}

TEST_CASE("a tiling region has a page of just its size to itself") {
  std::vector<Region> regions{region(0, 30, 40), region(1, 50, 20)};
  regions[0].own_page = true;
  const PackingPlan plan = plan_pages(regions, region_names(2), plan_options(512));
  CHECK(plan.pages.at(1) == PlannedPage{30, 40, {true, true}});
  CHECK(plan.places[0].page == 1);
}

TEST_CASE("what fits no page is named with its gutter, and with what would hold it") {
  const auto fault = [](const std::vector<Region>& regions, const PlanOptions& options) {
    return error_of([&] { (void)plan_pages(regions, region_names(regions.size()), options); });
  };
  CHECK(fault({region(0, 300, 10)}, plan_options(256)) ==
        "m0: 300 x 10 texels; expected at most 256 a side (page 300 would do)");
  // Powers of two up to 300 end at 256.
  CHECK(
      fault({region(0, 20, 20), region(1, 280, 10)}, plan_options(300)) ==
      "m1: 280 x 10 texels, 282 x 12 with a gutter of 1; expected at most 256 a side (page form free would do)");
  PlanOptions one = plan_options(64);
  one.rects.form = PageForm::free;
  one.gutter = 8;
  CHECK(
      fault({region(0, 60, 10)}, one) ==
      "m0: 60 x 10 texels, 76 x 26 with a gutter of 8; expected at most 64 a side (page 76 or gutter 0 would do)");
  one.gutter = 0;
  CHECK(
      fault({region(0, 50, 50), region(1, 50, 51), region(2, 50, 50)}, one) ==
      "3 regions, the largest of m1: 50 x 51 texels, of together 7550 texels do not fit one page; expected at most 64 x 64 (page form mixed or a larger page would do)");
}

TEST_CASE("pages of free sides are whole blocks of 4 texels where that takes less than 2 percent more") {
  PlanOptions options = plan_options(512);
  options.gutter = 0;
  for (const PageForm form : {PageForm::free, PageForm::square}) {
    options.rects.form = form;
    const PackingPlan large = plan_pages({region(0, 509, 509)}, region_names(1), options);
    CHECK(large.pages.at(0) == PlannedPage{512, 512, {true, true}});
    const PackingPlan small = plan_pages({region(0, 30, 30)}, region_names(1), options);
    CHECK(small.pages.at(0) == PlannedPage{30, 30, {true, true}});
  }
  // No page grows beyond the largest.
  options.rects.side = options.rects.largest_side = 510;
  CHECK(plan_pages({region(0, 509, 509)}, region_names(1), options).pages.at(0).width == 509);
  options.rects.form = PageForm::free;
  options.rects.multiple = 4;
  options.rects.side = options.rects.largest_side = 512;
  CHECK(plan_pages({region(0, 30, 31)}, region_names(1), options).pages.at(0) ==
        PlannedPage{32, 32, {true, true}});
  // As a scene's only region, too: no page of just its size.
  options.gutter.reset();
  options.may_inset = false;
  const PlannedPage page = plan_pages({region(0, 30, 31)}, region_names(1), options).pages.at(0);
  CHECK(page.width % 4 == 0);
  CHECK(page.height % 4 == 0);
}

namespace {

// The layout that a plan was written as.
AtlasLayout written_layout(const PackingPlan& plan, const std::vector<Region>& regions) {
  AtlasLayout out;
  for (const PlannedPage& page : plan.pages) {
    AtlasPage row{page.width, page.height, {}};
    for (std::size_t t = 0; t < 2; ++t)
      if (page.has[t]) row.files[t] = {"file"};
    out.pages.push_back(row);
  }
  const auto all = region_names(regions.size());
  for (std::size_t i = 0; i < regions.size(); ++i) {
    AtlasRect rect;
    const PlannedPlace& at = plan.places[i];
    rect.name = all[regions[i].material];
    rect.page = at.page, rect.x = at.x, rect.y = at.y, rect.rotated = at.rotated;
    rect.crop = regions[i].box;
    rect.width = at.rotated ? rect.crop.height : rect.crop.width;
    rect.height = at.rotated ? rect.crop.width : rect.crop.height;
    rect.gutter = at.gutter, rect.mips = at.clean_levels;
    rect.inset = plan.inset ? 0.5 * (1 << (at.clean_levels - 1)) : 0;
    out.rects.push_back(rect);
  }
  return out;
}

}  // namespace

TEST_CASE("staying costs no more than the stated share of area") {
  // Half of what was there goes: a page of half the size would do for the rest.
  std::vector<Region> regions;
  for (std::size_t i = 0; i < 16; ++i) regions.push_back(region(i, 60, 60));
  PlanOptions choice = plan_options(1024);
  choice.rects.form = PageForm::free;
  const PackingPlan before = plan_pages(regions, region_names(16), choice);
  const AtlasLayout old = written_layout(before, regions);
  std::vector<Region> rest;
  for (std::size_t i = 0; i < 16; i += 2) rest.push_back(regions[i]);
  const PackingPlan fresh = plan_pages(rest, region_names(16), choice);
  REQUIRE(fresh.page_texels() < before.page_texels());
  choice.most_extra_area = 0;
  const PackingPlan tight = plan_pages(rest, region_names(16), choice, &old);
  CHECK(tight.page_texels() <= fresh.page_texels());
  choice.most_extra_area = 10;
  const PackingPlan loose = plan_pages(rest, region_names(16), choice, &old);
  CHECK(loose.moved == 0);
  CHECK(loose.kept_previous);
  CHECK(fault_of(loose, rest) == "");
  for (std::size_t k = 0; k < rest.size(); ++k) CHECK(loose.places[k] == before.places[2 * k]);
  // In between: never above the share, whatever moves.
  for (const double share : {0.02, 0.1, 0.3, 0.6, 1.0}) {
    choice.most_extra_area = share;
    const PackingPlan plan = plan_pages(rest, region_names(16), choice, &old);
    CHECK(static_cast<double>(plan.page_texels()) <= static_cast<double>(fresh.page_texels()) * (1 + share));
    CHECK(fault_of(plan, rest) == "");
  }
}

TEST_CASE("a new region with more clean mips than the others moves none of them") {
  std::vector<Region> regions;
  for (std::size_t i = 0; i < 12; ++i)
    regions.push_back(region(i, 70 + static_cast<int>(i), 90 - static_cast<int>(i)));
  PlanOptions choice = plan_options(2048);
  choice.levels = 0;
  const PackingPlan before = plan_pages(regions, region_names(13), choice);
  const AtlasLayout old = written_layout(before, regions);
  std::vector<Region> more = regions;
  more.push_back(region(12, 300, 300));
  choice.most_extra_area = 0.5;
  const PackingPlan after = plan_pages(more, region_names(13), choice, &old);
  CHECK(after.moved == 0);
  CHECK(after.clean_limit == before.places[0].clean_levels);
  CHECK(fault_of(after, more) == "");
  for (std::size_t i = 0; i < regions.size(); ++i) CHECK(after.places[i] == before.places[i]);
}
