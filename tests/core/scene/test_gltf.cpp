// SPDX-License-Identifier: Apache-2.0
#include "core/scene/gltf.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <limits>

#include "tests/core/scene/small_scene.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

const std::string plain_material =
    R"([{"name":"m","pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}])";

std::string refusal(const std::string& json) {
  return error_of([&] { parsed(json); });
}

void check_square(const GltfScene& scene) {
  REQUIRE(scene.uses.size() == 1);
  const GltfUse& use = scene.uses[0];
  REQUIRE(use.world_area.size() == 2);
  CHECK(use.world_area[0] == Approx(0.5));
  REQUIRE(use.uv[0].size() == 2);
  CHECK(use.uv[0][0] == std::array<std::array<float, 2>, 3>{{{0, 0}, {1, 0}, {1, 1}}});
  CHECK(use.uv[0][1] == std::array<std::array<float, 2>, 3>{{{0, 0}, {1, 1}, {0, 1}}});
  CHECK(use.uv[1].empty());
}

}  // namespace

TEST_CASE("one scene reads the same from files, data URIs and .glb") {
  const TempFolder folder;
  std::filesystem::create_directory(folder.file("in"));
  spit(folder.file("in/qu ad.bin"), unit_quad());
  const std::string json = quad_json(plain_material, std::string(two_images));
  spit(folder.file("in/scene.gltf"), replaced(json, "quad.bin", "qu%20ad.bin"));
  const GltfScene beside = read_gltf(folder.file("in/scene.gltf"), {});
  check_square(beside);
  CHECK(beside.images[0].path == folder.file("in/a.png"));
  CHECK(beside.image_used == std::vector<bool>{true, false});
  check_square(parsed(json));
  spit(folder.file("scene.glb"), glb(replaced(json, R"("uri":"quad.bin",)", ""), unit_quad()));
  check_square(read_gltf(folder.file("scene.glb"), {}));
}

TEST_CASE("normalised, strided, sparse, 8- and 32-bit accessors mean the same square") {
  // One view of interleaved UVs in 16-bit shares and padding; indices in 8 and 32 bits behind.
  std::string buffer = bytes_of<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  for (const auto& [u, v] : {std::pair{0, 0}, {65535, 0}, {65535, 65535}, {0, 65535}})
    buffer += bytes_of<std::uint16_t>({static_cast<std::uint16_t>(u), static_cast<std::uint16_t>(v),
                                       std::uint16_t{777}, std::uint16_t{777}});
  buffer += bytes_of<std::uint8_t>({0, 1, 2, 0, 2, 3, 0, 0}) + bytes_of<std::uint32_t>({0, 1, 2, 0, 2, 3});
  const std::string uri = "\"uri\":\"data:;base64," + base64(buffer) + "\",";
  std::string json = quad_json(plain_material, std::string(two_images), uri);
  json = replaced(json, "\"byteLength\":92", "\"byteLength\":112");
  json = replaced(json, R"("byteOffset":48,"byteLength":32)",
                  R"("byteOffset":48,"byteLength":32,"byteStride":8)");
  json = replaced(json, R"({"bufferView":1,"componentType":5126)",
                  R"({"bufferView":1,"normalized":true,"componentType":5123)");
  const std::string bytes =
      replaced(replaced(json, R"("byteOffset":80,"byteLength":12)", R"("byteOffset":80,"byteLength":6)"),
               R"({"bufferView":2,"componentType":5123)", R"({"bufferView":2,"componentType":5121)");
  check_square(parsed(bytes));
  const std::string words =
      replaced(replaced(json, R"("byteOffset":80,"byteLength":12)", R"("byteOffset":88,"byteLength":24)"),
               R"({"bufferView":2,"componentType":5123)", R"({"bufferView":2,"componentType":5125)");
  check_square(parsed(words));

  // Sparse UVs over none: three of four elements given.
  std::string sparse = quad_json(plain_material, std::string(two_images));
  const std::string values =
      unit_quad() + bytes_of<std::uint16_t>({1, 2, 3, 0}) + bytes_of<float>({1, 0, 1, 1, 0, 1});
  sparse = replaced(sparse, R"("uri":"quad.bin",)", "\"uri\":\"data:;base64," + base64(values) + "\",");
  sparse = replaced(sparse, "\"byteLength\":92", "\"byteLength\":124");
  sparse = replaced(
      sparse, R"("byteLength":12,"target":34963})",
      R"("byteLength":12},{"buffer":0,"byteOffset":92,"byteLength":8},{"buffer":0,"byteOffset":100,"byteLength":24})");
  const std::string put =
      R"({"sparse":{"count":3,"indices":{"bufferView":3,"componentType":5123},"values":{"bufferView":4}},"componentType":5126)";
  check_square(parsed(replaced(sparse, R"({"bufferView":1,"componentType":5126)", put)));
  CHECK(contains(refusal(replaced(replaced(sparse, R"({"bufferView":1,"componentType":5126)", put),
                                  "\"count\":3", "\"count\":5")),
                 "at most 4"));
}

