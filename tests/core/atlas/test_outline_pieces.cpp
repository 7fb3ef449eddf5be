// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/outline_pieces.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <map>
#include <random>
#include <set>
#include <tuple>

#include "tests/bench/island_sets.h"
#include "tests/support.h"

namespace etak::test {
namespace {

/// Discs and rings of a picture of 200 x 160, which lie in each other's boxes.
std::vector<Region> round_regions(std::mt19937& random, int count) {
  std::vector<Region> out;
  for (int i = 0; i < count; ++i) {
    const int x = 20 + static_cast<int>(random() % 160), y = 20 + static_cast<int>(random() % 120),
              most = 2 + static_cast<int>(random() % 19), least = random() % 2 == 0 ? most / 2 : 0;
    Region region{0, {x - most, y - most, 2 * most + 1, 2 * most + 1}};
    for (int row = y - most; row <= y + most; ++row)
      add_row(region.texels, row, x - most, x + most + 1, [&](int column) {
        const int square = (column - x) * (column - x) + (row - y) * (row - y);
        return square <= most * most && square >= least * least;
      });
    out.push_back(std::move(region));
  }
  return out;
}

}  // namespace

TEST_CASE(
    "pieces hold the texels of their outline where it lies, and none of another's, with their gutters") {
  std::mt19937 random(31);
  for (const bool rotate : {false, true})
    for (const int gutter : {0, 1, 2, 4}) {
      std::vector<Region> regions = round_regions(random, 14);
      regions.push_back({0, {3, 5, 40, 9}});  // a box among them
      PlanOptions options;
      options.rects.form = PageForm::free;
      options.rects.rotate = rotate;
      options.gutter = gutter;
      options.levels = 4;
      options.may_inset = false;
      const PackingPlan plan = plan_pages(regions, {"m"}, options);
      REQUIRE(plan.pages.size() == 1);
      const PlacedRegions pieces = outline_pieces(regions, plan);
      REQUIRE(pieces.regions.size() == pieces.places.size());
      // By texel of the page: the region it is of, and the texel of the picture that lies there.
      std::map<std::pair<int, int>, std::tuple<int, int, int>> page;
      std::vector<std::set<std::pair<int, int>>> held(regions.size());
      bool apart = true, inside = true;
      for (std::size_t p = 0; p < pieces.regions.size(); ++p) {
        const Region& piece = pieces.regions[p];
        const PlannedPlace& at = pieces.places[p];
        const int owner = piece.outline == 0 ? 14 : piece.outline - 1;
        for (int row = -at.gutter; row < piece.box.height + at.gutter; ++row)
          for (int column = -at.gutter; column < piece.box.width + at.gutter; ++column) {
            const int x = at.rotated ? at.x + piece.box.height - 1 - row : at.x + column;
            const int y = at.rotated ? at.y + column : at.y + row;
            const std::tuple texel(owner, piece.box.x + column, piece.box.y + row);
            inside = inside && x >= 0 && y >= 0 && x < plan.pages[0].width && y < plan.pages[0].height;
            apart = apart && page.try_emplace({x, y}, texel).first->second == texel;
            if (row >= 0 && column >= 0 && row < piece.box.height && column < piece.box.width)
              held[static_cast<std::size_t>(owner)].emplace(piece.box.x + column, piece.box.y + row);
          }
      }
      CHECK(apart);
      CHECK(inside);
      std::size_t missing = 0;
      for (std::size_t i = 0; i < regions.size(); ++i)
        for (const RowRun& run : regions[i].texels)
          for (int x = run.begin; x < run.end; ++x) missing += held[i].contains({x, run.row}) ? 0 : 1;
      CHECK(missing == 0);
    }
}

TEST_CASE("outlines take less than their boxes, and the account of their cells is that of their texels") {
  std::mt19937 random(5);
  const std::vector<Region> regions = round_regions(random, 40);
  std::vector<Region> boxes = regions;
  for (Region& box : boxes) box.texels.clear();
  PlanOptions options;
  options.rects.form = PageForm::free;
  options.gutter = 1;
  const PackingPlan by_outline = plan_pages(regions, {"m"}, options),
                    by_box = plan_pages(boxes, {"m"}, options);
  CHECK(by_outline.page_texels() < by_box.page_texels());
  std::uint64_t cells = 0;
  for (const PlannedPlace& place : by_outline.places) {
    CHECK(place.cell_texels <= place.cell.area());
    cells += place.cell_texels;
  }
  CHECK(2 * cells <= by_outline.page_texels());
  CHECK(outline_pieces(boxes, by_box).regions == boxes);
}

TEST_CASE("charts of meshes by outline take at most these shares of the page of their boxes") {
  // Gutters of 2; bench_islands has the figures.
  const std::map<std::string, double> most{{"gear", 0.79}, {"grass", 0.40}, {"knot", 0.57}, {"rock", 0.87}};
  for (const auto& [name, share] : most) {
    std::ifstream file(source_folder() + "/tests/bench/islands/" + name + ".txt");
    const std::vector<Region> islands = read_islands(file);
    REQUIRE(islands.size() >= 20);
    std::vector<Region> boxes = islands;
    for (Region& box : boxes) box.texels.clear();
    PlanOptions options;
    options.rects.form = PageForm::free;
    options.gutter = 2;
    options.may_inset = false;
    const auto by_outline = static_cast<double>(plan_pages(islands, {"m"}, options).page_texels());
    INFO(name);
    CHECK(by_outline <= share * static_cast<double>(plan_pages(boxes, {"m"}, options).page_texels()));
  }
}

}  // namespace etak::test
