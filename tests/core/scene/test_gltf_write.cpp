// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>

#include "core/scene/gltf.h"
#include "core/scene/uv_use.h"
#include "tests/core/scene/small_scene.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;
using Json = nlohmann::json;

namespace {

const std::vector<const char*> real_scenes{"flight_helmet/FlightHelmet.gltf", "mixer/Mixer.gltf",
                                           "tennis_racquet/TennisRacquet.gltf",
                                           "wicker_chair/WickerChair.gltf", "synthetic_a/scene.gltf"};

bool has_validator() {
  static const bool has = std::system("node -e \"require('gltf-validator')\" >/dev/null 2>&1") == 0;
  if (!has) WARN("no node with gltf-validator (NODE_PATH): what is written is not validated");
  return has;
}

/// Messages of severity 0 (errors) that the Khronos validator has for a document; pictures and other files
/// are looked for in `folders`.
std::string validator_errors(const std::string& gltf, const std::vector<std::string>& folders) {
  const TempFolder temp;
  std::string list;
  for (const auto& folder : folders) list += "'" + folder + "',";
  spit(
      temp.file("check.js"),
      "const v=require('gltf-validator'),fs=require('fs'),path=require('path');const folders=[" + list + R"(];
v.validateBytes(new Uint8Array(fs.readFileSync(process.argv[2])),{maxIssues:0,externalResourceFunction:uri=>new Promise((ok,no)=>{
for(const f of folders){const p=path.join(f,decodeURIComponent(uri));if(fs.existsSync(p))return ok(new Uint8Array(fs.readFileSync(p)));}
no('no file '+uri);})}).then(r=>{for(const m of r.issues.messages)if(m.severity===0)console.log(m.code+' '+m.message+' '+m.pointer);
console.log('checked');});)");
  const std::string out = temp.file("out");
  if (std::system(("node " + temp.file("check.js") + " " + gltf + " >" + out + " 2>&1").c_str()) != 0)
    return slurp(out);
  const std::string text = slurp(out);
  return text == "checked\n" ? "" : text;
}

/// Writes a scene and reads it again.
struct Written {
  TempFolder folder;
  Json json;
  std::string buffer;
  GltfScene scene;
  Written(const GltfScene& from, const GltfOutput& output, const std::vector<std::string>& folders = {}) {
    const std::string text = write_gltf(from, output, buffer);
    spit(folder.file("out.gltf"), text);
    if (!buffer.empty()) spit(folder.file("scene.bin"), buffer);
    // The smallest PNG there is: one grey pixel.
    const std::string png(
        "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\x08\0\0\0\0\x3a\x7e\x9b\x55\0\0\0\nIDATx\x9c\x63\x60\0"
        "\0\0\2\0\1\x48\xaf\xa4\x71\0\0\0\0IEND\xae\x42\x60\x82",
        67);
    for (const auto& image : output.images) spit(folder.file(image), png);
    json = Json::parse(text);
    scene = read_gltf(folder.file("out.gltf"), from.options);
    std::vector<std::string> all{folder.path()};
    all.insert(all.end(), folders.begin(), folders.end());
    if (has_validator()) CHECK(validator_errors(folder.file("out.gltf"), all) == "");
  }
};

/// Source texel under each texel of a page; -1 where none lies.
struct Page {
  int width, height;
  std::vector<int> source;
  Page(int w, int h) : width(w), height(h), source(static_cast<std::size_t>(w * h), -1) {}
  void put(const std::array<int, 4>& box, int texture_width, const std::array<int, 4>& place, bool rotated) {
    for (int j = 0; j < box[3]; ++j)
      for (int i = 0; i < box[2]; ++i) {
        const int x = place[0] + (rotated ? box[3] - 1 - j : i), y = place[1] + (rotated ? i : j);
        source[static_cast<std::size_t>(y * width + x)] = (box[1] + j) * texture_width + box[0] + i;
      }
  }
};

/// Looks up texels of every triangle of a material before and after; returns how many lookups were compared.
std::size_t compare_lookups(const GltfScene& before, const GltfScene& after, int material, int new_material,
                            int width, int height, const Page& page) {
  const GltfTexture old_texture = *leading_texture(before.materials[static_cast<std::size_t>(material)]);
  const GltfTexture new_texture = *leading_texture(after.materials[static_cast<std::size_t>(new_material)]);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(0, 1);
  std::size_t compared = 0, wrong = 0;
  REQUIRE(before.uses.size() == after.uses.size());
  for (std::size_t u = 0; u < before.uses.size(); ++u) {
    if (before.uses[u].material != material) continue;
    REQUIRE(after.uses[u].material == new_material);
    const auto& old_uvs = before.uses[u].uv[old_texture.uv_set];
    const auto& new_uvs = after.uses[u].uv[new_texture.uv_set];
    REQUIRE(old_uvs.size() == new_uvs.size());
    for (std::size_t t = 0; t < old_uvs.size(); ++t)
      for (int i = 0; i < 4; ++i) {
        double a = share(random), b = share(random);
        if (a + b > 1) {
          a = 1 - a;
          b = 1 - b;
        }
        const auto inside = [&](const auto& c) {
          Uv out;
          for (std::size_t k = 0; k < 2; ++k)
            out[k] = double{c[0][k]} + a * (double{c[1][k]} - double{c[0][k]}) +
                     b * (double{c[2][k]} - double{c[0][k]});
          return out;
        };
        Uv from = transformed(old_texture.transform, inside(old_uvs[t]));
        const Uv to = transformed(new_texture.transform, inside(new_uvs[t]));
        for (const bool v : {false, true}) {
          const Wrap wrap = v ? old_texture.sampler.wrap_v : old_texture.sampler.wrap_u;
          double& c = from[v];
          const double period = std::floor(c);
          if (wrap == Wrap::repeat) c -= period;
          if (wrap == Wrap::mirrored) c = std::fmod(period, 2) != 0 ? 1 - (c - period) : c - period;
        }
        const double x = from[0] * width, y = from[1] * height;
        // Close to the border of a texel single precision decides.
        const auto near_border = [](double c) { return std::abs(c - std::round(c)) < 0.02; };
        if (near_border(x) || near_border(y) || x < 0 || y < 0 || x > width || y > height) continue;
        const int expected = static_cast<int>(y) * width + static_cast<int>(x);
        const int px = static_cast<int>(std::floor(to[0] * page.width)),
                  py = static_cast<int>(std::floor(to[1] * page.height));
        ++compared;
        if (px < 0 || py < 0 || px >= page.width || py >= page.height ||
            page.source[static_cast<std::size_t>(py * page.width + px)] != expected)
          ++wrong;
      }
  }
  CHECK(wrong == 0);
  return compared;
}

/// Places islands of a texture in one row of a page of their own, every second one turned.
Page in_a_row(const std::vector<Island>& islands, int width, int height, AtlasMaterial& out) {
  int page_width = 0, page_height = 0;
  for (std::size_t i = 0; i < islands.size(); ++i) {
    page_width += i % 2 ? islands[i].height : islands[i].width;
    page_height = std::max(page_height, i % 2 ? islands[i].width : islands[i].height);
  }
  Page page(page_width, page_height);
  int x = 0;
  for (std::size_t i = 0; i < islands.size(); ++i) {
    const bool rotated = i % 2 == 1;
    const std::array<int, 4> box{islands[i].x, islands[i].y, islands[i].width, islands[i].height};
    const std::array<int, 4> place{x, 0, rotated ? box[3] : box[2], rotated ? box[2] : box[3]};
    out.islands.push_back(
        {box, region_transform(box, width, height, place, rotated, page_width, page_height)});
    page.put(box, width, place, rotated);
    x += place[2];
  }
  out.texture_width = width;
  out.texture_height = height;
  return page;
}

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
  const std::string text = [&] {
    std::string buffer;
    return write_gltf(scene, output, buffer);
  }();
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
  std::string buffer;
  const Json kept = Json::parse(write_gltf(parsed(json), {}, buffer));
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