TEST_CASE("strips and fans draw the triangles of the list") {
  const std::string json = quad_json(plain_material, std::string(two_images));
  const auto with = [&](const std::vector<std::uint16_t>& indices, const std::string& mode) {
    std::string buffer = unit_quad();
    buffer.replace(80, 2 * indices.size(), bytes_of(indices));
    std::string text =
        replaced(json, R"("uri":"quad.bin",)", "\"uri\":\"data:;base64," + base64(buffer) + "\",");
    text = replaced(text, "\"indices\":2", "\"indices\":2,\"mode\":" + mode);
    return parsed(replaced(text, "\"count\":6", "\"count\":" + std::to_string(indices.size())));
  };
  const auto strip = with({1, 2, 0, 3}, "5");
  CHECK(strip.uses[0].world_area == std::vector<float>{0.5f, 0.5f});
  CHECK(strip.uses[0].uv[0][0] == std::array<std::array<float, 2>, 3>{{{1, 0}, {1, 1}, {0, 0}}});
  CHECK(strip.uses[0].uv[0][1] == std::array<std::array<float, 2>, 3>{{{1, 1}, {0, 1}, {0, 0}}});
  const auto fan = with({0, 1, 2, 3}, "6");
  CHECK(fan.uses[0].world_area == std::vector<float>{0.5f, 0.5f});
  CHECK(fan.uses[0].uv[0][1] == std::array<std::array<float, 2>, 3>{{{1, 1}, {0, 1}, {0, 0}}});
}

TEST_CASE("lines and points are triangles without an area, of the UVs that they read") {
  const auto drawn = [](const std::string& mode) {
    std::string buffer = unit_quad();
    buffer.replace(80, 8, bytes_of<std::uint16_t>({3, 1, 0, 2}));
    std::string text = quad_json(plain_material, std::string(two_images));
    text = replaced(text, R"("uri":"quad.bin",)", "\"uri\":\"data:;base64," + base64(buffer) + "\",");
    text = replaced(text, "\"indices\":2", "\"indices\":2,\"mode\":" + mode);
    const GltfUse use = parsed(replaced(text, "\"count\":6", "\"count\":4")).uses[0];
    CHECK(std::ranges::all_of(use.world_area, [](float area) { return area == 0; }));
    // Vertices by number: their UVs are those of the corners of the square.
    std::vector<std::string> out;
    for (const auto& corners : use.uv[0]) {
      std::string& element = out.emplace_back();
      for (const auto& [u, v] : corners) element += v == 0 ? (u == 0 ? '0' : '1') : u == 0 ? '3' : '2';
    }
    return out;
  };
  using Elements = std::vector<std::string>;
  CHECK(drawn("0") == Elements{"333", "111", "000", "222"});
  CHECK(drawn("1") == Elements{"311", "022"});
  CHECK(drawn("2") == Elements{"311", "100", "022", "233"});
  CHECK(drawn("3") == Elements{"311", "100", "022"});
}

