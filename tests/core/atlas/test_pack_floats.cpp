// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <random>

#include "core/base/error.h"
#include "core/color/srgb.h"
#include "core/image/dilate.h"
#include "core/image/image_io.h"
#include "core/image/mips.h"
#include "core/material/f0.h"
#include "core/pack/pack.h"
#include "tests/core/atlas/pack_support.h"
#include "tests/core/image/tiff_files.h"

using namespace etak;
using namespace etak::test;

namespace {

PackOptions with_floats(const std::vector<std::string>& formats) {
  PackOptions options;
  options.output.write.formats = formats;
  options.input.pictures.door = picture_door();
  return options;
}

// Values that halves hold exactly, some below 0 and above 1.
Image halves(int width, int height, int channels, unsigned seed) {
  std::mt19937 random(seed);
  Image out(width, height, channels);
  for (float& v : out.values) v = static_cast<float>(static_cast<int>(random() % 1300) - 100) / 1024;
  return out;
}

Image16 codes_16(int width, int height, int channels, unsigned seed) {
  std::mt19937 random(seed);
  Image16 out(width, height, channels);
  for (auto& each : out.values) each = static_cast<std::uint16_t>(random());
  return out;
}

const float* texel(const Image& page, const AtlasRect& rect, int x, int y) {
  if (rect.rotated) return page.at(rect.x + rect.width - 1 - y, rect.y + x).data();
  return page.at(rect.x + x, rect.y + y).data();
}

void save_deep(const TempFolder& folder) {
  write_exr(folder.file("d.exr"), halves(40, 24, 3, 1), false, false);
  write_exr(folder.file("s.exr"), halves(40, 24, 3, 2), true, false);
  test::write_tiff(folder.file("g.tif"), codes_16(40, 24, 1, 3));
  save_png(folder.file("a.png"), noise(40, 24, 1, 4));
  save_png(folder.file("d8.png"), noise(30, 50, 3, 5));
}

const std::string deep = R"({"materials": [
  {"name": "deep", "diffuse": "d.exr", "specular": "s.exr", "gloss": "g.tif", "alpha": "a.png"},
  {"name": "gilt", "diffuse": "d8.png", "specular": "gold", "gloss": 0.3},
  {"name": "gold", "specular": "gold", "gloss": 0.3}]})";

}  // namespace

TEST_CASE("float files hold the sources' own values: halves, floats, 16 bits, and F0 to the last bit") {
  for (const bool rotate : {false, true}) {
    const TempFolder folder;
    save_deep(folder);
    PackOptions options = with_floats({"png", "exr", "tiff"});
    options.layout.rotate = rotate;
    const PackResult report = pack_text(folder, deep, options);
    const AtlasLayout layout = packed_layout(folder);
    const Image d = read_image(folder.file("d.exr")), s = read_image(folder.file("s.exr"));
    CHECK(d == halves(40, 24, 3, 1));
    const Image8 alpha = load_png(folder.file("a.png")), d8 = load_png(folder.file("d8.png"));
    const Image16 g = codes_16(40, 24, 1, 3);
    const LinearRgb gold =
        F0Solver(F0Options{}).solve(built_in_library().find("gold")->preferred_dataset().optics).srgb_linear;
    REQUIRE(gold.r > 1);
    for (const std::string ending : {".exr", ".tiff"}) {
      INFO(ending << (rotate ? " rotated" : ""));
      const AtlasRect& rect = rect_named(layout, "deep");
      const std::string page = folder.file("out/page" + std::to_string(rect.page) + "_");
      const Image a = read_image(page + "diffuse_alpha" + ending),
                  b = read_image(page + "specular_gloss" + ending);
      std::size_t wrong = 0;
      for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 40; ++x) {
          const float *at = texel(a, rect, x, y), *bt = texel(b, rect, x, y);
          for (std::size_t c = 0; c < 3; ++c) wrong += (at[c] != d.at(x, y)[c]) + (bt[c] != s.at(x, y)[c]);
          wrong += at[3] != static_cast<float>(alpha.at(x, y)[0] / 255.0);
          wrong += bt[3] != static_cast<float>(g.at(x, y)[0] / 65535.0);
        }
      CHECK(wrong == 0);
      const AtlasRect& gilt = rect_named(layout, "gilt");
      const Image ga =
          read_image(folder.file("out/page" + std::to_string(gilt.page) + "_diffuse_alpha" + ending));
      CHECK(texel(ga, gilt, 7, 9)[1] == static_cast<float>(srgb_decode(d8.at(7, 9)[1] / 255.0)));
      if (!layout.pages[static_cast<std::size_t>(gilt.page)].files[1].empty()) {
        const Image gb =
            read_image(folder.file("out/page" + std::to_string(gilt.page) + "_specular_gloss" + ending));
        CHECK(texel(gb, gilt, 7, 9)[0] == static_cast<float>(gold.r));
      }
      CHECK(read_picture_header(page + "specular_gloss" + ending).floating);
    }
    // A material of numbers alone has them in the table, as they are.
    const AtlasMaterialRow& row = row_named(layout, "gold");
    CHECK_FALSE(row.texels);
    CHECK(*row.value[4] == Approx(gold.r).epsilon(1e-7));
    CHECK(*row.value[6] == Approx(gold.b).epsilon(1e-7));
    CHECK(*row.value[7] == Approx(0.3).epsilon(1e-7));
    CHECK(parse_layout(layout_json(layout), "l") == layout);
    CHECK_FALSE(report.remarks.empty());  // the 8-bit files had to bring values back to 0..1
  }
}

