// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/image/mips.h"
#include "core/pack/pack.h"
#include "tests/core/atlas/pack_support.h"
#include "tests/core/scene/small_scene.h"

using namespace etak;
using namespace etak::test;

TEST_CASE("pages made slab by slab are the pages made at once") {
  const TempFolder folder;
  std::string list;
  const auto add = [&](const std::string& name, int width, int height, unsigned seed) {
    add_noise_material(folder, name, width, height, seed);
    list += (list.empty() ? "" : ", ") + manifest_entry(name);
  };
  PackOptions options;
  bool some_slabs = true;
  SECTION("rows of regions, with their mips") {
    for (unsigned i = 0; i < 8; ++i) add("m" + std::to_string(i), 1024, 512, 10 * i);
    std::tie(options.layout.mips, options.output.bleed) =
        GENERATE(std::pair(1, false), std::pair(0, true), std::pair(3, true));
    options.layout.page = 2048;
  }
  SECTION("a region in several slabs") {
    add("large", 2600, 1700, 7);
    options.layout.mips = 1;
    options.layout.gutter = GENERATE(0, 2);
  }
  SECTION("regions side by side in several slabs, and waste below one") {
    add("a", 2000, 1700, 1);
    add("b", 2001, 1602, 2);
    options.layout.mips = 1;
    options.layout.gutter = 0;
  }
  SECTION("a page that is too small for slabs") {
    add("small", 1024, 512, 7);
    options.layout.mips = 4;
    some_slabs = false;
  }
  spit(folder.file("m.json"), "{\"gloss\": \"schueler\", \"materials\": [" + list + "]}");
  // The DDS file needs the page whole.
  PackOptions whole = options;
  whole.output.write.formats = {"png", "dds"};
  const auto stages = [](const PackResult& report) {
    std::string out;
    for (const PackStage& stage : report.stages) out += stage.name + ";";
    return out;
  };
  pack(folder.file("m.json"), folder.file("whole"), whole, built_in_library());
  for (const unsigned threads : {1u, 3u}) {
    options.run.threads = threads;
    const std::string out = folder.file("slabs" + std::to_string(threads));
    const PackResult report = pack(folder.file("m.json"), out, options, built_in_library());
    CHECK((stages(report).find("texels, mips and files;") != std::string::npos) == some_slabs);
    REQUIRE(!report.files.empty());
    for (const std::string& name : report.files)
      if (name.ends_with(".png")) {
        INFO(name);
        const bool same = slurp(out + "/" + name) == slurp(folder.file("whole") + "/" + name);
        CHECK(same);
      }
  }
}

TEST_CASE("a region's mips are those of the region alone") {
  const TempFolder folder;
  add_noise_material(folder, "a", 64, 64, 1);
  add_noise_material(folder, "b", 64, 128, 2);
  add_noise_material(folder, "c", 96, 64, 3);
  PackOptions options;
  options.layout.mips = 3;
  (void)pack_text(folder, manifest_of({manifest_entry("a"), manifest_entry("b"), manifest_entry("c")}),
                  options);
  const AtlasLayout layout = packed_layout(folder);
  for (const AtlasRect& rect : layout.rects) {
    const std::string page = folder.file("out/page" + std::to_string(rect.page));
    const auto cut = [&](const Image8& from, int x, int y, int width, int height) {
      Image8 out(width, height, 4);
      for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) std::copy_n(from.at(x + i, y + j).data(), 4, out.at(i, j).data());
      return out;
    };
    const auto level = [&](const char* texture, int l) {
      const std::string mip = l == 0 ? "" : ".mip" + std::to_string(l);
      return cut(load_png(page + "_" + texture + mip + ".png"), rect.x >> l, rect.y >> l, rect.width >> l,
                 rect.height >> l);
    };
    MipOptions mips;
    mips.levels = rect.mips;
    const MipPair alone = mip_pair(level("diffuse_alpha", 0), level("specular_gloss", 0), mips);
    CHECK(rect.mips >= 2);
    for (int l = 1; l < rect.mips; ++l) {
      CHECK(alone.diffuse_alpha[static_cast<std::size_t>(l)] == level("diffuse_alpha", l));
      CHECK(alone.specular_gloss[static_cast<std::size_t>(l)] == level("specular_gloss", l));
    }
  }
}

TEST_CASE("mips average gloss in the form it has") {
  const TempFolder folder;
  Image8 halves(64, 64, 1);
  for (std::size_t i = 0; i < halves.values.size(); ++i) halves.values[i] = i % 2 == 0 ? 0 : 255;
  add_noise_material(folder, "a", 64, 64, 1);
  save_png(folder.file("a_gloss.png"), halves);
  const auto level_1 = [&](const std::string& form) {
    PackOptions options;
    options.layout.mips = 2;
    (void)pack_text(folder, "{\"gloss\": \"" + form + "\", " + manifest_of({manifest_entry("a")}).substr(1),
                    options);
    const AtlasRect rect = packed_layout(folder).rects.at(0);
    return int{
        load_png(folder.file("out/page0_specular_gloss.mip1.png")).at(rect.x / 2 + 3, rect.y / 2 + 3)[3]};
  };
  // Half of each texel is a mirror, half is fully rough: alpha^2 of 1/2.
  const double roughness = std::pow(0.5, 0.25);
  CHECK(level_1("roughness") == static_cast<int>(255 * roughness + 0.5));
  CHECK(level_1("one_minus_roughness") == static_cast<int>(255 * (1 - roughness) + 0.5));
  // 1/e of 1 and 1/4096, weighted by F0's luminance; between the plain mean and its neighbours.
  CHECK(std::abs(level_1("schueler") - 255 * std::log2(2.0) / 12) <= 25);
}