  const Json without = Json::parse(write_gltf(parsed(json, {.scene = {}, .variants = false}), {}, buffer));
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
  std::string buffer;
  const std::string text = write_gltf(scene, output, buffer);
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

TEST_CASE("a turned region is found texel by texel through the material's own transform") {
  const std::string material = R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0,
"extensions":{"KHR_texture_transform":{"offset":[0.25,0.625],"scale":[0.5,0.25],"rotation":ROT}}}}}])";
  for (const char* rotation : {"0", "1.5707963267948966"})
    for (const bool turned : {false, true}) {
      const GltfScene scene = parsed(quad_json(replaced(material, "ROT", rotation), std::string(two_images)));
      const int width = 32, height = 16;
      const TexelUse use = texel_use(scene, 0, *leading_texture(scene.materials[0]), width, height);
      REQUIRE(!use.tiles);
      Page page(64, 64);
      const std::array<int, 4> place{20, 30, turned ? use.box[3] : use.box[2],
                                     turned ? use.box[2] : use.box[3]};
      page.put(use.box, width, place, turned);
      GltfOutput output;
      output.images = {"p.png"};
      AtlasMaterial m;
      m.material = 0;
      m.region = *composed(region_transform(use.box, width, height, place, turned, 64, 64), use.fold);
      m.diffuse_alpha_image = 0;
      output.materials = {m};
      const Written written(scene, output);
      CHECK(!written.json["meshes"][0]["primitives"][0]["attributes"].contains("TEXCOORD_1"));
      CHECK(compare_lookups(scene, written.scene, 0, 0, width, height, page) > 0);
    }
}

TEST_CASE("a shear that no transform can say is written into the UVs") {
  const GltfScene scene = parsed(quad_json(R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0,
"extensions":{"KHR_texture_transform":{"offset":[0.25,0.5],"scale":[0.25,0.25],"rotation":0.5}}}}}])",
                                           std::string(two_images)));
  Page page(64, 128);
  page.put({0, 0, 32, 32}, 32, {8, 16, 32, 32}, false);
  GltfOutput output;
  output.images = {"p.png"};
  AtlasMaterial m;
  m.material = 0;
  m.region = region_transform({0, 0, 32, 32}, 32, 32, {8, 16, 32, 32}, false, 64, 128);
  m.diffuse_alpha_image = 0;
  output.materials = {m};
  const Written written(scene, output);
  CHECK(leading_texture(written.scene.materials[0])->transform == UvTransform{});
  CHECK(compare_lookups(scene, written.scene, 0, 0, 32, 32, page) > 0);
}

