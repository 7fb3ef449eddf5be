// SPDX-License-Identifier: Apache-2.0
// Scenes that nobody looked at while the packer was written: altered copies of the real ones.
#include <catch2/catch.hpp>
#include <filesystem>
#include <set>

#include "core/scene/gltf.h"
#include "tests/core/atlas/altered_models.h"
#include "tests/core/atlas/scene_support.h"
#include "tests/core/atlas/shaded_scenes.h"
#include "tests/core/scene/written_scene.h"

using namespace etak;
using namespace etak::test;

namespace {

constexpr std::size_t shaded_places = 20000;

// A model and its altered copy; the folder holds the copy.
struct Copy {
  TempFolder folder;
  std::string name, scene;
};

// Calls act(copy) for the altered copies of every model.
template <class Act>
void each_copy(const Act& act) {
  for (std::size_t m = 0; m < real_models.size(); ++m)
    for (const Alteration& alteration : alterations_of(m)) {
      Copy copy;
      copy.name = real_models[m] + ", " + alteration.name;
      copy.scene = altered_copy(*asset(real_models[m]), alteration, PngLevel::small, copy.folder.path());
      INFO(copy.name);
      act(copy);
    }
}

// Whether all textures that the pair replaces have one size, material by material: only then do pages of two
// equal textures not have to hold more texels than were given.
bool are_of_one_size(const std::string& path) {
  const GltfScene scene = read_gltf(path, {});
  ReadPictures pictures(scene);
  for (const GltfMaterial& m : scene.materials) {
    std::set<std::pair<int, int>> sizes;
    for (const GltfTexture* texture : replaced_textures(m)) {
      const Image8& picture = pictures(texture->image);
      sizes.emplace(picture.width, picture.height);
    }
    if (sizes.size() > 1) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("altered copies of real scenes take no more than they did, and every texel looks the same") {
  if (!asset("")) return;
  double shares = 0;
  std::size_t count = 0;
  each_copy([&](const Copy& copy) {
    PackOptions options;
    options.output.smallest_form = true;
    const PackResult gpu = pack_scene(copy.scene, copy.folder.file("gpu"), true, options);
    REQUIRE(gpu.totals);
    const TextureTotals input = PackTotals::all(gpu.totals->input);
    CHECK(gpu.totals->scene->gpu <= input.gpu);
    const double share = static_cast<double>(gpu.totals->scene->gpu) / static_cast<double>(input.gpu);
    shares += share;
    ++count;
    if (are_of_one_size(copy.scene))
      CHECK(PackTotals::of_materials(gpu.totals->output).gpu <=
            PackTotals::of_materials(gpu.totals->input).gpu);
    options.output.goal = PackGoal::disk;
    const PackResult disk = pack_scene(copy.scene, copy.folder.file("disk"), true, options);
    CHECK(disk.totals->scene->disk <= input.disk);
    for (const char* packed : {"gpu/scene.gltf", "disk/scene.gltf"}) {
      const std::string path = copy.folder.file(packed);
      const ShadedDifference found = shaded_difference(copy.scene, path, shaded_places);
      CHECK(found.places > shaded_places / 2);
      CHECK(found.nearest <= 1);
      CHECK(found.bilinear <= 1);
      if (has_validator())
        CHECK(validator_errors(path, {std::filesystem::path(path).parent_path().string()}).empty());
    }
  });
  CHECK(shares / static_cast<double>(count) <= 0.8);
}

TEST_CASE("real scenes in their smallest form look the same, shaded under three lights at five angles") {
  if (!asset("")) return;
  for (const std::string& model : real_models) {
    INFO(model);
    const TempFolder folder;
    PackOptions options;
    options.output.smallest_form = true;
    (void)pack_scene(*asset(model), folder.file("out"), true, options);
    const ShadedDifference found =
        shaded_difference(*asset(model), folder.file("out/scene.gltf"), shaded_places);
    CHECK(found.nearest <= 1);
    CHECK(found.bilinear <= 1);
  }
}
