// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/sources/masked.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "core/atlas/sources/sources.h"
#include "core/color/luminance.h"
#include "core/color/srgb.h"
#include "core/image/image_io.h"
#include "core/validate/check_pack.h"
#include "tests/core/atlas/pack_support.h"

using namespace etak;
using namespace etak::test;

namespace {

// Two discs and a bar with soft edges over a ground, as shares of one: what a painter's brush leaves.
double soft(double distance, double width) {
  return 1 / (1 + std::exp(distance / width * 4));
}

double wear(int x, int y, double width) {
  const double a = std::hypot(x - 40.0, y - 45.0) - 23.3, b = std::hypot(x - 92.0, y - 80.0) - 17.8;
  return std::max(soft(a, width), soft(b, width));
}

Image8 grey_mask(int side, double width) {
  Image8 out(side, side, 1);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      out.at(x, y)[0] = static_cast<std::uint8_t>(std::lround(255 * wear(x, y, width)));
  return out;
}

Image8 three(const Image8& grey) {
  Image8 out(grey.width, grey.height, 3);
  for (std::size_t i = 0; i < grey.values.size(); ++i)
    std::fill_n(out.values.data() + 3 * i, 3, grey.values[i]);
  return out;
}

std::set<int> used(const std::vector<std::uint8_t>& parts) {
  return {parts.begin(), parts.end()};
}

std::string worn(const std::string& members = "") {
  return R"({"materials": [{"name": "Worn steel", "mask": {"image": "wear.png", "materials": [
    {"at": 0, "specular": 0.05, "diffuse": [0.25, 0.02, 0.02], "gloss": 0.6}, {"at": 255, "material": "iron", "gloss": 0.7}],
    "write": ["specular_gloss", "metal_rough"]})" +
         members + "}]}";
}

std::string bad_mask(const TempFolder& folder, const std::string& parts) {
  return packing_fault(
      folder, R"({"materials": [{"name": "a", "mask": {"image": "wear.png", "materials": )" + parts + "}}]}");
}

}  // namespace

TEST_CASE("a texel of a mask of two greys is of the material that covers more of it") {
  const MaskCode codes[] = {{0, 0, 0}, {255, 255, 255}};
  const Image8 mask = grey_mask(128, 6);
  const auto parts = parts_of_mask(three(mask), codes, false, "wear.png");
  for (std::size_t i = 0; i < parts.size(); ++i) REQUIRE(parts[i] == (mask.values[i] > 127 ? 1 : 0));
}

TEST_CASE("the edge between two of three greys or ID colours is never drawn in the third") {
  // Left 0, right 255; the middle one stands below by itself. Edges are filtered over three texels.
  Image8 mask(48, 48, 1, 0);
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 48; ++x)
      mask.at(x, y)[0] = y > 40 ? 128 : x < 20 ? 0 : x == 20 ? 60 : x == 21 ? 130 : x == 22 ? 200 : 255;
  const MaskCode greys[] = {{0, 0, 0}, {128, 128, 128}, {255, 255, 255}};
  const auto parts = parts_of_mask(three(mask), greys, false, "ids.png");
  for (int y = 0; y < 36; ++y)
    for (int x = 0; x < 48; ++x) CHECK(parts[static_cast<std::size_t>(48 * y + x)] != 1);
  CHECK(parts[48 * 46 + 10] == 1);

  const MaskCode ids[] = {{255, 0, 0}, {0, 255, 0}, {128, 128, 0}};
  Image8 colors(32, 32, 3);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      const int share = x < 15 ? 0 : x == 15 ? 100 : 255;
      colors.at(x, y)[0] = static_cast<std::uint8_t>(255 - share);
      colors.at(x, y)[1] = static_cast<std::uint8_t>(share);
    }
  CHECK(used(parts_of_mask(colors, ids, true, "ids.png")) == std::set<int>{0, 1});
}

TEST_CASE("an ID colour without a material is told with its place, and so is a soft edge of three greys") {
  const MaskCode ids[] = {{255, 0, 0}, {0, 255, 0}};
  Image8 colors(16, 16, 3);
  for (std::size_t i = 0; i < colors.pixel_count(); ++i) colors.values[3 * i + (i % 16 > 8 ? 1 : 0)] = 255;
  CHECK(used(parts_of_mask(colors, ids, true, "ids.png")) == std::set<int>{0, 1});
  for (int y = 4; y < 12; ++y)
    for (int x = 4; x < 12; ++x) colors.at(x, y)[0] = 0, colors.at(x, y)[1] = 0, colors.at(x, y)[2] = 255;
  CHECK(
      error_of([&] { (void)parts_of_mask(colors, ids, true, "ids.png"); }) ==
      "ids.png: texel 4, 4 is #0000ff, which no material has and no edge explains; expected #ff0000, #00ff00");

  const MaskCode greys[] = {{0, 0, 0}, {128, 128, 128}, {255, 255, 255}};
  CHECK(contains(error_of([&] { (void)parts_of_mask(three(grey_mask(128, 30)), greys, false, "wear.png"); }),
                 "which no material has and no edge explains; expected 0, 128, 255"));
}

