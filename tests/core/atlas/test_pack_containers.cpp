// SPDX-License-Identifier: Apache-2.0
// A scene as one file, and with pictures of lossless WebP.
#include <catch2/catch.hpp>
#include <filesystem>
#include <set>

#include "core/image/picture_bytes.h"
#include "tests/core/atlas/pack_support.h"
#include "tests/core/atlas/scene_support.h"
#include "tests/core/scene/small_scene.h"
#include "tests/core/scene/written_scene.h"

using namespace etak;
using namespace etak::test;

namespace {

// A square with colours and a normal map, whose UVs read a part of each.
void write_textured(const TempFolder& folder, bool inside) {
  save_png(folder.file("a.png"), noise(64, 64, 3, 1));
  Image8 smooth(64, 32, 3);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 64; ++x) {
      const auto texel = smooth.at(x, y);
      texel[0] = static_cast<std::uint8_t>(100 + x / 2);
      texel[1] = static_cast<std::uint8_t>(128 + y / 3);
      texel[2] = 240;
    }
  save_png(folder.file("n.png"), smooth);
  std::string buffer = quad_buffer({0.1f, 0.1f, 0.6f, 0.1f, 0.6f, 0.5f, 0.1f, 0.5f});
  const std::string material =
      R"([{"name":"m","pbrMetallicRoughness":{"metallicFactor":0,"baseColorTexture":{"index":0}},"normalTexture":{"index":1}}])";
  std::string images =
      R"("images":[{"uri":"a.png"},{"uri":"n.png"}],"textures":[{"source":0},{"source":1}],)";
  std::string json = quad_json(material, images, "");
  if (!inside) {
    spit(folder.file("quad.bin"), buffer);
    return spit(folder.file("s.gltf"), quad_json(material, images));
  }
  const std::string normal = slurp(folder.file("n.png"));
  json = replaced(json, R"({"uri":"n.png"})", R"({"bufferView":3,"mimeType":"image/png"})");
  json = replaced(
      json, R"("target":34963})",
      R"("target":34963},{"buffer":0,"byteOffset":92,"byteLength":)" + std::to_string(normal.size()) + "}");
  json =
      replaced(json, R"("byteLength":92}])", R"("byteLength":)" + std::to_string(92 + normal.size()) + "}]");
  spit(folder.file("s.glb"), glb(json, buffer + normal));
}

std::set<std::string> names_in(const std::string& folder) {
  std::set<std::string> out;
  for (const auto& each : std::filesystem::directory_iterator(folder))
    out.insert(each.path().filename().string());
  return out;
}

// The texels of every picture that the first material of a scene reads, as RGBA.
std::vector<std::vector<std::uint8_t>> texels_of(const std::string& path) {
  const GltfScene scene = read_gltf(path, {});
  std::vector<std::vector<std::uint8_t>> out;
  const GltfMaterial& m = scene.materials.at(0);
  for (const auto& texture : {m.base_color_texture, m.normal_texture}) {
    REQUIRE(texture);
    const auto rows = open_picture(scene.images[static_cast<std::size_t>(texture->image)], picture_door());
    auto& texels = out.emplace_back(4 * static_cast<std::size_t>(rows->header().width) *
                                    static_cast<std::size_t>(rows->header().height));
    rows->read_rows(texels.data(), 4 * static_cast<std::size_t>(rows->header().width), rows->header().height);
  }
  return out;
}

}  // namespace

TEST_CASE("a scene in one file, and with WebP, has the texels and UVs of the scene beside its files") {
  for (const bool inside : {false, true}) {
    const TempFolder folder;
    write_textured(folder, inside);
    const std::string from = folder.file(inside ? "s.glb" : "s.gltf");
    std::vector<std::vector<std::uint8_t>> texels;
    std::vector<std::array<std::array<float, 2>, 3>> uvs;
    std::uint64_t disk = 0;
    for (const bool webp : {false, true})
      for (const bool one : {false, true}) {
        PackOptions options;
        options.output.forms = {GltfForm::metal_rough};
        options.output.one_file = one;
        options.output.webp = webp;
        const std::string out = folder.file("out" + std::to_string(2 * webp + one));
        CAPTURE(inside, webp, one);
        const PackResult result = pack_scene(from, out, false, options);
        const std::string scene = out + (one ? "/scene.glb" : "/scene.gltf");
        const std::set<std::string> names = names_in(out);
        CHECK(names.contains(one ? "scene.gltf" : "scene.glb") == false);
        if (one)
          for (const std::string& name : names)
            CHECK((name == "scene.glb" || name == "layout.json" || name.starts_with("page0_diffuse_alpha") ||
                   name.starts_with("page0_specular_gloss")));
        if (has_validator()) CHECK(validator_errors(scene, {out}) == "");
        if (texels.empty()) {
          texels = texels_of(scene);
          uvs = read_gltf(scene, {}).uses[0].uv[0];
        }
        CHECK(texels_of(scene) == texels);
        CHECK(read_gltf(scene, {}).uses[0].uv[0] == uvs);
        CHECK(contains(*read_gltf(scene, {}).json, "EXT_texture_webp") == webp);
        REQUIRE((result.totals && result.totals->scene));
        CHECK(result.totals->scene->files == 2);
        if (!webp) disk = result.totals->scene->disk;
        if (webp) CHECK(result.totals->scene->disk < disk);
      }
  }
}

TEST_CASE("WebP keeps every code, under alpha 0 too, of pictures of one to four channels") {
  for (int channels = 1; channels <= 4; ++channels) {
    const Image8 from = noise(33, 17, channels, static_cast<std::uint64_t>(channels));
    Image fractions(33, 17, channels);
    for (std::size_t i = 0; i < from.values.size(); ++i)
      fractions.values[i] = static_cast<float>(from.values[i]) / 255;
    const std::string file = webp_bytes(fractions);
    CHECK_FALSE(is_lossy(file, "webp", "webp"));
    const auto read = open_picture(file, "a.webp", picture_door()), wanted = rows_of(from);
    std::vector<std::uint8_t> one(4 * 33), other(4 * 33);
    for (int y = 0; y < 17; ++y) {
      read->read_rows(one.data(), one.size(), 1);
      wanted->read_rows(other.data(), other.size(), 1);
      CHECK(one == other);
    }
  }
}
