// SPDX-License-Identifier: Apache-2.0
// Pictures of which a rule said what is not so, or nothing where there was something to say.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <utility>

#include "core/color/srgb.h"
#include "core/judge/nearest.h"
#include "tests/core/judge/corpus.h"
#include "tests/core/validate/checked.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

// A wall of noisy diffuse with the F0 of a dielectric all over, as most dielectrics are painted.
TextureSet wall(int size = 512) {
  Random random(1);
  TextureSet set{Image8(size, size, 4, 255), Image8(size, size, 4, 56), {}, {}};
  each_texel(set.a, [&](auto texel, int, int) {
    const int grey = 80 + random.below(80);
    set_rgb(texel, {grey, grey, grey});
  });
  each_texel(set.b, [&](auto texel, int, int) { texel[3] = to_byte(60 + random.below(140)); });
  return set;
}

void paint(Image8& image, const PixelBox& box, std::array<int, 3> codes) {
  for (int y = box.y; y < box.y + box.height; ++y)
    for (int x = box.x; x < box.x + box.width; ++x) set_rgb(image.at(x, y), codes);
}

}  // namespace

TEST_CASE("a flat F0 on a tooth of the comb, with some texels of others, is no comb") {
  for (const auto& [flat_areas, share] :
       {std::pair(1, 8e-4), std::pair(2, 8e-4), std::pair(3, 8e-4), std::pair(1, 8e-3), std::pair(3, 8e-3)}) {
    TextureSet set = wall();
    // An 8-bit linear source reaches codes 46, 50 and 56, and a third of those that are strewn over them.
    for (int i = 1; i < flat_areas; ++i)
      paint(set.b, {512 / flat_areas * i, 0, 512 / flat_areas, 512},
            i == 1 ? std::array{50, 50, 50} : std::array{46, 46, 46});
    Random random(2);
    each_texel(set.b, [&](auto texel, int, int) {
      if (random.unit() >= share) return;
      const int grey = 57 + random.below(43);
      set_rgb(texel, {grey, grey, grey});
    });
    INFO(flat_areas << " flat areas, " << share << " of others");
    CHECK(find(check_set(set), "ETK404") == nullptr);
  }
}

TEST_CASE("a comb beside a flat area is found") {
  TextureSet set = wall();
  Random random(2);
  constexpr std::array comb{34, 38, 42, 46, 50, 53, 59, 61, 64, 66, 69, 71};
  paint(set.a, {0, 0, 512, 512}, {56, 56, 56});
  for (int y = 0; y < 512; ++y)
    for (int x = 0; x < 64; ++x) {
      const int grey = comb[static_cast<std::size_t>(random.below(12))];
      set_rgb(set.a.at(x, y), {grey, grey, grey});
    }
  const CheckedFile file = check_set(set);
  REQUIRE(find(file, "ETK404") != nullptr);
  CHECK(find(file, "ETK404")->message ==
        "98,304 dark values use 12 of 101 codes, those of an 8-bit linear source");
}

TEST_CASE("an unnamed F0 in the zone is an error, unless a common material has it, which is named") {
  std::vector<int> warned;
  for (int code = 125; code <= 177; ++code) {
    TextureSet set = wall(64);
    paint(set.b, {20, 20, 16, 16}, {code, code, code});
    const CheckedFile file = check_set(set);
    INFO("code " << code);
    REQUIRE(find(file, "ETK101") != nullptr);
    const Finding& finding = *find(file, "ETK101");
    if (finding.severity != Severity::error) {
      warned.push_back(code);
      CHECK(finding.severity == Severity::warning);
      CHECK(contains(finding.message, "no error, because it is within 3 codes of graphite, which is common"));
    } else {
      CHECK_FALSE(contains(finding.message, "which is common"));
    }
  }
  CHECK(warned == std::vector{140, 141, 142, 143});
  // The material that was in the way, named: information.
  TextureSet named = wall(64);
  paint(named.b, {0, 0, 64, 64}, {146, 146, 146});
  named.manifest.material = "boron_carbide";
  REQUIRE(find(check_set(named), "ETK101") != nullptr);
  CHECK(find(check_set(named), "ETK101")->severity == Severity::info);
}

TEST_CASE("the common materials of the zone are those that people paint") {
  std::vector<std::string> common;
  for (const KnownF0& entry : KnownMaterials::builtin().f0())
    if (entry.preferred && entry.common) {
      common.push_back(entry.id);
      CHECK(entry.luminance > 0.20);
      CHECK(entry.luminance < 0.45);
    }
  std::ranges::sort(common);
  CHECK(common == std::vector<std::string>{"graphite", "graphite_powder", "hematite", "silicon",
                                           "silicon_amorphous", "titanium_nitride"});
}