TEST_CASE("a rough normal map lowers the gloss of the mips, in every form") {
  const TempFolder folder;
  add_noise_material(folder, "a", 64, 64, 1);
  save_png(folder.file("a_gloss.png"), Image8(64, 64, 1, 200));
  // Tilted to the left and to the right by turns: |N| of the mean is the cosine of the tilt.
  Image8 tilted(64, 64, 3, 128);
  const double tilt = 0.5;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      tilted.at(x, y)[0] =
          static_cast<std::uint8_t>(127.5 * (1 + (x % 2 == 0 ? 1 : -1) * std::sin(tilt)) + 0.5);
      tilted.at(x, y)[2] = static_cast<std::uint8_t>(127.5 * (1 + std::cos(tilt)) + 0.5);
    }
  save_png(folder.file("a_normal.png"), tilted);
  PackOptions options;
  options.layout.mips = 2;
  const auto level_1 = [&](const std::string& more, const std::string& form) {
    std::string text = manifest_entry("a");
    text.insert(text.size() - 1, more);
    (void)pack_text(folder, "{\"gloss\": \"" + form + "\", " + manifest_of({text}).substr(1), options);
    const AtlasRect rect = packed_layout(folder).rects.at(0);
    return int{
        load_png(folder.file("out/page0_specular_gloss.mip1.png")).at(rect.x / 2 + 3, rect.y / 2 + 3)[3]};
  };
  const std::string map = ", \"normal\": \"a_normal.png\"";
  CHECK(level_1("", "schueler") == 200);
  CHECK(level_1(map, "schueler") < 150);
  const double spread = (1 - std::cos(tilt)) / std::cos(tilt);
  const auto rougher = [&](double r) { return std::pow(r * r * r * r + 2 * spread, 0.25); };
  CHECK(level_1("", "roughness") == 200);
  CHECK(std::abs(level_1(map, "roughness") - 255 * rougher(200 / 255.0)) <= 2);
  CHECK(std::abs(level_1(map, "one_minus_roughness") - 255 * (1 - rougher(1 - 200 / 255.0))) <= 2);
}

TEST_CASE("mips of a cropped picture are the picture's own, at its sharpest edges too") {
  const TempFolder folder;
  // Black and white by turns, three texels wide: half a texel of drift would change codes by half of white.
  Image8 color(256, 256, 4, 255), specular(256, 256, 4, 255);
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        color.at(x, y)[c] = (x / 3 + y / 5) % 2 == 0 ? 255 : 0;
        specular.at(x, y)[c] = (x / 5 + y / 3) % 2 == 0 ? 200 : 30;
      }
  save_png(folder.file("a.png"), color);
  save_png(folder.file("b.png"), specular);
  spit(folder.file("quad.bin"), quad_buffer({0.13f, 0.21f, 0.83f, 0.21f, 0.83f, 0.773f, 0.13f, 0.773f}));
  spit(folder.file("scene.gltf"),
       quad_json(
           R"([{"name":"m","pbrMetallicRoughness":{},"extensions":{"KHR_materials_pbrSpecularGlossiness":
               {"diffuseTexture":{"index":0},"specularGlossinessTexture":{"index":1}}}}])",
           R"("images":[{"uri":"a.png"},{"uri":"b.png"}],"textures":[{"source":0},{"source":1}],)"));
  PackOptions options;
  options.layout.mips = 4;
  (void)pack(folder.file("scene.gltf"), folder.file("out"), options, built_in_library());
  const AtlasLayout layout = packed_layout(folder);
  REQUIRE(layout.rects.size() == 1);
  const AtlasRect& rect = layout.rects[0];
  CHECK(rect.crop.width < 256);
  REQUIRE(rect.mips >= 3);
  MipOptions mips;
  mips.levels = rect.mips;
  const MipPair whole = mip_pair(color, specular, mips);
  for (int l = 1; l < rect.mips; ++l) {
    const std::string end = ".mip" + std::to_string(l) + ".png";
    const Image8 a = load_png(folder.file("out/page0_diffuse_alpha" + end)),
                 b = load_png(folder.file("out/page0_specular_gloss" + end));
    int worst = 0;
    for (int y = 0; y < rect.height >> l; ++y)
      for (int x = 0; x < rect.width >> l; ++x)
        for (std::size_t c = 0; c < 3; ++c) {
          const int column = (rect.crop.x >> l) + x, row = (rect.crop.y >> l) + y;
          const int on_page_x = (rect.x >> l) + x, on_page_y = (rect.y >> l) + y;
          const auto level = static_cast<std::size_t>(l);
          worst = std::max(
              {worst, std::abs(a.at(on_page_x, on_page_y)[c] - whole.diffuse_alpha[level].at(column, row)[c]),
               std::abs(b.at(on_page_x, on_page_y)[c] - whole.specular_gloss[level].at(column, row)[c])});
        }
    INFO("level " << l);
    CHECK(worst == 0);
  }
}
