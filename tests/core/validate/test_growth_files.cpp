// SPDX-License-Identifier: Apache-2.0
// What checking files does with long lists, over four doublings: see check_growth().
#include <catch2/catch.hpp>

#include "core/validate/scene_use.h"
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
