// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "core/color/srgb.h"
#include "core/judge/engine.h"
#include "core/judge/nearest.h"
#include "core/judge/rules.h"
#include "core/validate/config.h"
#include "tests/core/judge/corpus.h"
#include "tests/core/validate/checked.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

// A set that nothing is to be said of but what a test puts in.
TextureSet plain_set(int size = 96) {
  return flat_set(size, {56, 56, 56}, {140, 120, 100});
}

void fill(Image8& image, const PixelBox& box, std::array<int, 3> codes) {
  for (int y = box.y; y < box.y + box.height; ++y)
    for (int x = box.x; x < box.x + box.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) image.at(x, y)[c] = static_cast<std::uint8_t>(codes[c]);
}

std::string ids(const CheckedFile& file) {
  std::string text;
  for (const Finding& f : file.findings) text += f.rule + "(" + std::string(name(f.severity)) + ") ";
  return text;
}

}  // namespace

TEST_CASE("plateaus of F0 in the zone below a hundredth of a percent of the texels are no error") {
  // Without its border a square of 12 x 12 is a plateau of 88 texels: 0.0084 % of 1024 x 1024.
  for (const auto& [side, severity] : {std::pair{12, Severity::warning}, {20, Severity::error}}) {
    TextureSet set = flat_set(1024, {60, 60, 60}, {120, 110, 100});
    fill(set.b, {500, 500, side, side}, {160, 160, 160});
    const CheckedFile file = check_set(set);
    REQUIRE(find(file, "ETK101") != nullptr);
    CHECK(find(file, "ETK101")->severity == severity);
    CHECK(contains(find(file, "ETK101")->message, "less than 0.01 % of the texels") ==
          (severity == Severity::warning));
  }
}

TEST_CASE("the rules stand in the order of their ids, each with all its texts") {
  std::set<std::string_view> slugs;
  std::string_view before;
  for (const Rule* rule : rules()) {
    INFO(rule->id);
    CHECK(before < rule->id);
    before = rule->id;
    CHECK(slugs.insert(rule->slug).second);
    for (const auto text :
         {rule->slug, rule->title, rule->source, rule->what, rule->why, rule->example, rule->fix})
      CHECK(!text.empty());
    CHECK((rule->check != nullptr) == !rule->id.starts_with("ETK9"));
    CHECK(!rule->family().empty());
    CHECK(find_rule(rule->id) == rule);
    CHECK(find_rule(rule->slug) == rule);
    std::string path = "/core/judge/rules/" + std::string(rule->id) + "_" + std::string(rule->slug) + ".cpp";
    for (char& c : path) c = c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    CHECK(contains(slurp(source_folder() + path), "constinit const Rule"));
  }
  CHECK(rules_with_prefix("ETK1").size() == 16);
  CHECK(rules_with_prefix("ETK").size() == rules().size());
  CHECK(rules_with_prefix("XYZ").empty());
  CHECK(nearest_rules("ETK11O").front() == "ETK110");
}

TEST_CASE("an ordinary surface gives no warning") {
  const CheckedFile file = check_set(plain_set());
  INFO(ids(file));
  for (const Finding& f : file.findings) CHECK(f.severity <= Severity::info);
}

TEST_CASE("a plateau in the forbidden zone names value, place, area, cause and fix") {
  TextureSet set = plain_set();
  fill(set.b, {20, 30, 24, 16}, {129, 129, 129});
  const CheckedFile file = check_set(set);
  const Finding* finding = find(file, "ETK101");
  REQUIRE(finding != nullptr);
  CHECK(finding->severity == Severity::error);
  CHECK(finding->byte == std::array{129, 129, 129});
  CHECK(finding->luminance.value() == Approx(0.2195).margin(5e-4));
  CHECK(finding->file == "b.png");
  REQUIRE(finding->box.has_value());
  CHECK(finding->box->x >= 20);
  CHECK(finding->box->x + finding->box->width <= 44);
  CHECK(contains(finding->cause, "encoded twice"));
  CHECK(contains(finding->message, "F0 0.22 (byte 129, grey)"));
  CHECK(!finding->fix.empty());
  CHECK(!finding->nearest.empty());
}

TEST_CASE("materials judge by the settings that name them, and by no others") {
  MaterialLibrary library = MaterialLibrary::builtin();
  Material mine = *library.find("silicon");
  mine.id = "mine";
  library.add(mine);
  Settings own;
  own.known = std::make_shared<const KnownMaterials>(library);
  CHECK(!known_materials(own).f0_of("mine").empty());
  CHECK(known_materials({}).f0_of("mine").empty());
  CHECK(settings_hash(own) != settings_hash({}));
  Settings same;
  same.known = std::make_shared<const KnownMaterials>(library);
  CHECK(settings_hash(same) == settings_hash(own));
}