TEST_CASE("channels that differ in floats alone, and materials that differ in floats alone, are not one") {
  const TempFolder folder;
  Image flat(8, 8, 3, 0.25f), other = flat;
  for (std::size_t i = 0; i < flat.values.size(); i += 2) flat.values[i] += 1e-5f;
  write_exr(folder.file("x.exr"), flat, true, false);
  write_exr(folder.file("y.exr"), other, true, false);
  write_exr(folder.file("z.exr"), flat, true, false);
  const std::string text = R"({"materials": [{"name": "x", "diffuse": "x.exr", "specular": 0.04, "gloss": 1},
    {"name": "y", "diffuse": "y.exr", "specular": 0.04, "gloss": 1},
    {"name": "z", "diffuse": "z.exr", "specular": 0.04, "gloss": 1}]})";
  (void)pack_text(folder, text, with_floats({"exr"}));
  AtlasLayout layout = packed_layout(folder);
  CHECK(row_named(layout, "x").texels);
  CHECK_FALSE(row_named(layout, "y").texels);
  CHECK(*row_named(layout, "y").value[0] == 0.25);
  CHECK(rect_named(layout, "x").x == rect_named(layout, "z").x);
  (void)pack_text(folder, text, with_floats({"png"}));
  layout = packed_layout(folder);
  CHECK_FALSE(row_named(layout, "x").texels);
  CHECK_FALSE(row_named(layout, "x").value[0]);
}

TEST_CASE("a material of numbers alone that keeps its texels has them all over its region and gutter") {
  const TempFolder folder;
  save_png(folder.file("d.png"), noise(40, 24, 3, 5));
  PackOptions options = with_floats({"exr"});
  options.leave_out.keep = {"constant"};
  options.layout.gutter = 1;
  (void)pack_text(folder, R"({"materials": [
    {"name": "numbers", "width": 16, "height": 8, "diffuse": [0.5, 0.25, 0.125], "specular": 0.04, "gloss": 0.75},
    {"name": "picture", "diffuse": "d.png", "specular": 0.04, "gloss": 1}]})",
                  options);
  const AtlasRect rect = rect_named(packed_layout(folder), "numbers");
  REQUIRE((rect.rotated ? rect.height : rect.width) == 16);
  const Image page = read_image(folder.file("out/page" + std::to_string(rect.page) + "_diffuse_alpha.exr"));
  for (int y = rect.y - 1; y <= rect.y + rect.height; ++y)
    for (int x = rect.x - 1; x <= rect.x + rect.width; ++x) {
      const auto texel = page.at(x, y);
      REQUIRE(std::vector<float>(texel.begin(), texel.end()) == std::vector<float>{0.5f, 0.25f, 0.125f, 1});
    }
}