TEST_CASE("premultiplied colour is found beside metals, whose diffuse is black") {
  for (const std::array<int, 3> diffuse_of_metal : {std::array{0, 0, 0}, std::array{9, 7, 5}}) {
    TextureSet set = wall();
    each_texel(set.a, [](auto texel, int x, int y) {
      const double alpha = std::abs(std::sin(x / 40.0) * std::sin(y / 40.0));
      texel[3] = to_byte(255 * alpha);
      for (std::size_t c = 0; c < 3; ++c) texel[c] = to_byte(texel[c] * alpha);
    });
    CHECK(find(check_set(set), "ETK501") != nullptr);
    paint(set.a, {0, 0, 100, 512}, diffuse_of_metal);
    paint(set.b, {0, 0, 100, 512}, {255, 228, 156});
    const CheckedFile file = check_set(set);
    REQUIRE(find(file, "ETK501") != nullptr);
    CHECK(find(file, "ETK501")->severity == Severity::error);
    // Straight colour beside the same metal is none.
    Random random(3);
    for (int y = 0; y < 512; ++y)
      for (int x = 100; x < 512; ++x) {
        const int grey = 80 + random.below(80);
        set_rgb(set.a.at(x, y), {grey, grey, grey});
      }
    CHECK(find(check_set(set), "ETK501") == nullptr);
  }
}

TEST_CASE("a wide ramp of F0 is not accused of being encoded twice") {
  for (const auto& [first, last] : {std::pair(53, 196), std::pair(20, 250), std::pair(80, 175)}) {
    TextureSet set = wall();
    each_texel(set.b, [&](auto texel, int x, int) {
      const int code = first + (last - first) * x / 511;
      set_rgb(texel, {code, code, code});
    });
    INFO("codes " << first << " to " << last);
    CHECK(find(check_set(set), "ETK402") == nullptr);
  }
  // A ramp of dielectrics, encoded twice, still is.
  TextureSet set = wall();
  each_texel(set.b, [](auto texel, int x, int) {
    const int code = 109 + 40 * x / 511;
    set_rgb(texel, {code, code, code});
  });
  CHECK(find(check_set(set), "ETK402") != nullptr);
}

TEST_CASE("where alpha is 0 all over, gloss is not judged besides") {
  TextureSet set = wall();
  each_texel(set.a, [](auto texel, int, int) { texel[3] = 0; });
  each_texel(set.b, [](auto texel, int, int) { texel[3] = to_byte(texel[3] / 40 * 40); });
  const CheckedFile file = check_set(set);
  CHECK(find(file, "ETK503") != nullptr);
  CHECK(find(file, "ETK304") == nullptr);
  CHECK(file.stats.passes == 1);
  each_texel(set.a, [](auto texel, int, int) { texel[3] = 255; });
  CHECK(find(check_set(set), "ETK304") != nullptr);
}

TEST_CASE("small patches with hard edges are told from edges, and both have a place") {
  for (const int side : {7, 8}) {
    TextureSet set = wall();
    paint(set.b, {200, 210, side, side}, {160, 160, 160});
    const CheckedFile file = check_set(set);
    INFO("side " << side);
    CHECK(find(file, "ETK101") == nullptr);
    REQUIRE(find(file, "ETK102") != nullptr);
    const Finding& finding = *find(file, "ETK102");
    CHECK(finding.box == PixelBox{200, 210, side, side});
    CHECK(finding.area_px == static_cast<std::size_t>(side * side));
    CHECK(finding.byte == std::array{160, 160, 160});
    CHECK(finding.message == "a solid patch of F0 0.35 (byte 160, grey), " + std::to_string(side) + " x " +
                                 std::to_string(side) + " px with hard edges, too small for ETK101");
  }
  TextureSet set = wall();
  for (const PixelBox& box :
       {PixelBox{10, 20, 7, 8}, PixelBox{404, 410, 8, 8}, PixelBox{60, 64, 7, 7}, PixelBox{505, 300, 7, 5}})
    paint(set.b, box, {160, 160, 160});
  paint(set.b, {300, 0, 2, 200}, {150, 150, 150});  // a scratch
  const CheckedFile several = check_set(set);
  REQUIRE(find(several, "ETK102") != nullptr);
  CHECK(find(several, "ETK102")->box == PixelBox{404, 410, 8, 8});
  CHECK(
      find(several, "ETK102")->message ==
      "a solid patch of F0 0.35 (byte 160, grey), 8 x 8 px with hard edges, the largest of 3, too small for ETK101; edges and thin features on 435 px (0.17 %)");
}