TEST_CASE("silicon is let pass as information when named, and warned of when it only looks like it") {
  TextureSet set = plain_set();
  const auto known = KnownMaterials::builtin().f0_of("silicon");
  REQUIRE(!known.empty());
  const auto preferred = *std::ranges::find_if(known, [](const KnownF0* k) { return k->preferred; });
  const std::array<int, 3> codes{srgb_u8(preferred->linear[0]), srgb_u8(preferred->linear[1]),
                                 srgb_u8(preferred->linear[2])};
  set = flat_set(96, codes, {30, 30, 30});
  const CheckedFile unnamed = check_set(set);
  REQUIRE(find(unnamed, "ETK101") != nullptr);
  CHECK(find(unnamed, "ETK101")->severity == Severity::warning);
  CHECK(contains(find(unnamed, "ETK101")->message, "within 3 codes of silicon, which is common"));
  set.manifest.material = "silicon";
  const CheckedFile named = check_set(set);
  REQUIRE(find(named, "ETK101") != nullptr);
  CHECK(find(named, "ETK101")->severity == Severity::info);
  CHECK(find(named, "ETK112") == nullptr);
  set.manifest.material = "gold";
  CHECK(find(check_set(set), "ETK112") != nullptr);
}

TEST_CASE("the zone is decided on luminance: gold and brass are not in it, although a channel is") {
  for (const std::array<int, 3> codes : {std::array{255, 228, 156}, std::array{237, 212, 150}}) {
    const CheckedFile file = check_set(flat_set(96, codes, {0, 0, 0}));
    INFO(ids(file));
    CHECK(find(file, "ETK101") == nullptr);
    CHECK(errors(file) == 0);
  }
}

TEST_CASE("counts of the byte pass are exact") {
  TextureSet set = natural_set(130, 3);
  fill(set.b, {3, 5, 40, 33}, {124, 178, 90});
  fill(set.b, {70, 9, 11, 13}, {0, 0, 0});
  std::int64_t any = 0, all = 0, black = 0, alpha = 0;
  int least = 255, most = 0;
  Random random(1);
  for (int y = 0; y < 130; ++y)
    for (int x = 0; x < 130; ++x) {
      if (random.below(50) == 0) set.a.at(x, y)[3] = 0;
      const auto s = set.b.at(x, y);
      int inside = 0;
      for (std::size_t c = 0; c < 3; ++c) inside += s[c] >= 124 && s[c] <= 178;
      any += inside > 0;
      all += inside == 3;
      black += s[0] + s[1] + s[2] == 0;
      alpha += set.a.at(x, y)[3] == 0;
      least = std::min<int>(least, s[3]);
      most = std::max<int>(most, s[3]);
    }
  const CheckedFile file = check_set(set);
  const auto count = [&](std::string_view what) {
    return std::ranges::find(file.counts, what, &std::pair<std::string, std::int64_t>::first)->second;
  };
  CHECK(count("forbidden_any_channel_px") == any);
  CHECK(count("forbidden_all_channels_px") == all);
  CHECK(count("specular_black_px") == black);
  CHECK(count("alpha_zero_px") == alpha);
  CHECK(count("gloss_min") == least);
  CHECK(count("gloss_max") == most);
}

TEST_CASE("findings do not depend on the number of threads, and strips do not show") {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u}) {
    TextureSet set = natural_set(200, seed);
    Random random(seed);
    for (const auto* rule : {"ETK101", "ETK201", "ETK502"})
      for (const Mutation& m : mutations())
        if (m.rule == rule) m.inject(set, random);
    const CheckedFile one = check_set(set, {}, 1);
    for (const unsigned threads : {2u, 3u, 8u}) {
      const CheckedFile many = check_set(set, {}, threads);
      CHECK(many.findings == one.findings);
      CHECK(many.counts == one.counts);
    }
  }
}

