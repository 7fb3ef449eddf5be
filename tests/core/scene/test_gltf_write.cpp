// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <filesystem>

#include "core/scene/gltf.h"
#include "tests/core/scene/small_scene.h"
#include "tests/core/scene/written_scene.h"

using namespace etak;
using namespace etak::test;

namespace {

const std::vector<const char*> real_scenes{"flight_helmet/FlightHelmet.gltf", "mixer/Mixer.gltf",
                                           "tennis_racquet/TennisRacquet.gltf",
                                           "wicker_chair/WickerChair.gltf", "synthetic_a/scene.gltf"};

}  // namespace

TEST_CASE("output that contradicts itself, and scenes that cannot be kept, are refused") {
  const GltfScene scene = parsed(
      quad_json(R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}])", std::string(two_images)));
  AtlasMaterial m;
  m.material = 0;
  const auto refusal = [&](const AtlasMaterial& material, const GltfScene& from) {
    GltfOutput output;
    output.materials = {material};
    return error_of([&] { (void)write_gltf(from, output); });
  };
  CHECK(refusal(m, scene).empty());
  AtlasMaterial bad = m;
  bad.material = 1;
  CHECK(contains(refusal(bad, scene), "s.gltf: material 1 of the atlas"));
  bad = m;
  bad.diffuse_alpha_image = 0;
  CHECK(contains(refusal(bad, scene), "image 0"));
  bad = m;
  bad.islands = {{{0, 0, 4, 4}, {}}};
  bad.texture_width = bad.texture_height = 64;
  CHECK(contains(refusal(bad, scene), "s.gltf#/meshes/0/primitives/0: a triangle in none of the islands"));
  const GltfScene animated =
      parsed(quad_json("[{}]", R"("animations":[{"channels":[{"target":{"path":"pointer",
"extensions":{"KHR_animation_pointer":{"pointer":"/materials/0/emissiveFactor"}}}}]}],)"));
  CHECK(contains(refusal(m, animated), "an animation of /materials/0/emissiveFactor"));
}

TEST_CASE("real scenes under an identity atlas validate, and every lookup stays") {
  const auto shared = shared_folder();
  if (!shared) {
    WARN("no folder of reference data: real scenes are not written");
    return;
  }
  for (const char* file : real_scenes) {
    const std::string path = *shared + "/data/assets/" + file;
    const GltfScene scene = read_gltf(path, {});
    for (const bool both : {false, true}) {
      GltfOutput output;
      if (both) output.forms = {GltfForm::metal_rough, GltfForm::specular_glossiness};
      output.images = {"a.png", "b.png", "r.png"};
      for (const GltfMaterial& material : scene.materials) {
        if (!scene.material_used[static_cast<std::size_t>(material.index)]) continue;
        AtlasMaterial& m = output.materials.emplace_back();
        m.material = material.index;
        m.diffuse_alpha_image = m.base_color_image = 0;
        m.specular_gloss_image = 1;
        m.roughness_image = m.metallic_roughness_image = 2;
        m.sampler = leading_texture(material)->sampler;
      }
      const Written written(scene, output, {std::filesystem::path(path).parent_path().string()});
      REQUIRE(written.scene.materials.size() == output.materials.size());
      for (std::size_t i = 0; i < output.materials.size(); ++i) {
        const GltfMaterial& old = scene.materials[static_cast<std::size_t>(output.materials[i].material)];
        CHECK(written.scene.materials[i].name == old.name);
        CHECK(leading_texture(written.scene.materials[i])->transform == leading_texture(old)->transform);
        CHECK(leading_texture(written.scene.materials[i])->sampler == leading_texture(old)->sampler);
        CHECK(written.scene.materials[i].normal_texture.has_value() == old.normal_texture.has_value());
      }
      for (std::size_t u = 0; u < scene.uses.size(); ++u)
        CHECK(written.scene.uses[u].uv[0] == scene.uses[u].uv[0]);
      CHECK(written.scene.cameras.size() == scene.cameras.size());
    }
  }
}
