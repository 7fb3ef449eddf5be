// SPDX-License-Identifier: Apache-2.0
// Textures beside the pair: which of them lie on the pages, when that is worth it, and their texels there.
#include "core/pack/scene/scene_maps.h"

#include <catch2/catch.hpp>

#include "tests/core/atlas/pack_support.h"
#include "tests/core/scene/small_scene.h"

using namespace etak;
using namespace etak::test;

namespace {

// A square for each material, all with the same UVs.
struct MappedScene {
  TempFolder folder;
  PackOptions options;
  PackSource source;
  PackDecision decision;

  ///   pictures    the document's images, of which texture i reads the i-th
  ///   materials   the array of materials
  MappedScene(const std::vector<Image8>& pictures, int material_count, const std::string& materials) {
    std::string images, textures, primitives;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      const std::string number = std::to_string(i);
      save_png(folder.file(number + ".png"), pictures[i]);
      images += (i == 0 ? "" : ",") + (R"({"uri":")" + number) + R"(.png"})";
      textures += (i == 0 ? "" : ",") + (R"({"source":)" + number) + "}";
    }
    const std::string primitive = R"({"attributes":{"POSITION":0,"TEXCOORD_0":1},"indices":2,"material":)";
    for (int i = 0; i < material_count; ++i)
      primitives += (i == 0 ? "" : ",") + primitive + std::to_string(i) + "}";
    const std::string json =
        quad_json(materials, "\"images\":[" + images + "],\"textures\":[" + textures + "],");
    spit(folder.file("s.gltf"), replaced(json, primitive + "0}", primitives));
    spit(folder.file("quad.bin"), unit_quad());
    source = read_source(folder.file("s.gltf"), nullptr, options, built_in_library());
    FoundResolutions found;
    decision = std::move(decide(options, source, nullptr, found).front());
  }

  SceneMaps maps(Others others = Others::written) const {
    return scene_maps(*source.scene, decision, others);
  }
};

constexpr const char* metal_rough =
    R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0},"metallicRoughnessTexture":{"index":1}})";

std::string material_with(const std::string& more, const std::string& pair = metal_rough) {
  return "{" + pair + (more.empty() ? "" : ",") + more + "}";
}

std::vector<Image8> three_pictures() {
  return {noise(16, 16, 3, 1), noise(16, 16, 3, 2), noise(16, 16, 3, 3)};
}

}  // namespace

TEST_CASE("textures are placed that lie as the pair does and are of its size") {
  std::vector<Image8> pictures = three_pictures();
  pictures.push_back(noise(8, 8, 3, 4));  // of another size
  const MappedScene scene(pictures, 1,
                          "[" + material_with(R"("normalTexture":{"index":2},"occlusionTexture":{"index":1},
                                                "emissiveTexture":{"index":3})") +
                              "]");
  const SceneMaps maps = scene.maps();
  REQUIRE(maps.size() == 1);
  const MaterialMaps& of = maps.begin()->second;
  CHECK(of.base_color == 0);
  CHECK(of.metal_rough == 1);
  CHECK(of.occlusion == 1);
  CHECK(of.normal == 2);
  CHECK(!of.emissive);
  CHECK(of.exact);
}

TEST_CASE("a texture with a transform or a set of UVs of its own is not placed") {
  for (const char* place : {R"("texCoord":1)", R"("extensions":{"KHR_texture_transform":{"scale":[2,2]}})"}) {
    INFO(place);
    const MappedScene scene(
        three_pictures(), 1,
        "[" + material_with(R"("normalTexture":{"index":2,)" + std::string(place) + "}") + "]");
    const SceneMaps maps = scene.maps();
    REQUIRE(maps.size() == 1);
    CHECK(!maps.begin()->second.normal);
    CHECK(maps.begin()->second.base_color == 0);
  }
}

TEST_CASE("materials that share texels share what is placed, and what they do not agree on is not") {
  std::vector<Image8> pictures = three_pictures();
  pictures.push_back(pictures[2]);  // the same bytes in another file
  pictures.push_back(noise(16, 16, 3, 5));
  const auto maps_of = [&](const char* first, const char* second) {
    const MappedScene scene(pictures, 2, "[" + material_with(first) + "," + material_with(second) + "]");
    const SceneMaps maps = scene.maps();
    REQUIRE(maps.size() == 1);
    return maps.begin()->second;
  };
  CHECK(maps_of(R"("normalTexture":{"index":2})", "").normal == 2);
  CHECK(!maps_of(R"("normalTexture":{"index":2})", R"("normalTexture":{"index":4})").normal);
  CHECK(maps_of(R"("normalTexture":{"index":2},"emissiveTexture":{"index":3})", "").emissive ==
        2);  // the first of equal files
}