TEST_CASE("mips of floats are files of their own, named in the layout, and those of the region alone") {
  const TempFolder folder;
  write_exr(folder.file("d.exr"), halves(64, 64, 3, 1), false, false);
  write_exr(folder.file("s.exr"), halves(64, 64, 3, 2), false, false);
  save_png(folder.file("g.png"), noise(64, 64, 1, 4));
  save_png(folder.file("e.png"), noise(64, 64, 3, 5));
  PackOptions options = with_floats({"exr"});
  options.layout.mips = 2;
  (void)pack_text(folder,
                  R"({"materials": [{"name": "a", "diffuse": "d.exr", "specular": "s.exr", "gloss": "g.png"},
    {"name": "b", "diffuse": "e.png", "specular": "s.exr", "gloss": "g.png"}]})",
                  options);
  const AtlasLayout layout = packed_layout(folder);
  CHECK(layout.pages.at(0).files[0] ==
        std::vector<std::string>{"page0_diffuse_alpha.exr", "page0_diffuse_alpha.mip1.exr"});
  const AtlasRect& rect = rect_named(layout, "a");
  REQUIRE(rect.mips == 2);
  const auto cut = [&](const std::string& file, int level) {
    const Image page = read_image(folder.file("out/" + file));
    Image out(64 >> level, 64 >> level, 4);
    paste(page, -(rect.x >> level), -(rect.y >> level), out);
    return out;
  };
  MipOptions mips;
  mips.levels = 2;
  const MipPairFloat alone =
      mip_pair(cut("page0_diffuse_alpha.exr", 0), cut("page0_specular_gloss.exr", 0), mips);
  CHECK(alone.diffuse_alpha[1] == cut("page0_diffuse_alpha.mip1.exr", 1));
  CHECK(alone.specular_gloss[1] == cut("page0_specular_gloss.mip1.exr", 1));
  // The gutter holds the edge.
  const Image page = read_image(folder.file("out/page0_diffuse_alpha.exr"));
  if (rect.gutter > 0 && rect.x > 0)
    CHECK(page.at(rect.x - 1, rect.y + 5)[0] == page.at(rect.x, rect.y + 5)[0]);
}

TEST_CASE("bleeding reaches floats: hidden texels, mips and gutters in every channel of both textures") {
  const TempFolder folder;
  write_exr(folder.file("d.exr"), halves(64, 64, 3, 1), false, false);
  write_exr(folder.file("s.exr"), halves(64, 64, 3, 2), false, false);
  save_png(folder.file("g.png"), noise(64, 64, 1, 4));
  save_png(folder.file("e.png"), noise(64, 64, 3, 5));
  Image8 alpha(64, 64, 1, 255);  // its border of 8 texels is hidden
  const auto hidden = [](int x, int y) { return std::min({x, y, 63 - x, 63 - y}) < 8; };
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      if (hidden(x, y)) alpha.at(x, y)[0] = 0;
  save_png(folder.file("a.png"), alpha);
  PackOptions options = with_floats({"exr"});
  options.layout.mips = 2;
  options.layout.gutter = 2;
  const auto packed = [&](bool bleed) {
    options.output.bleed = bleed;
    (void)pack_text(
        folder,
        R"({"materials": [{"name": "a", "diffuse": "d.exr", "specular": "s.exr", "gloss": "g.png", "alpha": "a.png"},
    {"name": "b", "diffuse": "e.png", "specular": "s.exr", "gloss": "g.png"}]})",
        options);
    return std::array{read_image(folder.file("out/page0_diffuse_alpha.exr")),
                      read_image(folder.file("out/page0_specular_gloss.exr")),
                      read_image(folder.file("out/page0_diffuse_alpha.mip1.exr")),
                      read_image(folder.file("out/page0_specular_gloss.mip1.exr"))};
  };
  const auto plain = packed(false), bled = packed(true);
  const AtlasLayout layout = packed_layout(folder);
  const AtlasRect& rect = rect_named(layout, "a");
  REQUIRE(rect.gutter > 0);
  REQUIRE_FALSE(rect.rotated);
  const auto region = [&](const Image& page, int level) {
    Image out(64 >> level, 64 >> level, 4);
    paste(page, -(rect.x >> level), -(rect.y >> level), out);
    return out;
  };
  Image a = region(plain[0], 0), b = region(plain[1], 0);
  CHECK(bleed_under_alpha(a, b) == 64 * 64 - 48 * 48);
  CHECK(region(bled[0], 0) == a);
  CHECK(region(bled[1], 0) == b);
  CHECK_FALSE(region(plain[1], 0) == b);
  MipOptions mips;
  mips.levels = 2;
  const MipPairFloat alone = mip_pair(a, b, mips);
  CHECK(region(bled[2], 1) == alone.diffuse_alpha[1]);
  CHECK(region(bled[3], 1) == alone.specular_gloss[1]);
  for (const std::size_t t : {0u, 1u})
    for (int y = -rect.gutter; y < 64 + rect.gutter; ++y)
      for (int x = -rect.gutter; x < 64 + rect.gutter; ++x) {
        const float* inner = texel(bled[t], rect, std::clamp(x, 0, 63), std::clamp(y, 0, 63));
        REQUIRE(std::equal(inner, inner + 4, texel(bled[t], rect, x, y)));
      }
}

