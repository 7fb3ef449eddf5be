// SPDX-License-Identifier: Apache-2.0
// What a written scene no longer needs goes, and what stays keeps its meaning.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "core/scene/gltf.h"
#include "tests/core/scene/small_scene.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;
using Json = nlohmann::json;

TEST_CASE("unreached materials go and every index follows, variants too") {
  std::string json = quad_json(
      R"([{"name":"gone","normalTexture":{"index":0}},{"name":"a","normalTexture":{"index":2}},{"name":"b"}])",
      R"("images":[{"uri":"a.png"},{"uri":"b.png"},{"bufferView":1,"mimeType":"image/png"}],
"samplers":[{},{"wrapS":33071}],"textures":[{"source":0,"sampler":0},{"source":2},{"source":1,"sampler":1}],
"extensionsUsed":["KHR_materials_variants"],"extensions":{"KHR_materials_variants":{"variants":[{"name":"x"}]}},)");
  json = replaced(
      json, R"("material":0}]}])",
      R"("material":1,"extensions":{"KHR_materials_variants":{"mappings":[{"material":2,"variants":[0]}]}}}]},
{"primitives":[{"attributes":{"POSITION":0},"material":0}]}])");
  const Json kept = Json::parse(write_gltf(parsed(json), {}).json);
  CHECK(kept["materials"].size() == 2);
  CHECK(kept["materials"][0]["name"] == "a");
  CHECK(kept["materials"][0]["normalTexture"]["index"] == 0);
  CHECK(kept["meshes"][0]["primitives"][0]["material"] == 0);
  CHECK(
      kept["meshes"][0]["primitives"][0]["extensions"]["KHR_materials_variants"]["mappings"][0]["material"] ==
      1);
  CHECK(!kept["meshes"][1]["primitives"][0].contains("material"));
  CHECK(kept["images"] == Json::array({{{"uri", "b.png"}}}));
  CHECK(kept["textures"] == Json::array({{{"source", 0}, {"sampler", 0}}}));
  CHECK(kept["samplers"] == Json::array({{{"wrapS", 33071}}}));
  // View 1 is also an accessor's.
  CHECK(kept["bufferViews"].size() == 3);

  const Json without = Json::parse(write_gltf(parsed(json, {.scene = {}, .variants = false}), {}).json);
  CHECK(without["materials"].size() == 1);
  CHECK(!without.contains("extensionsUsed"));
  CHECK(!without.contains("extensions"));
  CHECK(!without["meshes"][0]["primitives"][0].contains("extensions"));
}

TEST_CASE("bytes of inside images that went are cut out of the buffer, and the rest keeps its place") {
  std::string json =
      quad_json(R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}},"normalTexture":{"index":1}}])",
                R"("images":[{"bufferView":3,"mimeType":"image/png"},{"bufferView":4,"mimeType":"image/png"}],
"textures":[{"source":0},{"source":1}],)");
  json = replaced(
      json, R"("byteLength":12,"target":34963})",
      R"("byteLength":12,"target":34963},{"buffer":1,"byteLength":5},{"buffer":1,"byteOffset":5,"byteLength":4})");
  json =
      replaced(json, "\"byteLength\":92}",
               "\"byteLength\":92},{\"uri\":\"data:;base64," + base64("GONE!KEPT") + "\",\"byteLength\":9}");
  const GltfScene scene = parsed(json);
  CHECK(scene.images[1].bytes == "KEPT");
  GltfOutput output;
  AtlasMaterial m;
  m.material = 0;
  output.materials = {m};
  const auto [text, buffer, files] = write_gltf(scene, output);
  CHECK(files.empty());
  CHECK(buffer.find("GONE") == buffer.npos);
  CHECK(buffer.size() < 92 + 16);
  const TempFolder folder;
  spit(folder.file("s.gltf"), text);
  spit(folder.file("scene.bin"), buffer);
  const GltfScene again = read_gltf(folder.file("s.gltf"), {});
  REQUIRE(again.images.size() == 1);
  CHECK(again.images[0].bytes == "KEPT");
  CHECK(again.uses[0].uv[0] == scene.uses[0].uv[0]);
}
