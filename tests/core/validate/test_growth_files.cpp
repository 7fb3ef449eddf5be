// SPDX-License-Identifier: Apache-2.0
// What checking files does with long lists, over four doublings: see check_growth().
#include <catch2/catch.hpp>

#include "core/judge/pixels/flat_rows.h"
#include "core/validate/files/scene_use.h"
#include "tests/growth.h"

using namespace etak;

TEST_CASE("materials of one look are found in time proportional to the materials of a scene") {
  for (const bool alike : {false, true})
    test::check_growth(
        alike ? "alike" : "different", 1000,
        [&](std::size_t n) {
          GltfScene scene;
          scene.materials.resize(n);
          scene.material_used.assign(n, true);
          for (std::size_t i = 0; i < n && !alike; ++i)
            scene.materials[i].base_color[0] = static_cast<double>(i) / static_cast<double>(n);
          return scene;
        },
        [&](const GltfScene& scene) {
          const MaterialLooks looks(scene);
          std::size_t most = 0;
          for (std::size_t i = 0; i < scene.materials.size(); ++i)
            most = std::max(most, looks.of(static_cast<int>(i)).size());
          CHECK(most == (alike ? scene.materials.size() : 1));
        });
}

TEST_CASE("materials of one look are those in use that differ in name alone") {
  GltfScene scene;
  scene.materials.resize(6);
  scene.material_used = {true, true, false, true, true, true};
  scene.materials[3].name = "other name";
  scene.materials[1].roughness = scene.materials[5].roughness = 0.25;
  scene.materials[4].base_color_texture.emplace().image = 2;
  const MaterialLooks looks(scene);
  CHECK(looks.of(0) == std::vector<int>{0, 3});
  CHECK(looks.of(3) == std::vector<int>{0, 3});
  CHECK(looks.of(1) == std::vector<int>{1, 5});
  CHECK(looks.of(2).empty());
  CHECK(looks.of(4) == std::vector<int>{4});
}

namespace {

CheckTarget flat_target(std::size_t tiles) {
  CheckTarget out;
  out.manifest.tiles.resize(tiles);
  for (std::size_t i = 0; i < tiles; ++i) {
    CheckTile& tile = out.manifest.tiles[i];
    for (auto& codes : tile.flat) codes = {static_cast<std::uint8_t>(i % 251), 2, 3, 255};
  }
  place_flat_tiles(out.manifest);
  return out;
}

}  // namespace

TEST_CASE("materials of numbers alone are drawn in time proportional to their number") {
  test::check_growth("flat tiles", 2000, flat_target, [](const CheckTarget& target) {
    const auto rows = flat_rows(target, 0, 0, 0);
    const auto width = static_cast<std::size_t>(rows->header().width);
    std::vector<std::uint8_t> strip(4 * width * 16);
    for (int y = 0; y < rows->header().height; y += 16) rows->read_rows(strip.data(), 4 * width, 16);
    CHECK(strip[1] == 2);
  });
}

TEST_CASE("of tiles that overlap the later one is seen, gutters included") {
  CheckTarget target = flat_target(3);
  auto& tiles = target.manifest.tiles;
  tiles[0].box = {0, 4, 4, 4};
  tiles[1].box = {2, 1, 4, 4};
  tiles[1].gutter = 1;
  tiles[2].box = {0, 0, 1, 2};
  const auto rows = flat_rows(target, 0, 6, 8);
  std::vector<std::uint8_t> texels(4 * 6 * 8);
  rows->read_rows(texels.data(), 4 * 6, 8);
  std::string seen;
  for (std::size_t i = 0; i < 6 * 8; ++i)
    seen += texels[4 * i + 3] == 0 ? '.' : static_cast<char>('0' + texels[4 * i]);
  CHECK(seen == "211111211111.11111.111110111110111110000..0000..");
}
