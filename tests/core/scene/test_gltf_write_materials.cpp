// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "core/scene/gltf.h"
#include "tests/core/scene/small_scene.h"
#include "tests/core/scene/written_scene.h"

using namespace etak;
using namespace etak::test;
using Json = nlohmann::json;

namespace {

std::vector<std::string> names(const Json& json, const char* key) {
  return json.contains(key) ? json[key].get<std::vector<std::string>>() : std::vector<std::string>{};
}

}  // namespace

TEST_CASE("the lossless form says metallic 0, F0 in specularColor and index 0") {
  const GltfScene scene =
      parsed(quad_json(R"([{"name":"m","alphaMode":"BLEND","normalTexture":{"index":1},
"extensions":{"KHR_materials_clearcoat":{"clearcoatFactor":0.5}},"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}])",
                       std::string(two_images) + R"("extensionsUsed":["KHR_materials_clearcoat"],)"));
  GltfOutput output;
  output.images = {"page a.png", "page_b.png", "page_r.png"};
  AtlasMaterial m;
  m.material = 0;
  m.region = {{0.5, 0.25}, {0.25, 0.5}, 0};
  m.diffuse_alpha_image = 0;
  m.specular_gloss_image = 1;
  m.roughness_image = 2;
  output.materials = {m};
  // a.png goes, b.png (the normal map) stays; the validator must find it.
  const TempFolder beside;
  spit(beside.file("b.png"), "");
  const std::string text = write_gltf(scene, output).json;
  const Json json = Json::parse(text);
  const Json& material = json["materials"][0];
  CHECK(material["pbrMetallicRoughness"]["metallicFactor"] == 0);
  CHECK(material["extensions"]["KHR_materials_ior"]["ior"] == 0);
  CHECK(material["extensions"]["KHR_materials_clearcoat"]["clearcoatFactor"] == 0.5);
  CHECK(material["alphaMode"] == "BLEND");
  const auto image_of = [&](const Json& info) {
    return json["images"][json["textures"][info["index"].get<std::size_t>()]["source"].get<std::size_t>()]
               ["uri"]
                   .get<std::string>();
  };
  CHECK(image_of(material["pbrMetallicRoughness"]["baseColorTexture"]) == "page%20a.png");
  CHECK(image_of(material["pbrMetallicRoughness"]["metallicRoughnessTexture"]) == "page_r.png");
  CHECK(image_of(material["extensions"]["KHR_materials_specular"]["specularColorTexture"]) == "page_b.png");
  CHECK(image_of(material["normalTexture"]) == "b.png");
  CHECK(!material["normalTexture"].contains("extensions"));
  const Json transform =
      material["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"];
  CHECK(transform == Json{{"offset", {0.5, 0.25}}, {"scale", {0.25, 0.5}}});
  CHECK(json["images"].size() == 4);
  CHECK(names(json, "extensionsUsed") ==
        std::vector<std::string>{"KHR_materials_clearcoat", "KHR_materials_ior", "KHR_materials_specular",
                                 "KHR_texture_transform"});
  CHECK(names(json, "extensionsRequired") == std::vector<std::string>{"KHR_texture_transform"});
}

TEST_CASE("each form writes its factors where no texture is, and the validator accepts it") {
  const GltfScene scene = parsed(quad_json(
      R"([{"name":"m","pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}])", std::string(two_images)));
  GltfOutput output;
  AtlasMaterial m;
  m.material = 0;
  m.diffuse = {0.5, 0.25, 0.125, 1};
  m.specular = {0.9, 0.6, 0.3};
  m.roughness = 0.25;
  m.base_color = {0.95, 0.6, 0.3, 1};
  m.metallic = 0.75;
  output.materials = {m};
  const Written lossless(scene, output);
  const GltfMaterial& a = lossless.scene.materials[0];
  CHECK((a.metallic == 0 && a.ior == 0 && a.roughness == 0.25 && !leading_texture(a)));
  CHECK(a.base_color == m.diffuse);
  CHECK(a.specular_color == m.specular);
  CHECK(!lossless.json.contains("textures"));
  CHECK(!lossless.json.contains("images"));
  CHECK(!lossless.json.contains("samplers"));

  output.forms = {GltfForm::metal_rough, GltfForm::specular_glossiness};
  const Written two(scene, output);
  const GltfMaterial& b = two.scene.materials[0];
  CHECK((b.specular_glossiness && b.glossiness == 0.75 && b.metallic == 0.75));
  CHECK(b.specular_f0 == m.specular);
  CHECK(b.diffuse == m.diffuse);
  CHECK(b.base_color == m.base_color);
  CHECK(names(two.json, "extensionsUsed") == std::vector<std::string>{"KHR_materials_pbrSpecularGlossiness"});

  output.forms = {GltfForm::specular_ior, GltfForm::metal_rough};
  CHECK(contains(error_of([&] { Written(scene, output); }), "specular_ior beside another"));
}

TEST_CASE("where light passes through the index stays and its F0 is divided out; unlit stays unlit") {
  const GltfScene scene = parsed(quad_json(
      R"([{"extensions":{"KHR_materials_transmission":{"transmissionFactor":1},"KHR_materials_ior":{"ior":1.5}}}])",
      R"("extensionsUsed":["KHR_materials_transmission","KHR_materials_ior"],)"));
  GltfOutput output;
  AtlasMaterial m;
  m.material = 0;
  m.specular = {0.04, 0.08, 0.02};
  output.materials = {m};
  const Written written(scene, output);
  CHECK(written.scene.materials[0].ior == 1.5);
  CHECK(written.scene.materials[0].specular_color[1] == Approx(2));

  const GltfScene flat = parsed(quad_json(R"([{"extensions":{"KHR_materials_unlit":{}}}])",
                                          R"("extensionsUsed":["KHR_materials_unlit"],)"));
  const Written unlit(flat, output);
  CHECK(names(unlit.json, "extensionsUsed") == std::vector<std::string>{"KHR_materials_unlit"});
}