TEST_CASE("materials carry every factor, texture, sampler and extension") {
  const GltfScene scene = parsed(quad_json(
      R"([{"alphaMode":"MASK","alphaCutoff":0.25,"doubleSided":true,
"normalTexture":{"index":0,"scale":0.5},
"pbrMetallicRoughness":{"baseColorFactor":[0.1,0.2,0.3,0.4],"metallicFactor":0.5,"roughnessFactor":0.25,
"baseColorTexture":{"index":1,"texCoord":0,"extensions":{"KHR_texture_transform":{"offset":[0.25,0.5],"rotation":1.5,"scale":[2,3],"texCoord":1}}},
"metallicRoughnessTexture":{"index":0}},
"extensions":{"KHR_materials_ior":{"ior":1.33},"KHR_materials_specular":{"specularFactor":0.75,"specularColorFactor":[1,2,3],
"specularTexture":{"index":0},"specularColorTexture":{"index":1}},"KHR_unknown_thing":{"x":[1]}}},
{"extensions":{"KHR_materials_pbrSpecularGlossiness":{"diffuseFactor":[1,1,0,1],"specularFactor":[0.1,0.2,0.3],"glossinessFactor":0.5,
"diffuseTexture":{"index":0},"specularGlossinessTexture":{"index":1}}}}])",
      std::string(two_images)));
  REQUIRE(scene.materials.size() == 2);
  const GltfMaterial& m = scene.materials[0];
  CHECK(m.base_color == std::array<double, 4>{0.1, 0.2, 0.3, 0.4});
  CHECK((m.metallic == 0.5 && m.roughness == 0.25 && m.ior == 1.33 && m.specular == 0.75 &&
         m.normal_scale == 0.5));
  CHECK((m.alpha_mode == AlphaMode::mask && m.alpha_cutoff == 0.25 && m.double_sided));
  REQUIRE(m.base_color_texture);
  CHECK(m.base_color_texture->transform == UvTransform{{0.25, 0.5}, {2, 3}, 1.5});
  CHECK((m.base_color_texture->uv_set == 1 && m.base_color_texture->image == 1));
  CHECK(m.base_color_texture->sampler == GltfSampler{Wrap::clamp, Wrap::mirrored, false, true});
  CHECK(m.metallic_roughness_texture->sampler == GltfSampler{});
  CHECK(m.specular_color == std::array<double, 3>{1, 2, 3});
  CHECK(leading_texture(m) == &*m.base_color_texture);
  CHECK(!textures_agree(m));
  CHECK((scene.materials[1].specular_glossiness && scene.materials[1].glossiness == 0.5));
  CHECK(scene.material_used == std::vector<bool>{true, false});
}

TEST_CASE("transforms of nodes reach areas, centres and cameras") {
  std::string json =
      quad_json("[{}]", R"("cameras":[{"type":"perspective","perspective":{"yfov":0.5,"znear":0.1}}],)");
  json = replaced(json, R"("nodes":[{"mesh":0}],)",
                  R"("nodes":[{"children":[1,2],"scale":[2,2,2],"translation":[10,0,0]},
{"mesh":0,"rotation":[0,0.7071067811865476,0,0.7071067811865476]},
{"camera":0,"matrix":[0,0,-1,0, 0,1,0,0, 1,0,0,0, 0,0,3,1]}],)");
  const GltfScene scene = parsed(json);
  CHECK(scene.uses[0].world_area[0] == Approx(2));
  // Corner x goes to -z under a quarter turn around y; the triangle's centre (2/3, 1/3, 0).
  CHECK(scene.uses[0].world_center[0][0] == Approx(10).margin(1e-6));
  CHECK(scene.uses[0].world_center[0][2] == Approx(-4. / 3));
  REQUIRE(scene.cameras.size() == 1);
  CHECK(scene.cameras[0].position == std::array<double, 3>{10, 0, 6});
  CHECK(scene.cameras[0].direction[0] == Approx(-1));
  CHECK((scene.cameras[0].yfov == 0.5 && scene.cameras[0].znear == 0.1));
}

TEST_CASE("scenes and variants decide what is reached") {
  std::string json =
      quad_json(R"([{"name":"a"},{"name":"b"},{"name":"c"}])",
                R"("extensions":{"KHR_materials_variants":{"variants":[{"name":"x"},{"name":"y"}]}},)");
  json = replaced(json, R"([{"nodes":[0]}])", R"([{"nodes":[0]},{"nodes":[1]}])");
  json = replaced(json, R"([{"mesh":0}])", R"([{"mesh":0},{"mesh":1}])");
  json = replaced(json, R"("material":0}]}])",
                  R"("material":0,"extensions":{"KHR_materials_variants":{"mappings":[
{"material":1,"variants":[0]},{"material":0,"variants":[1]}]}}}]},{"primitives":[{"attributes":{"POSITION":0},"material":2}]}])");
  const auto used = [&](const GltfOptions& options) { return parsed(json, options).material_used; };
  CHECK(used({}) == std::vector<bool>{true, true, false});
  CHECK(used({.scene = {}, .variants = false}) == std::vector<bool>{true, false, false});
  CHECK(used({.scene = 1}) == std::vector<bool>{false, false, true});
  CHECK(used({.scene = {}, .all_scenes = true}) == std::vector<bool>{true, true, true});
  CHECK(parsed(json).variant_names == std::vector<std::string>{"x", "y"});
  CHECK(contains(error_of([&] { parsed(json, {.scene = 2}); }), "no scene 2"));
}

