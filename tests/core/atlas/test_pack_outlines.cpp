// SPDX-License-Identifier: Apache-2.0
// Islands by outline beside what else is asked of a scene; tests/random_scenes compares their stored levels with the source.
#include <catch2/catch.hpp>
#include <cmath>

#include "core/color/srgb.h"
#include "tests/core/atlas/pack_support.h"
#include "tests/core/atlas/scene_support.h"
#include "tests/core/scene/small_scene.h"

using namespace etak;
using namespace etak::test;

namespace {

// Five narrow bands of two triangles across a picture of 128 x 128, most of whose boxes is empty, and a square.
std::string bands(const TempFolder& folder) {
  std::vector<float> positions, uvs;
  const auto add = [&](const std::array<std::pair<float, float>, 4>& corners) {
    for (const std::size_t i : {0, 1, 2, 0, 2, 3}) {
      const auto [u, v] = corners[i];
      uvs.insert(uvs.end(), {u, v});
      positions.insert(positions.end(), {u, v, 0});
    }
  };
  for (int band = 0; band < 5; ++band) {
    const float from = 0.05F + 0.16F * static_cast<float>(band);
    add({{{from, 0.1F}, {from + 0.02F, 0.1F}, {from + 0.22F, 0.9F}, {from + 0.2F, 0.9F}}});
  }
  add({{{0.8F, 0.02F}, {0.98F, 0.02F}, {0.98F, 0.3F}, {0.8F, 0.3F}}});
  spit(folder.file("bands.bin"), bytes_of(positions) + bytes_of(uvs));
  // Noise, but smooth around the square.
  Image8 base = noise(128, 128, 3, 7), rough = noise(128, 128, 3, 8);
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x) {
      if (x > 98 && y < 44)
        for (std::size_t c = 0; c < 3; ++c)
          base.at(x, y)[c] = rough.at(x, y)[c] = static_cast<std::uint8_t>(60 + x / 2);
      rough.at(x, y)[2] = 0;
    }
  save_png(folder.file("base.png"), base);
  save_png(folder.file("gloss.png"), rough);
  spit(folder.file("scene.gltf"),
       R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"material":0}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":36,"type":"VEC3","min":[0.05,0.02,0],"max":[0.98,0.9,0]},
{"bufferView":1,"componentType":5126,"count":36,"type":"VEC2"}],
"bufferViews":[{"buffer":0,"byteLength":432},{"buffer":0,"byteOffset":432,"byteLength":288}],
"buffers":[{"uri":"bands.bin","byteLength":720}],
"samplers":[{"magFilter":9729,"minFilter":9987}],
"textures":[{"source":0,"sampler":0},{"source":1,"sampler":0}],
"images":[{"uri":"base.png"},{"uri":"gloss.png"}],"materials":[{"name":"m","pbrMetallicRoughness":{"baseColorTexture":{"index":0},
"metallicRoughnessTexture":{"index":1}}}]})");
  return folder.file("scene.gltf");
}

std::size_t outlines_of(const AtlasLayout& layout) {
  std::map<int, int> pieces;
  for (const AtlasRect& rect : layout.rects) ++pieces[rect.island];
  return static_cast<std::size_t>(
      std::ranges::count_if(pieces, [](const auto& each) { return each.second > 1; }));
}

std::uint64_t page_texels(const PackResult& result) {
  std::uint64_t out = 0;
  for (const PlannedPage& page : result.pages)
    out += static_cast<std::uint64_t>(page.width) * static_cast<std::uint64_t>(page.height);
  return out;
}

}  // namespace

TEST_CASE(
    "outlines are packed where pages hold mips, are bled or are floats, and take less than boxes there") {
  const TempFolder folder;
  const std::string scene = bands(folder);
  PackOptions mips, bled, floats;
  mips.output.write.formats = {"ktx2", "dds"};
  bled.output.bleed = true;
  floats.output.write.formats = {"exr"};
  floats.layout.mips = 3;
  for (PackOptions options : {mips, bled, floats}) {
    options.layout.gutter = 2;
    const PackResult outlines = pack_scene(scene, folder.file("out"), true, options);
    CHECK(outlines_of(outlines.layout) >= 4);
    options.layout.form = PageForm::mixed;  // which takes boxes
    CHECK(page_texels(outlines) < page_texels(pack_scene(scene, folder.file("out"), true, options)));
  }
}

TEST_CASE("floats of outlines are what their codes are, on every level") {
  const TempFolder folder;
  PackOptions options;
  options.output.write.formats = {"png", "exr"};
  options.layout.mips = options.layout.gutter = 2;
  const PackResult result = pack_scene(bands(folder), folder.file("out"), true, options);
  REQUIRE(outlines_of(result.layout) >= 4);
  REQUIRE(result.levels == 2);
  for (const std::string texture : {"diffuse_alpha", "specular_gloss"})
    for (const std::string level : {"", ".mip1"}) {
      const std::string file = folder.file("out/page0_" + texture + level);
      const Image8 codes = load_png(file + ".png");
      const auto values = std::get<Image>(load_picture(slurp(file + ".exr"), file, picture_door()).pixels);
      REQUIRE(values.pixel_count() == codes.pixel_count());
      double worst = 0;
      for (std::size_t i = 0; i < codes.values.size(); ++i) {
        const double value = double{values.values[i]};
        worst = std::max(worst, std::abs(255 * (i % 4 == 3 ? value : srgb_encode(value)) - codes.values[i]));
      }
      INFO(texture << level);
      CHECK(worst <= (level.empty() ? 0.51 : 1.01));
    }
}

TEST_CASE("a smooth island is stored with fewer texels beside outlines that keep theirs") {
  const TempFolder folder;
  const std::string scene = bands(folder);
  PackOptions options;
  options.layout.gutter = 1;
  const PackResult whole = pack_scene(scene, folder.file("out"), true, options);
  options.leave_out.max_error = 3;
  const PackResult fewer = pack_scene(scene, folder.file("out"), true, options);
  CHECK(outlines_of(fewer.layout) >= 4);
  REQUIRE(fewer.reduced.size() == 1);
  CHECK(fewer.reduced[0].stored_width <= fewer.reduced[0].width / 2);
  CHECK(page_texels(fewer) < page_texels(whole));
  CHECK(fewer.region_texels < whole.region_texels);
  CHECK(fewer.left_out.after.texels == fewer.region_texels);
}