TEST_CASE("metal-rough pictures of 16 bits come out of the formula unrounded") {
  const TempFolder folder;
  test::write_tiff(folder.file("m_basecolor.tif"), codes_16(8, 8, 3, 1));
  test::write_tiff(folder.file("m_metallic.tif"), codes_16(8, 8, 1, 2));
  test::write_tiff(folder.file("m_roughness.tif"), codes_16(8, 8, 1, 3));
  PackOptions options = with_floats({"tiff"});
  options.input.pattern = "{name}_{role}.tif";
  options.input.pictures.gloss = GlossForm::one_minus_roughness;
  (void)pack(folder.path(), folder.file("out"), options, built_in_library());
  const AtlasRect rect = packed_layout(folder).rects.at(0);
  const Image a = read_image(folder.file("out/page0_diffuse_alpha.tiff")),
              b = read_image(folder.file("out/page0_specular_gloss.tiff"));
  const Image16 base = codes_16(8, 8, 3, 1), metal = codes_16(8, 8, 1, 2), rough = codes_16(8, 8, 1, 3);
  for (int i = 0; i < 8; ++i) {
    const double m = metal.at(i, i)[0] / 65535.0, c = srgb_decode(base.at(i, i)[2] / 65535.0);
    CHECK(double{texel(a, rect, i, i)[2]} == Approx(c * (1 - m)).margin(1e-7));
    CHECK(double{texel(b, rect, i, i)[2]} == Approx(0.04 * (1 - m) + c * m).margin(1e-7));
    CHECK(double{texel(b, rect, i, i)[3]} == Approx(1 - rough.at(i, i)[0] / 65535.0).margin(1e-7));
    CHECK(texel(a, rect, i, i)[3] == 1);
  }
}

TEST_CASE("a space of the caller's opens what its pictures are stored in, before one rounding") {
  const TempFolder folder;
  save_png(folder.file("d.png"), noise(16, 8, 3, 1));
  write_exr(folder.file("s.exr"), halves(16, 8, 3, 2), true, false);
  PackOptions options = with_floats({"png", "exr"});
  // Channels change places and are halved: what a matrix does.
  options.input.pictures.open_space = [](const std::string& name) -> SpaceCurve {
    if (name != "turned") throw Error::at("<config>", "no colour space " + name, "turned");
    return [](float* rgb, std::size_t count) {
      for (std::size_t i = 0; i < count; ++i, rgb += 3) {
        const float r = rgb[0];
        rgb[0] = rgb[1] / 2, rgb[1] = rgb[2] / 2, rgb[2] = r / 2;
      }
    };
  };
  const std::string text = R"({"materials": [{"name": "a", "diffuse": {"image": "d.png", "space": "turned"},
    "specular": {"image": "s.exr", "space": "turned", "channels": "bgr"}, "gloss": 0.5}]})";
  (void)pack_text(folder, text, options);
  const AtlasLayout layout = packed_layout(folder);
  const AtlasRect& rect = layout.rects.at(0);
  const Image8 a8 = load_png(folder.file("out/page0_diffuse_alpha.png")), d = load_png(folder.file("d.png"));
  const Image a = read_image(folder.file("out/page0_diffuse_alpha.exr")),
              b = read_image(folder.file("out/page0_specular_gloss.exr")), s = halves(16, 8, 3, 2);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 16; ++x) {
      const auto in = d.at(x, y);
      CHECK(a8.at(rect.x + x, rect.y + y)[0] == srgb_u8(in[1] / 255.0 / 2));
      CHECK(a8.at(rect.x + x, rect.y + y)[2] == srgb_u8(in[0] / 255.0 / 2));
      CHECK(texel(a, rect, x, y)[1] == static_cast<float>(in[2] / 255.0) / 2);
      CHECK(texel(b, rect, x, y)[0] == s.at(x, y)[1] / 2);
      CHECK(texel(b, rect, x, y)[1] == s.at(x, y)[0] / 2);
    }
  const auto unknown = [&] {
    std::string other = text;
    other.replace(other.find("turned"), 6, "tuned!");
    return error_of([&] { (void)pack_text(folder, other, options); });
  };
  CHECK(contains(unknown(), "/materials/0/diffuse/space: tuned!"));
  CHECK(contains(unknown(), "expected turned"));
  // The option for pictures that name none.
  options.input.pictures.spaces = {{"diffuse", "turned"}};
  std::string plain = text;
  plain.replace(plain.find(R"({"image": "d.png", "space": "turned"})"), 37, "\"d.png\"");
  (void)pack_text(folder, plain, options);
  CHECK(load_png(folder.file("out/page0_diffuse_alpha.png")) == a8);
}