TEST_CASE("a mesh drawn twice keeps its UVs once for the raster") {
  std::string json = quad_json("[{}]");
  json = replaced(json, R"([{"nodes":[0]}],"nodes":[{"mesh":0}])",
                  R"([{"nodes":[0,1]}],"nodes":[{"mesh":0},{"mesh":0,"scale":[3,3,3]}])");
  const GltfScene scene = parsed(json);
  REQUIRE(scene.uses.size() == 2);
  CHECK((scene.uses[0].same_uv_as == -1 && scene.uses[1].same_uv_as == 0));
  CHECK(scene.uses[1].world_area[0] == Approx(4.5));
}

TEST_CASE("what cannot be read is refused with its place") {
  const std::string json = quad_json(plain_material, std::string(two_images));
  const auto with = [&](std::string_view what, std::string_view to) {
    return refusal(replaced(json, what, to));
  };
  CHECK(contains(with("\"version\":\"2.0\"", "\"version\":\"1.0\""), "s.gltf#/asset/version"));
  CHECK(contains(with("\"material\":0", "\"material\":1"),
                 "s.gltf#/meshes/0/primitives/0/material: 1; expected an index into materials"));
  CHECK(contains(with("\"material\":0", "\"material\":-1"), "#/meshes/0/primitives/0/material"));
  CHECK(contains(with("\"TEXCOORD_0\":1", "\"TEXCOORD_0\":2"), "TEXCOORD_0: an accessor of another type"));
  CHECK(contains(with("\"count\":4", "\"count\":5"), "s.gltf#/accessors/0: 5 elements need 60 bytes"));
  CHECK(contains(with("\"count\":4", "\"count\":1e300"), "#/accessors/0/count"));
  CHECK(contains(with("\"count\":4", "\"count\":18446744073709551615"), "#/accessors/0/count"));
  CHECK(contains(with("\"byteOffset\":48", "\"byteOffset\":1099511627776"), "#/bufferViews/1"));
  CHECK(contains(with("\"byteLength\":92", "\"byteLength\":93"), "#/buffers/0/byteLength"));
  CHECK(contains(with("[{\"mesh\":0}]", "[{\"mesh\":0,\"children\":[0]}]"),
                 "s.gltf#/nodes/0: reached twice in scene 0"));
  CHECK(contains(with("a.png", "../a.png"),
                 "s.gltf#/images/0/uri: \"../a.png\"; expected a file in the scene's folder"));
  CHECK(contains(with("a.png", "%2E%2E%2Fa.png"), "#/images/0/uri"));
  CHECK(contains(with("\"source\":0", "\"source\":2"), "#/textures/0/source"));
  CHECK(contains(
      with("{\"source\":0}", "{\"extensions\":{\"KHR_texture_basisu\":{\"source\":0}}}"),
      "#/textures/0/extensions/KHR_texture_basisu/source: the picture \"a.png\", compressed by Basis "
      "Universal, which etak does not read; expected the PNG or JPEG"));
  CHECK(with("{\"source\":0}", "{\"source\":0,\"extensions\":{\"KHR_texture_basisu\":{\"source\":1}}}")
            .empty());
  CHECK(contains(with("\"scenes\"", "\"extensionsRequired\":[\"ACME_new\"],\"scenes\""),
                 "required extension \"ACME_new\""));
  CHECK(
      with(
          "\"scenes\"",
          "\"extensionsUsed\":[\"ACME_new\"],\"extensionsRequired\":[\"KHR_texture_transform\",\"KHR_mesh_quantization\",\"KHR_materials_clearcoat\"],\"scenes\"")
          .empty());
  std::string index = unit_quad();
  index[90] = 4;
  CHECK(contains(
      error_of([&] { parse_gltf(glb(replaced(json, R"("uri":"quad.bin",)", ""), index), "s.glb", {}); }),
      "index 4"));
}

TEST_CASE("a .glb cut anywhere is an error, never a crash") {
  const std::string whole = glb(
      replaced(quad_json(plain_material, std::string(two_images)), R"("uri":"quad.bin",)", ""), unit_quad());
  CHECK_NOTHROW(parse_gltf(whole, "s.glb", {}));
  for (std::size_t n = 0; n < whole.size(); ++n)
    CHECK(error_of([&] {
            parse_gltf(std::string_view(whole).substr(0, n), "s.glb", {});
          }).starts_with("s.glb"));
}