TEST_CASE("mirroring the pictures mirrors the boxes and changes nothing else") {
  TextureSet set = natural_set(160, 9);
  fill(set.b, {20, 30, 24, 16}, {150, 150, 150});
  fill(set.a, {90, 100, 30, 31}, {10, 10, 10});
  fill(set.b, {90, 100, 30, 31}, {56, 56, 56});
  TextureSet mirrored = set;
  for (int y = 0; y < 160; ++y)
    for (int x = 0; x < 160; ++x) {
      std::ranges::copy(set.a.at(159 - x, y), mirrored.a.at(x, y).begin());
      std::ranges::copy(set.b.at(159 - x, y), mirrored.b.at(x, y).begin());
    }
  const CheckedFile here = check_set(set), there = check_set(mirrored);
  REQUIRE(here.findings.size() == there.findings.size());
  for (std::size_t i = 0; i < here.findings.size(); ++i) {
    const Finding &f = here.findings[i], &g = there.findings[i];
    CHECK(f.rule == g.rule);
    CHECK(f.area_px == g.area_px);
    if (f.box && f.rule != "ETK201") CHECK(g.box->x == 160 - f.box->x - f.box->width);
  }
}

TEST_CASE("one texel, one row and one column are judged without harm") {
  for (const auto& [width, height] :
       {std::pair(1, 1), std::pair(1, 300), std::pair(20000, 1), std::pair(3, 3), std::pair(65, 2)}) {
    TextureSet set{Image8(width, height, 4, 100), Image8(width, height, 4, 150), {}, {}};
    const CheckedFile file = check_set(set);
    INFO(width << " x " << height);
    CHECK(found(file, "ETK101", Severity::warning));
    CHECK(file.width == width);
    for (auto& v : set.a.values) v = 0;
    CHECK(found(check_set(set), "ETK503", Severity::error));
  }
}

TEST_CASE("a rule that is off needs no pixels, and none are read") {
  Settings settings;
  settings.profile = Profile::custom;
  CHECK(!needs_of(settings).pixels());
  int opened = 0;
  CheckTarget target;
  target.files = {{FileRole::specular_gloss, "", "b.png", false}};
  const Image8 b(64, 64, 4, 150);
  const auto open = [&](Needs needs) {
    ++opened;
    CHECK(!needs.pixels());
    PictureRows rows;
    rows.b = rows_of(b);
    return rows;
  };
  const CheckedFile file = check_rows(target, open, settings);
  CHECK(file.findings.empty());
  CHECK(file.stats.pictures_decoded == 0);
  CHECK(file.stats.pictures_left_out == 1);
  settings.rules["ETK101"].severity = Severity::warning;
  CHECK(needs_of(settings).has(Need::bytes_b));
  CHECK(!needs_of(settings).has(Need::bytes_a));
  CHECK(found(check_pictures(target, {{}, b, {}}, settings), "ETK101"));
}

TEST_CASE("a clean set is passed over once, a suspect one twice") {
  CHECK(check_set(natural_set(128, 2)).stats.passes == 1);
  TextureSet set = natural_set(256, 2);
  Random random(1);
  std::ranges::find(mutations(), "ETK401", &Mutation::rule)->inject(set, random);
  CHECK(check_set(set).stats.passes == 2);
}

TEST_CASE("configured severity and parameters hold") {
  TextureSet set = plain_set();
  fill(set.b, {20, 30, 24, 16}, {129, 129, 129});
  Settings settings;
  settings.rules["ETK101"].severity = Severity::info;
  CHECK(find(check_set(set, settings), "ETK101")->severity == Severity::info);
  settings.rules["ETK101"].severity = Severity::off;
  CHECK(find(check_set(set, settings), "ETK101") == nullptr);
  settings = {};
  settings.zone.low = 0.23;
  CHECK(find(check_set(set, settings), "ETK101") == nullptr);
  settings = {};
  settings.zone.min_area_px = 2000;
  CHECK(find(check_set(set, settings), "ETK101") == nullptr);
  settings = {};
  fill(set.a, {0, 0, 96, 96}, {40, 40, 40});
  CHECK(find(check_set(set, settings), "ETK202") == nullptr);
  settings.profile = Profile::strict;
  CHECK(find(check_set(set, settings), "ETK202") != nullptr);
  settings.rules["ETK202"].parameters["min_byte"] = 35;
  CHECK(find(check_set(set, settings), "ETK202") == nullptr);
}

TEST_CASE("the largest channel may decide the zone instead of the luminance") {
  const TextureSet set = flat_set(64, {80, 80, 150}, {100, 100, 100});
  Settings settings;
  CHECK(!found(check_set(set, settings), "ETK101"));
  settings.zone.metric = ZoneMetric::max;
  CHECK(found(check_set(set, settings), "ETK101"));
}