TEST_CASE("triangles in periods of their own are brought together, and shared vertices doubled") {
  // A strip of two squares over u = 0..2, joined at u = 1: repeat brings the second back to the first's
  // texels.
  std::string buffer = bytes_of<float>({0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0}) +
                       bytes_of<float>({0, 0, 1, 0, 2, 0, 0, 1, 1, 1, 2, 1}) +
                       bytes_of<std::uint16_t>({0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4});
  for (const char* wrap : {"10497", "33648"}) {
    std::string json = quad_json(
        R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}},"normalTexture":{"index":0}}])",
        std::string(
            R"("images":[{"uri":"p.png"}],"textures":[{"source":0,"sampler":0}],"samplers":[{"wrapS":)") +
            wrap + "}],",
        "\"uri\":\"data:application/octet-stream;base64," + base64(buffer) + "\",");
    json = replaced(json, "\"byteLength\":92", "\"byteLength\":144");
    json = replaced(json, R"("byteLength":48)", R"("byteLength":72)");
    json = replaced(json, R"("byteOffset":48,"byteLength":32)", R"("byteOffset":72,"byteLength":48)");
    json = replaced(json, R"("byteOffset":80,"byteLength":12)", R"("byteOffset":120,"byteLength":24)");
    json = replaced(json, R"("count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,0])",
                    R"("count":6,"type":"VEC3","min":[0,0,0],"max":[2,1,0])");
    json = replaced(json, R"("count":4)", R"("count":6)");
    json = replaced(json, R"("count":6,"type":"SCALAR")", R"("count":12,"type":"SCALAR")");
    const GltfScene scene = parsed(json);
    const TexelUse use = texel_use(scene, 0, *leading_texture(scene.materials[0]), 16, 16);
    REQUIRE((use.tiles && use.foldable));
    GltfOutput output;
    output.images = {"p.png"};
    AtlasMaterial m;
    m.material = 0;
    m.diffuse_alpha_image = 0;
    const Page page = in_a_row(islands(use, 0, 64), 16, 16, m);
    output.materials = {m};
    const Written written(scene, output);
    CHECK(compare_lookups(scene, written.scene, 0, 0, 16, 16, page) > 0);
    // The normal map goes on reading the old UVs.
    CHECK(written.scene.materials[0].base_color_texture->uv_set == 1);
    CHECK(written.scene.materials[0].normal_texture->uv_set == 0);
    CHECK(written.scene.uses[0].uv[0] == scene.uses[0].uv[0]);
    CHECK(written.scene.uses[0].world_area == scene.uses[0].world_area);
    // Positions, UVs and indices were replaced by those with two vertices more; the old ones are not kept.
    CHECK(written.json["accessors"].size() == 4);
    CHECK(written.buffer.size() == 8 * (12 + 8 + 8) + 24);
  }
}

TEST_CASE("output that contradicts itself, and scenes that cannot be kept, are refused") {
  const GltfScene scene = parsed(
      quad_json(R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}])", std::string(two_images)));
  AtlasMaterial m;
  m.material = 0;
  const auto refusal = [&](const AtlasMaterial& material, const GltfScene& from) {
    GltfOutput output;
    output.materials = {material};
    std::string buffer;
    return error_of([&] { write_gltf(from, output, buffer); });
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

TEST_CASE("islands of real scenes: every lookup finds its texel, and the file validates") {
  const auto shared = shared_folder();
  if (!shared) {
    WARN("no folder of reference data: real scenes are not written");
    return;
  }
  for (const char* file : {"flight_helmet/FlightHelmet.gltf", "tennis_racquet/TennisRacquet.gltf",
                           "wicker_chair/WickerChair.gltf"}) {
    const std::string path = *shared + "/data/assets/" + file;
    const GltfScene scene = read_gltf(path, {});
    GltfOutput output;
    output.images = {"a.png", "b.png", "r.png"};
    std::vector<Page> pages;
    const int size = 512;
    for (const GltfMaterial& material : scene.materials) {
      AtlasMaterial m;
      m.material = material.index;
      m.diffuse_alpha_image = 0;
      m.specular_gloss_image = 1;
      m.roughness_image = 2;
      const TexelUse use = texel_use(scene, material.index, *leading_texture(material), size, size);
      pages.push_back(in_a_row(islands(use, 0, 256), size, size, m));
      output.materials.push_back(m);
    }
    const Written written(scene, output, {std::filesystem::path(path).parent_path().string()});
    for (const GltfMaterial& material : scene.materials)
      CHECK(compare_lookups(scene, written.scene, material.index, material.index, size, size,
                            pages[static_cast<std::size_t>(material.index)]) > 1000);
  }
}