TEST_CASE("the real scenes read with what their documents say") {
  const auto shared = shared_folder();
  if (!shared) {
    WARN("no folder of reference data: real scenes are not read");
    return;
  }
  struct Row {
    const char* file;
    std::size_t materials, images, cameras;
  };
  for (const Row& row :
       {Row{"flight_helmet/FlightHelmet.gltf", 6, 15, 0}, Row{"mixer/Mixer.gltf", 1, 4, 3},
        Row{"tennis_racquet/TennisRacquet.gltf", 4, 12, 3}, Row{"wicker_chair/WickerChair.gltf", 2, 3, 3},
        Row{"synthetic_a/scene.gltf", 18, 36, 0}}) {
    const GltfScene scene = read_gltf(*shared + "/data/assets/" + row.file, {});
    CHECK((scene.materials.size() == row.materials && scene.images.size() == row.images &&
           scene.cameras.size() == row.cameras));
    for (const PictureFile& image : scene.images)
      CHECK((image.path.empty() ? image.bytes.size() > 100 : std::filesystem::exists(image.path)));
    for (std::size_t i = 0; i < row.materials; ++i)
      CHECK(scene.material_used[i] == (scene.materials[i].name != "m07"));
  }
}

TEST_CASE("a mesh has the triangles of all nodes, moved, with normals and the first UVs") {
  // The square at 48 bytes of positions, then UVs, indices, and a normal (3, 0, 4) for each vertex; a second node draws
  // it twice as wide, farther right and turned over.
  std::string buffer = unit_quad();
  for (int i = 0; i < 4; ++i) buffer += bytes_of<float>({0.6f, 0, 0.8f});
  std::string json = quad_json("[]", R"("extras":0,)", "\"uri\":\"data:;base64," + base64(buffer) + "\",");
  json = replaced(json, "\"byteLength\":92", "\"byteLength\":140");
  json = replaced(json, R"(,"target":34963})", R"(},{"buffer":0,"byteOffset":92,"byteLength":48})");
  json = replaced(json, R"("type":"SCALAR"})",
                  R"("type":"SCALAR"},{"bufferView":3,"componentType":5126,"count":4,"type":"VEC3"})");
  json = replaced(json, R"("nodes":[0])", R"("nodes":[0,1])");
  json = replaced(json, R"({"mesh":0})", R"({"mesh":0},{"mesh":0,"translation":[10,0,0],"scale":[2,1,-1]})");
  json = replaced(json, R"(,"material":0)", "");
  const std::string with_normals = replaced(json, R"("TEXCOORD_0":1)", R"("TEXCOORD_0":1,"NORMAL":3)");
  GltfOptions options;
  CHECK(parsed(with_normals, options).mesh.triangles.empty());  // none was asked for
  options.mesh = true;
  const Mesh mesh = parsed(with_normals, options).mesh;
  REQUIRE(mesh.vertices.size() == 8);
  CHECK(mesh.triangles ==
        std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}});
  CHECK(mesh.has_uvs);
  CHECK(mesh.vertices[2].uv == std::array<float, 2>{1, 1});
  CHECK(mesh.vertices[6].position == std::array<float, 3>{12, 1, 0});
  CHECK(mesh.vertices[1].normal[0] == Approx(0.6));
  // The plane that is scaled by 2 along x has the normal (0.3, 0, -0.8) or its opposite.
  const auto& n = mesh.vertices[6].normal;
  CHECK(n[0] / n[2] == Approx(-0.375));
  CHECK(std::hypot(n[0], n[2]) == Approx(1));

  const auto refused = [&](const std::string& text) { return error_of([&] { parsed(text, options); }); };
  CHECK(contains(refused(json),
                 "s.gltf#/meshes/0/primitives/0/attributes: no NORMAL; expected a mesh with normals"));
  CHECK(contains(refused(replaced(json, R"("TEXCOORD_0":1)", R"("TEXCOORD_0":1,"NORMAL":0)")),
                 "NORMAL: the normal of vertex 0 has no direction"));
  CHECK(contains(refused(replaced(json, R"("TEXCOORD_0":1)", R"("TEXCOORD_0":1,"NORMAL":1)")),
                 "expected VEC3"));
  CHECK(!parsed(replaced(json, R"("TEXCOORD_0":1)", R"("NORMAL":3)"), options).mesh.has_uvs);
  std::string endless = buffer;
  endless.replace(52, 4, bytes_of<float>({std::numeric_limits<float>::infinity()}));
  CHECK(contains(refused(replaced(with_normals, base64(buffer), base64(endless))),
                 "TEXCOORD_0: a UV that is not finite"));
}
