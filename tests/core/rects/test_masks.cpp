// SPDX-License-Identifier: Apache-2.0
#include "core/rects/masks.h"

#include <catch2/catch.hpp>
#include <random>
#include <set>

namespace etak::test {
namespace {

MaskShape shape_of(int width, int height, const std::vector<std::string>& rows) {
  MaskShape out{width, height, {}};
  for (int y = 0; y < height; ++y)
    add_row(out.runs, y, 0, width,
            [&](int x) { return rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] == '#'; });
  return out;
}

/// A connected scribble of `steps` steps of a walk, some of them long.
MaskShape scribble(std::mt19937& random, int side, int steps) {
  std::vector<std::string> rows(static_cast<std::size_t>(side),
                                std::string(static_cast<std::size_t>(side), '.'));
  int x = side / 2, y = side / 2;
  for (int i = 0; i < steps; ++i) {
    rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] = '#';
    int& moved = random() % 2 == 0 ? x : y;
    moved = std::clamp(moved + (random() % 2 == 0 ? 1 : -1), 0, side - 1);
  }
  return shape_of(side, side, rows);
}

/// What is wrong with a layout: found unit by unit.
std::string fault(const std::vector<MaskShape>& shapes, const RectLayout& layout) {
  if (layout.pages.size() != 1 || layout.places.size() != shapes.size()) return "count";
  std::set<std::pair<int, int>> taken;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const RectPlace& at = layout.places[i];
    for (const RowRun& run : shapes[i].runs)
      for (int column = run.begin; column < run.end; ++column) {
        const int x = at.x + (at.rotated ? shapes[i].height - 1 - run.row : column);
        const int y = at.y + (at.rotated ? column : run.row);
        if (x < 0 || y < 0 || x >= layout.pages[0].width || y >= layout.pages[0].height) return "outside";
        if (!taken.emplace(x, y).second) return "overlap";
      }
  }
  return {};
}

}  // namespace

TEST_CASE("a shape lies in the bounding box of another") {
  const std::vector<MaskShape> rings{shape_of(5, 5, {"#####", "#...#", "#...#", "#...#", "#####"}),
                                     shape_of(3, 3, {"###", "#.#", "###"}), shape_of(1, 1, {"#"})};
  const auto layout = pack_masks(rings, {});
  REQUIRE(layout);
  CHECK(fault(rings, *layout).empty());
  CHECK(layout->pages[0] == RectSize{5, 5});
}

TEST_CASE("shapes of any sides lie apart on their page, for any number of threads, turned or not") {
  std::mt19937 random(20);
  for (int round = 0; round < 12; ++round) {
    std::vector<MaskShape> shapes;
    // Sides around those of words, too.
    for (int i = 0; i < 30; ++i) {
      const int side =
          i % 5 == 0 ? 62 + static_cast<int>(random() % 70) : 1 + static_cast<int>(random() % 20);
      shapes.push_back(scribble(random, side, 6 * side));
    }
    RectOptions options;
    options.multiple = 1 + static_cast<int>(random() % 4);
    options.rotate = round % 2 == 1;
    const auto layout = pack_masks(shapes, options);
    REQUIRE(layout);
    CHECK(fault(shapes, *layout).empty());
    CHECK(layout->pages[0].width % options.multiple == 0);
    CHECK(layout->pages[0].height % options.multiple == 0);
    options.threads = 3;
    const auto again = pack_masks(shapes, options);
    CHECK((again->places == layout->places && again->pages == layout->pages));
    options.rotate = false;
    CHECK(layout->page_texels() <= pack_masks(shapes, options)->page_texels());
  }
}

TEST_CASE("a turned shape turned three times more is itself") {
  std::mt19937 random(4);
  const MaskShape shape = scribble(random, 23, 90);
  CHECK(turned(shape) != shape);
  CHECK(turned(turned(turned(turned(shape)))) == shape);
}

TEST_CASE("shapes that no page holds have no layout") {
  RectOptions options;
  options.largest_side = 4;
  CHECK(!pack_masks(std::vector{shape_of(5, 1, {"#####"})}, options));
  options.largest_side = 2;
  CHECK(!pack_masks(std::vector<MaskShape>(5, shape_of(1, 1, {"#"})), options));
}

TEST_CASE("shapes of an earlier page stay where they were, and others go around them") {
  std::mt19937 random(21);
  for (int round = 0; round < 12; ++round) {
    std::vector<MaskShape> shapes;
    for (int i = 0; i < 24; ++i) {
      const int side = 4 + static_cast<int>(random() % 70);
      shapes.push_back(scribble(random, side, 6 * side));
    }
    RectOptions options;
    options.multiple = 1 + static_cast<int>(random() % 4);
    options.rotate = round % 2 == 1;
    const auto old = pack_masks(shapes, options);
    REQUIRE(old);
    // A third of the shapes is gone, as many are new, and two more come.
    PreviousRects previous{old->pages, {}};
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      if (i % 3 == 0) shapes[i] = scribble(random, 10 + static_cast<int>(random() % 60), 200);
      previous.places.push_back(i % 3 == 0 ? std::nullopt : std::optional(old->places[i]));
    }
    for (int i = 0; i < 2; ++i) {
      shapes.push_back(scribble(random, 80, 600));
      previous.places.push_back(std::nullopt);
    }
    const auto now = pack_masks(shapes, options, &previous);
    REQUIRE(now);
    CHECK(now->kept_previous);
    CHECK(fault(shapes, *now).empty());
    CHECK(now->pages[0].width % options.multiple == 0);
    for (std::size_t i = 0; i < shapes.size(); ++i)
      if (previous.places[i]) CHECK(now->places[i] == *previous.places[i]);
  }
}

TEST_CASE(
    "a shape that would meet another at its earlier place goes elsewhere, and one beyond the page too") {
  const std::vector<MaskShape> shapes{shape_of(2, 2, {"##", "##"}), shape_of(2, 1, {"##"}),
                                      shape_of(1, 1, {"#"})};
  const PreviousRects previous{{{4, 2}}, {RectPlace{0, 0, 0}, RectPlace{0, 1, 1}, RectPlace{0, 7, 0}}};
  const auto now = pack_masks(shapes, {}, &previous);
  REQUIRE(now);
  CHECK(fault(shapes, *now).empty());
  CHECK(now->places[0] == RectPlace{0, 0, 0});
  // Where the page of the earlier layout is of no use, the layout is a new one.
  const PreviousRects none{{{4, 2}}, {std::nullopt, std::nullopt, std::nullopt}};
  CHECK_FALSE(pack_masks(shapes, {}, &none)->kept_previous);
}

}  // namespace etak::test