TEST_CASE("tiles are judged apart: overlaps, gutters, mips and equal tiles") {
  TextureSet set = plain_set(128);
  fill(set.b, {64, 0, 64, 128}, {200, 190, 180});
  fill(set.a, {64, 0, 64, 128}, {0, 0, 0});
  set.manifest.tiles = {{"plastic", "", "", {0, 0, 64, 128}, 0, {}, {}, {}, {}, {}, {}},
                        {"steel", "", "", {64, 0, 64, 128}, 0, {}, {}, {}, {}, {}, {}}};
  // Aligned to 64 texels: clean at every level up to 6, even without a gutter.
  set.manifest.mips = 6;
  CHECK(!found(check_set(set), "ETK504"));
  set.manifest.tiles[0].box.width = 60;  // level 3 mixes texels 56..63
  fill(set.b, {60, 0, 4, 128}, {0, 0, 0});
  CHECK(found(check_set(set), "ETK504"));
  set.manifest.mips = 2;
  CHECK(!found(check_set(set), "ETK504"));
  set.manifest.tiles[0].box.width = 70;
  const CheckedFile overlap = check_set(set);
  REQUIRE(find(overlap, "ETK506") != nullptr);
  CHECK(find(overlap, "ETK506")->tile == "plastic");
  set.manifest.tiles[0].box = {100, 0, 64, 128};
  CHECK(found(check_set(set), "ETK506"));
}

TEST_CASE(
    "the pieces of an island have one name and are one tile, which may equal another one as a whole alone") {
  TextureSet set = flat_set(128, {80, 80, 150}, {100, 100, 100});
  for (Image8* const image : {&set.a, &set.b})
    for (std::size_t i = 3; i < image->values.size(); i += 4) image->values[i] = 255;
  const auto piece = [&](const char* name, int column) {
    set.manifest.tiles.push_back({name, "", "", {32 * column, 0, 32, 64}, 0, {}, {}, {}, {}, {}, {}});
  };
  piece("crate", 0);
  piece("crate", 1);
  CHECK(!found(check_set(set), "ETK507"));
  piece("crate#2", 2);
  CHECK(!found(check_set(set), "ETK507"));
  piece("crate#2", 3);
  const CheckedFile equal = check_set(set);
  REQUIRE(find(equal, "ETK507") != nullptr);
  CHECK(find(equal, "ETK507")->tile == "crate#2");
}

TEST_CASE("unaligned tiles with a gutter of g stay clean up to level log2(g) + 1") {
  for (const int gutter : {1, 2, 4, 8}) {
    TextureSet set = plain_set(128);
    fill(set.b, {0, 0, 128, 128}, {220, 220, 220});
    const PixelBox tile{37, 41, 41, 39};
    fill(set.b, {tile.x - gutter, tile.y - gutter, tile.width + 2 * gutter, tile.height + 2 * gutter},
         {56, 56, 56});
    for (auto* image : {&set.a, &set.b})
      for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x) image->at(x, y)[3] = 255;
    set.manifest.tiles = {{"tile", "", "", tile, 0, {}, {}, {}, {}, {}, {}}};
    set.manifest.gutter = gutter;
    const int clean = static_cast<int>(std::log2(gutter)) + 1;
    INFO("gutter " << gutter);
    set.manifest.mips = clean;
    CHECK(!found(check_set(set), "ETK504"));
    CHECK(!found(check_set(set), "ETK505"));
    set.manifest.mips = clean + 2;
    CHECK(found(check_set(set), "ETK504"));
    // A gutter that is no copy of the edge is taken for a neighbour's, unless it is said to be its own.
    TextureSet source = set;
    fill(source.b, {tile.x - gutter, tile.y - gutter, tile.width + 2 * gutter, tile.height + 2 * gutter},
         {150, 150, 150});
    fill(source.b, tile, {56, 56, 56});
    source.manifest.gutter = 0;
    source.manifest.mips = clean;
    CHECK(found(check_set(source), "ETK504"));
    source.manifest.tiles[0].own_around = gutter;
    CHECK(!found(check_set(source), "ETK504"));
    source.manifest.mips = clean + 2;
    CHECK(found(check_set(source), "ETK504"));
    set.b.at(tile.x - 1, tile.y + 3)[1] = 80;
    const CheckedFile broken = check_set(set);
    REQUIRE(find(broken, "ETK505") != nullptr);
    CHECK(find(broken, "ETK505")->area_px == 1);
  }
}

TEST_CASE("opaque means alpha above 0, or 255 where alpha is transparency") {
  TextureSet set = plain_set(64);
  fill(set.b, {0, 0, 64, 64}, {150, 150, 150});
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) set.a.at(x, y)[3] = 100;
  CHECK(found(check_set(set), "ETK101"));
  set.manifest.transparent = true;
  CHECK(!found(check_set(set), "ETK101"));
}