TEST_CASE("only factors and textures of core glTF's metal-rough form are plain, and stay as they are") {
  GltfMaterial plain;
  CHECK(is_plain_metal_rough(plain));
  GltfMaterial other = plain;
  other.ior = 1.4;
  CHECK(!is_plain_metal_rough(other));
  other = plain;
  other.specular_color = {1, 0.9, 1};
  CHECK(!is_plain_metal_rough(other));
  const MappedScene scene(
      three_pictures(), 1,
      "[" + material_with(R"("extensions":{"KHR_materials_ior":{"ior":1.4}},"normalTexture":{"index":2})") +
          "]");
  const MaterialMaps written = scene.maps(Others::written).begin()->second;
  CHECK(!written.exact);
  CHECK(written.normal == 2);
  const MaterialMaps stays = scene.maps(Others::stay).begin()->second;
  CHECK(stays.exact);  // none of its users is written
  CHECK(!stays.normal);
}

TEST_CASE("a texture that weighs no less on its page than as it is stays a file of its own") {
  const MappedScene scene(three_pictures(), 1, "[" + material_with(R"("normalTexture":{"index":2})") + "]");
  const SceneMaps maps = scene.maps();
  const auto left = [&](std::uint64_t kept, const std::vector<GltfForm>& forms) {
    const MapWeights weights{Others::written, TextureWeight(PackGoal::gpu, {}), [kept](int) {
                               return TextureTotals{1, kept, kept};
                             }};
    return worthwhile(maps, forms, scene.decision, weights).begin()->second;
  };
  const MaterialMaps heavy = left(1000000, {GltfForm::metal_rough});
  CHECK(heavy.normal == 2);
  CHECK(heavy.base_color == 0);
  CHECK(heavy.exact);
  const MaterialMaps light = left(1, {GltfForm::metal_rough});
  CHECK(!light.normal);
  CHECK(!light.base_color);
  CHECK(!light.metal_rough);
  CHECK(light.exact);
  CHECK(!left(1000000, {GltfForm::metal_rough, GltfForm::specular_glossiness}).exact);
  const SceneMaps none = none_placed(maps);
  CHECK(none.begin()->second.exact);
  CHECK(!none.begin()->second.normal);
}

TEST_CASE("texels of placed textures lie where the pair's region lies") {
  const std::vector<Image8> pictures = three_pictures();
  const MappedScene scene(
      pictures, 1,
      "[" + material_with(R"("normalTexture":{"index":2},"occlusionTexture":{"index":1})") + "]");
  const MapPixels pixels = map_pixels(0, scene.maps(), *scene.source.scene, scene.decision, 1);
  REQUIRE(pixels.color);
  REQUIRE(pixels.geometry);
  CHECK(pixels.regions == std::vector<std::size_t>{0});
  const PlannedPlace& at = scene.decision.plan.places[0];
  REQUIRE(!at.rotated);
  const PixelBox& box = scene.decision.regions[0].box;
  const PixelsView8 color = pixels.color->view(Texture::diffuse_alpha),
                    data = pixels.color->view(Texture::specular_gloss),
                    normal = pixels.geometry->view(Texture::diffuse_alpha),
                    emissive = pixels.geometry->view(Texture::specular_gloss);
  for (int y = 0; y < box.height; ++y)
    for (int x = 0; x < box.width; ++x)
      for (int c = 0; c < 3; ++c) {
        const auto channel = static_cast<std::size_t>(c);
        CHECK(color.at(at.x + x, at.y + y)[c] == pictures[0].at(box.x + x, box.y + y)[channel]);
        CHECK(data.at(at.x + x, at.y + y)[c] == pictures[1].at(box.x + x, box.y + y)[channel]);
        CHECK(normal.at(at.x + x, at.y + y)[c] == pictures[2].at(box.x + x, box.y + y)[channel]);
        CHECK(emissive.at(at.x + x, at.y + y)[c] == 255);  // where a material has none
      }
}
