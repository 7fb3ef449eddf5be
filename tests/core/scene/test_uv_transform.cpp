// SPDX-License-Identifier: Apache-2.0
#include "core/scene/uv_transform.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

using namespace etak;

TEST_CASE("the extension's own example reads the lower left quadrant") {
  // KHR_texture_transform: offset 0 1, rotation 90 degrees, scale 1/2.
  const UvTransform t{{0, 1}, {0.5, 0.5}, std::numbers::pi / 2};
  for (const double u : {0.0, 0.3, 1.0})
    for (const double v : {0.0, 0.6, 1.0}) {
      const Uv at = transformed(t, {u, v});
      CHECK(at[0] == Approx(0.5 * v).margin(1e-15));
      CHECK(at[1] == Approx(1 - 0.5 * u));
    }
}

TEST_CASE("a composed transform does one after the other, and says when it cannot") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-2, 2);
  for (int i = 0; i < 200; ++i) {
    const UvTransform outer{
        {number(random), number(random)}, {number(random), number(random)}, (i % 4) * std::numbers::pi / 2};
    const UvTransform inner{
        {number(random), number(random)}, {number(random), number(random)}, (i % 3) * std::numbers::pi / 2};
    const auto both = composed(outer, inner);
    REQUIRE(both);
    const Uv uv{number(random), number(random)};
    const Uv expected = transformed(outer, transformed(inner, uv)), found = transformed(*both, uv);
    CHECK(found[0] == Approx(expected[0]).margin(1e-12));
    CHECK(found[1] == Approx(expected[1]).margin(1e-12));
  }
  // A turn by 30 degrees under unequal scales is a shear; under equal ones it is not.
  CHECK(!composed({{0, 0}, {0.25, 0.5}, 0}, {{0, 0}, {1, 1}, std::numbers::pi / 6}));
  CHECK(composed({{0, 0}, {0.25, 0.25}, 0}, {{0, 0}, {1, 1}, std::numbers::pi / 6}));
}

TEST_CASE("a region's transform finds every texel of the box at its place, turned and scaled too") {
  const int texture_width = 64, texture_height = 48, page_width = 256, page_height = 128;
  const std::array<int, 4> box{10, 20, 16, 12};
  for (const int scale : {1, 2})
    for (const bool rotated : {false, true}) {
      const std::array<int, 4> place{100, 60, scale * (rotated ? 12 : 16), scale * (rotated ? 16 : 12)};
      const UvTransform t =
          region_transform({box, texture_width, texture_height, place, rotated, page_width, page_height});
      for (int j = 0; j < box[3]; ++j)
        for (int i = 0; i < box[2]; ++i) {
          // Centre of the texel.
          const Uv uv =
              transformed(t, {(box[0] + i + 0.5) / texture_width, (box[1] + j + 0.5) / texture_height});
          const double x = uv[0] * page_width - place[0], y = uv[1] * page_height - place[1];
          const double column = rotated ? box[3] - 1 - j : i, row = rotated ? i : j;
          CHECK(x == Approx(scale * (column + 0.5)));
          CHECK(y == Approx(scale * (row + 0.5)));
        }
    }
}