TEST_CASE("blurred edges are no patches, and their box is around them") {
  for (const double sigma : {0.0, 1.0, 2.0, 3.0, 4.0})
    for (const double metal : {0.55, 0.95})
      for (const Blend blend : {Blend::linear, Blend::encoded}) {
        const Pixels<float> mask = blob_mask(512, sigma, 21);
        const CheckedFile file = check_set(blended_set(mask, 0.04, metal, blend));
        INFO("sigma " << sigma << ", metal " << metal);
        REQUIRE(find(file, "ETK102") != nullptr);
        CHECK(contains(find(file, "ETK102")->message, "edges and thin features inside"));
        CHECK(find(file, "ETK102")->box.has_value());
      }
  TextureSet set = wall();
  paint(set.b, {40, 50, 2, 100}, {150, 150, 150});
  paint(set.b, {130, 300, 70, 2}, {150, 150, 150});
  const CheckedFile lines = check_set(set);
  REQUIRE(find(lines, "ETK102") != nullptr);
  CHECK(find(lines, "ETK102")->box == PixelBox{40, 50, 160, 252});
}

TEST_CASE("coloured metals with red and blue exchanged are told, and which metal it is") {
  std::vector<std::string> exchanged;
  for (const KnownF0& entry : KnownMaterials::builtin().f0()) {
    if (!entry.conductor || !entry.preferred) continue;
    std::array<int, 3> codes{};
    for (std::size_t c = 0; c < 3; ++c) codes[c] = srgb_u8(std::clamp(entry.linear[c], 0.0, 1.0));
    INFO(entry.id << " " << codes[0] << " " << codes[1] << " " << codes[2]);
    TextureSet set = wall(96);
    paint(set.b, {30, 30, 40, 40}, codes);
    paint(set.a, {30, 30, 40, 40}, {0, 0, 0});
    CHECK(find(check_set(set), "ETK115") == nullptr);
    paint(set.b, {30, 30, 40, 40}, {codes[2], codes[1], codes[0]});
    const CheckedFile file = check_set(set);
    const Finding* finding = find(file, "ETK115");
    if (finding == nullptr) continue;
    exchanged.push_back(entry.id);
    CHECK(finding->severity == Severity::warning);
    CHECK(contains(finding->cause, "red and blue exchanged; then it is "));
    CHECK(finding->box.has_value());
  }
  for (const char* metal : {"gold", "copper", "brass_70_30"})
    CHECK(std::ranges::find(exchanged, metal) != exchanged.end());
  // Named, it is ETK112 that says so.
  TextureSet set = wall(96);
  paint(set.b, {0, 0, 96, 96}, {156, 228, 255});
  CHECK(contains(find(check_set(set), "ETK115")->cause, "then it is gold, within"));
  set.manifest.material = "gold";
  const CheckedFile named = check_set(set);
  CHECK(find(named, "ETK115") == nullptr);
  REQUIRE(find(named, "ETK112") != nullptr);
  CHECK(find(named, "ETK112")->cause == "possible cause: red and blue exchanged");
}

TEST_CASE("posterised F0 is told as posterised diffuse is, and flat materials are not") {
  TextureSet set = wall();
  each_texel(set.b, [](auto texel, int x, int) {
    const int code = 36 + 180 * x / 511 / 12 * 12;
    set_rgb(texel, {code, code, code});
  });
  const CheckedFile file = check_set(set);
  REQUIRE(find(file, "ETK406") != nullptr);
  CHECK(find(file, "ETK406")->file == "b.png");
  CHECK(find(file, "ETK406")->message == "a smooth gradient of F0 uses 15 codes between 36 and 204");
  each_texel(set.b, [](auto texel, int x, int) {
    const int code = 36 + 180 * x / 511;
    set_rgb(texel, {code, code, code});
  });
  CHECK(find(check_set(set), "ETK406") == nullptr);
  // Ten materials side by side, as an atlas has them.
  constexpr std::array codes{39, 44, 50, 56, 63, 80, 184, 200, 230, 250};
  each_texel(set.b, [&](auto texel, int x, int) {
    const int code = codes[static_cast<std::size_t>(10 * x / 512)];
    set_rgb(texel, {code, code, code});
  });
  const CheckedFile materials = check_set(set);
  CHECK(find(materials, "ETK406") == nullptr);
  CHECK(materials.stats.passes == 1);
}