TEST_CASE("no texel of a masked material is in the forbidden zone, and no rule of edges fires") {
  const TempFolder folder;
  for (const double softness : {0.7, 2.0, 8.0}) {
    save_png(folder.file("wear.png"), grey_mask(128, softness));
    PackOptions options;
    options.output.overwrite = true;
    PackCheck check(folder.file("out"), {});
    check.attach(options);
    PackResult result = pack_text(folder, worn(), options);
    const ValidationReport& report = check.finish(result);
    for (const CheckedFile& file : report.files)
      for (const Finding& finding : file.findings) {
        INFO(finding.message);
        CHECK(
            std::set<std::string>{"ETK101", "ETK102", "ETK106", "ETK108", "ETK109", "ETK113", "ETK114"}.count(
                finding.rule) == 0);
      }
    const Image8 f0 = load_png(folder.file("out/worn_steel_specular.png"));
    std::set<std::array<std::uint8_t, 3>> colors;
    for (std::size_t i = 0; i < f0.pixel_count(); ++i)
      colors.insert({f0.values[3 * i], f0.values[3 * i + 1], f0.values[3 * i + 2]});
    REQUIRE(colors.size() == 2);
    for (const auto& [r, g, b] : colors) {
      const LinearRgb linear = srgb_decode(Srgb8{r, g, b});
      const double y = luminance_of(linear.r, linear.g, linear.b);
      CHECK((y < 0.2 || y > 0.45));
    }
  }
}

TEST_CASE("the files that a mask writes hold what the atlas holds, and metal-rough gives it back") {
  const TempFolder folder;
  save_png(folder.file("wear.png"), grey_mask(128, 2));
  const PackResult result = pack_text(folder, worn());
  const AtlasLayout layout = packed_layout(folder);
  const AtlasRect& rect = rect_named(layout, "Worn steel");
  REQUIRE(rect.width == 128);
  const Image8 page_a = load_png(folder.file("out/page0_diffuse_alpha.png")),
               page_b = load_png(folder.file("out/page0_specular_gloss.png"));
  const auto file = [&](const char* role) {
    return load_png(folder.file("out/worn_steel_" + std::string(role)));
  };
  const Image8 diffuse = file("diffuse.png"), specular = file("specular.png"), gloss = file("gloss.png"),
               base = file("mr_basecolor.png"), metallic = file("mr_metallic.png");
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x) {
      const std::uint8_t *a = texel_of(page_a, rect, x, y), *b = texel_of(page_b, rect, x, y);
      REQUIRE(std::equal(a, a + 3, diffuse.at(x, y).data()));
      REQUIRE(std::equal(b, b + 3, specular.at(x, y).data()));
      REQUIRE(b[3] == gloss.at(x, y)[0]);
      const bool metal = metallic.at(x, y)[0] == 255;
      REQUIRE((metal || metallic.at(x, y)[0] == 0));
      REQUIRE(std::equal(metal ? b : a, (metal ? b : a) + 3, base.at(x, y).data()));
    }
  REQUIRE(result.remarks.size() == 1);
  CHECK(contains(result.remarks[0], "Worn steel: F0 0.05 of a material that is no metal"));

  // They are the same whatever form pages have, and go where the atlas goes.
  const std::string before = slurp(folder.file("out/worn_steel_specular.png"));
  PackOptions floats;
  floats.output.overwrite = true;
  floats.output.write.formats = {"exr"};
  floats.input.pictures.door = picture_door();
  (void)pack_text(folder, worn(), floats);
  CHECK(slurp(folder.file("out/worn_steel_specular.png")) == before);
}

TEST_CASE("a mask that cannot be used is told in one line") {
  const TempFolder folder;
  save_png(folder.file("wear.png"), grey_mask(128, 2));
  save_png(folder.file("alpha.png"), Image8(64, 64, 1, 255));
  CHECK(contains(packing_fault(folder, worn(R"(, "alpha": "alpha.png")")), "64 x 64"));
  const std::string iron = R"({"at": 0, "material": "iron"})";
  CHECK(contains(bad_mask(folder, "[" + iron + "]"), "1 materials; expected two to four"));
  CHECK(contains(bad_mask(folder, "[" + iron + "," + iron + "," + iron + "," + iron + "," + iron + "]"),
                 "5 materials; expected two to four"));
  CHECK(contains(bad_mask(folder, "[" + iron + R"(, {"at": 9, "material": "gold"}])"),
                 "#/materials/0/mask/materials/1/at: too near to another material's"));
  CHECK(contains(bad_mask(folder, "[" + iron + R"(, {"at": "#ff0000", "material": "gold"}])"),
                 "a whole number from 0 to 255"));
  CHECK(contains(bad_mask(folder, "[" + iron + R"(, {"at": 255, "material": "no_such"}])"), "no_such"));
  CHECK(contains(bad_mask(folder, "[" + iron + R"(, {"at": 255, "specular": "f0.png", "gloss": 1}])"),
                 "one F0 for each material"));
  CHECK(contains(packing_fault(folder, worn(R"(, "gloss": 1)")), "\"mask\" and a colour or gloss beside it"));
  spit(folder.file("wear.png"), slurp(folder.file("wear.png")).substr(0, 300));
  CHECK(contains(packing_fault(folder, worn()), "wear.png"));
}

TEST_CASE("a manifest of masks is written so that it reads the same") {
  const TempFolder folder;
  AtlasManifest m = parse_manifest(worn(), folder.file("m.json"));
  MaterialMask& mask = *m.materials.at(0).mask;
  mask.parts[1].specular = LibrarySource{"iron", "", ""};
  mask.parts[1].record = {};
  const std::string text = format_masks(m, folder.file("m.json"));
  CHECK(contains(text, "\"wear.png\""));
  const AtlasManifest again = parse_manifest(text, folder.file("m.json"));
  const MaterialMask& read = *again.materials.at(0).mask;
  CHECK(read.image == mask.image);
  CHECK(read.parts[0].diffuse == mask.parts[0].diffuse);
  CHECK(read.parts[1].specular == mask.parts[1].specular);
  CHECK((read.metal_rough && read.specular_gloss && !read.colors));
  CHECK(format_masks(again, folder.file("m.json")) == text);
}
