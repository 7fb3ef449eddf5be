// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <random>

#include "core/scene/gltf.h"
#include "core/scene/uv_use.h"
#include "tests/core/scene/small_scene.h"
#include "tests/core/scene/written_scene.h"

using namespace etak;
using namespace etak::test;

namespace {

/// Source texel under each texel of a page; -1 where none lies.
struct PageSources {
  int width, height;
  std::vector<int> source;
  PageSources(int w, int h) : width(w), height(h), source(static_cast<std::size_t>(w * h), -1) {}
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
                            int width, int height, const PageSources& page) {
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
PageSources in_a_row(const std::vector<Island>& islands, int width, int height, AtlasMaterial& out) {
  int page_width = 0, page_height = 0;
  for (std::size_t i = 0; i < islands.size(); ++i) {
    page_width += i % 2 ? islands[i].height : islands[i].width;
    page_height = std::max(page_height, i % 2 ? islands[i].width : islands[i].height);
  }
  PageSources page(page_width, page_height);
  int x = 0;
  for (std::size_t i = 0; i < islands.size(); ++i) {
    const bool rotated = i % 2 == 1;
    const std::array<int, 4> box{islands[i].x, islands[i].y, islands[i].width, islands[i].height};
    const std::array<int, 4> place{x, 0, rotated ? box[3] : box[2], rotated ? box[2] : box[3]};
    out.islands.push_back(
        {box, region_transform({box, width, height, place, rotated, page_width, page_height})});
    page.put(box, width, place, rotated);
    x += place[2];
  }
  out.texture_width = width;
  out.texture_height = height;
  return page;
}

}  // namespace

TEST_CASE("a turned region is found texel by texel through the material's own transform") {
  const std::string material = R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0,
"extensions":{"KHR_texture_transform":{"offset":[0.25,0.625],"scale":[0.5,0.25],"rotation":ROT}}}}}])";
  for (const char* rotation : {"0", "1.5707963267948966"})
    for (const bool turned : {false, true}) {
      const GltfScene scene = parsed(quad_json(replaced(material, "ROT", rotation), std::string(two_images)));
      const int width = 32, height = 16;
      const TexelUse use = texel_use(scene, 0, *leading_texture(scene.materials[0]), width, height);
      REQUIRE(!use.tiles);
      PageSources page(64, 64);
      const std::array<int, 4> place{20, 30, turned ? use.box[3] : use.box[2],
                                     turned ? use.box[2] : use.box[3]};
      page.put(use.box, width, place, turned);
      GltfOutput output;
      output.images = {"p.png"};
      AtlasMaterial m;
      m.material = 0;
      m.region = *composed(region_transform({use.box, width, height, place, turned, 64, 64}), use.fold);
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
  PageSources page(64, 128);
  page.put({0, 0, 32, 32}, 32, {8, 16, 32, 32}, false);
  GltfOutput output;
  output.images = {"p.png"};
  AtlasMaterial m;
  m.material = 0;
  m.region = region_transform({{0, 0, 32, 32}, 32, 32, {8, 16, 32, 32}, false, 64, 128});
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
    const PageSources page = in_a_row(islands(use, 0, 64), 16, 16, m);
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
    std::vector<PageSources> pages;
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