TEST_CASE("of channels that stand at 255 each is named") {
  const auto said = [](std::array<int, 3> codes) {
    TextureSet set = wall(128);
    paint(set.b, {0, 0, 128, 64}, codes);
    const CheckedFile file = check_set(set);
    const Finding* finding = find(file, "ETK107");
    return finding == nullptr ? std::string("nothing") : finding->message;
  };
  CHECK(
      said({255, 228, 156}) ==
      "F0 red stands at code 255 on 50 % of the texels while green and blue do not: clipped or mapped into the gamut");
  CHECK(
      said({255, 255, 156}) ==
      "F0 red and green stand at code 255 on up to 50 % of the texels while blue does not: clipped or mapped into the gamut");
  CHECK(said({255, 255, 255}) == "nothing");
}

TEST_CASE("black diffuse is not to be brightened where it may be glass or a metal") {
  TextureSet set = wall(128);
  paint(set.a, {20, 20, 40, 40}, {0, 0, 0});
  const CheckedFile black = check_set(set);
  REQUIRE(find(black, "ETK202") != nullptr);
  CHECK(find(black, "ETK202")->fix.starts_with("Leave it black if it is glass"));
  paint(set.a, {20, 20, 40, 40}, {10, 10, 10});
  const CheckedFile dark = check_set(set);
  REQUIRE(find(dark, "ETK202") != nullptr);
  CHECK(find(dark, "ETK202")->fix.starts_with("Brighten to code 30 or more"));
}

TEST_CASE("a metallic value has no nearest materials") {
  TextureSet set = wall(128);
  set.metallic = Image8(128, 128, 1, 0);
  for (int y = 20; y < 60; ++y)
    for (int x = 20; x < 60; ++x) set.metallic.at(x, y)[0] = 128;
  const CheckedFile file = check_set(set);
  REQUIRE(find(file, "ETK113") != nullptr);
  CHECK(find(file, "ETK113")->nearest.empty());
  CHECK(find(file, "ETK113")->value == "metallic 0.5");
  // But the base colour may be a metal's: this is half gold, half a dielectric of 0.04.
  paint(set.b, {20, 20, 40, 40}, {191, 171, 120});
  const CheckedFile gold = check_set(set);
  REQUIRE(find(gold, "ETK113") != nullptr);
  CHECK(find(gold, "ETK113")->cause.starts_with("as a metal it could be gold (p 0."));
  paint(set.b, {20, 20, 40, 40}, {120, 120, 120});
  CHECK(find(check_set(set), "ETK113")->cause.empty());  // near no metal
}

TEST_CASE("what lies half a code inside a limit of the zone is not in it") {
  // Hoffman prints 0.200 as code 124, which stands for 0.2016.
  for (const auto& [code, in_zone] :
       {std::pair(124, false), std::pair(125, true), std::pair(177, true), std::pair(179, false)}) {
    const CheckedFile file = check_set(flat_set(64, {code, code, code}, {0, 0, 0}));
    INFO("code " << code << "\n" << file.findings.size());
    CHECK((find(file, "ETK101") != nullptr) == in_zone);
  }
  CHECK(errors(check_set(flat_set(64, {124, 124, 124}, {120, 110, 100}))) == 0);
}

TEST_CASE("the codes of diamond are not taken for a dielectric that was encoded twice") {
  CHECK(find(check_set(flat_set(64, {115, 115, 117}, {20, 20, 20})), "ETK402") == nullptr);
  CHECK(find(check_set(flat_set(64, {117, 117, 117}, {90, 90, 90})), "ETK402") != nullptr);
  TextureSet named = flat_set(64, {114, 115, 114}, {20, 20, 20});
  CHECK(find(check_set(named), "ETK402") != nullptr);
  named.manifest.material = "diamond";
  CHECK(find(check_set(named), "ETK402") == nullptr);
}

TEST_CASE("two values of F0 in a picture whose materials nobody names are told") {
  TextureSet set = wall(128);
  each_texel(set.b, [&](auto texel, int x, int y) {
    const int code = (x / 8 + y / 8) % 2 == 0 ? 39 : 90;
    set_rgb(texel, {code, code, code});
  });
  const CheckedFile file = check_set(set);
  REQUIRE(find(file, "ETK110") != nullptr);
  CHECK(find(file, "ETK110")->severity == Severity::info);
  CHECK(find(file, "ETK110")->value == "codes 39 and 90");
  CHECK(find(check_set(wall(128)), "ETK110") == nullptr);
  // Beside metal there is one dielectric.
  paint(set.b, {0, 0, 128, 128}, {56, 56, 56});
  paint(set.b, {0, 0, 64, 128}, {240, 230, 200});
  CHECK(find(check_set(set), "ETK110") == nullptr);
}
