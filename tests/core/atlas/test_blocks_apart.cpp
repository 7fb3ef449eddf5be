// SPDX-License-Identifier: Apache-2.0
// Which channels textures in blocks hold, and what lies apart from them.
#include <catch2/catch.hpp>

#include "core/base/files/paths.h"
#include "core/image/blocks/budget.h"
#include "core/validate/files/load.h"
#include "tests/core/atlas/blocks_support.h"

namespace etak {
namespace {

using namespace test;

// A blended material of slow colours; opacity and gloss are noise, which no block holds.
std::string noisy_fourths(const TempFolder& folder, bool noisy_colour) {
  Image8 slow(64, 64, 3);
  for (int y = 0; y < slow.height; ++y)
    for (int x = 0; x < slow.width; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        slow.at(x, y)[c] = static_cast<std::uint8_t>(120 + x / 2 + static_cast<int>(c) * y / 4);
  save_png(folder.file("d.png"), noisy_colour ? noise(64, 64, 3, 7) : slow);
  save_png(folder.file("s.png"), slow);
  save_png(folder.file("g.png"), noise(64, 64, 1, 1));
  save_png(folder.file("o.png"), noise(64, 64, 1, 2));
  return manifest_of({R"({"name": "w", "diffuse": "d.png", "specular": "s.png", "gloss": "g.png", )"
                      R"("alpha": "o.png", "alpha_mode": "blend"})"});
}

TextureFile file_of(const TempFolder& folder, const std::string& name) {
  const std::string bytes = slurp(folder.file("out/" + name));
  return name.ends_with(".dds") ? read_dds(bytes, name) : read_ktx2(bytes, name, astc_door());
}

}  // namespace

TEST_CASE("a percentile of block errors counts texels by how much of them triangles read") {
  TexelSpread spread(0.01);
  for (int i = 0; i < 980; ++i) spread.add(0.5, 255);
  for (int i = 0; i < 20; ++i) spread.add(3, 100);  // 2 % of the texels, 0.8 % of what is read
  CHECK(spread.count() == 980 * 255 + 20 * 100);
  CHECK(spread.percentile_99() == 0.5);
  CHECK(spread.largest() == 3);
  CHECK(spread.above(1) == 2000);
  for (int i = 0; i < 20; ++i) spread.add(3, 255);
  CHECK(spread.percentile_99() == 3);
}

TEST_CASE(
    "gloss and opacity that no block holds are exact beside blocks of colour, and everyone reads them") {
  const TempFolder folder;
  const std::string manifest = noisy_fourths(folder, false);
  for (const std::string word : {"auto", "astc"}) {
    CAPTURE(word);
    const std::vector<std::string> kinds =
        word == "auto" ? std::vector<std::string>{"ktx2", "dds"} : std::vector<std::string>{"ktx2"};
    // With PNG first, what reads the first files is told of four channels.
    std::vector<std::string> all = kinds;
    all.insert(all.begin(), "png");
    PackOptions options = in_blocks(word, all);
    options.output.compress.budget = parse_block_budget("diffuse=3,f0=3");
    const PackResult result = pack_text(folder, manifest, options);
    const AtlasLayout with_png = packed_layout(folder);
    CHECK((with_png.pages[0].fourth_apart == std::array{true, true}));
    CHECK(with_png.pages[0].fourth_beside_first(Texture::specular_gloss).empty());
    for (const AtlasMaterialRow& row : with_png.materials)
      CHECK(std::ranges::count(row.defines, "ETAK_GLOSS_APART") == 0);
    const std::vector<std::string> rules = rules_of(folder.file("out/layout.json"), picture_door());
    for (const Texture texture : both_textures) {
      const bool alpha = texture == Texture::diffuse_alpha;
      const std::string fourth = alpha ? "page0_alpha" : "page0_gloss";
      const Image8 exact = load_png(folder.file("out/page0_" + std::string(name(texture)) + ".png"));
      for (const std::string& kind : kinds) {
        CAPTURE(fourth, kind);
        const TextureFile colour = file_of(folder, "page0_" + std::string(name(texture)) + '.' + kind),
                          apart = file_of(folder, fourth + '.' + kind);
        CHECK((colour.blocks->block_bytes == 16 && apart.blocks->name == "R8"));
        CHECK(!apart.srgb);
        REQUIRE(apart.levels.size() == colour.levels.size());
        int others = 0;
        for (int y = 0; y < exact.height; ++y)
          for (int x = 0; x < exact.width; ++x) others += apart.levels[0].at(x, y)[0] != exact.at(x, y)[3];
        CHECK(others == 0);
      }
      if (word == "auto") {  // The header of a DDS file takes 148 bytes, and rows follow one another.
        const std::string bytes = slurp(folder.file("out/" + fourth + ".dds"));
        const auto at = static_cast<std::size_t>(148 + 5 * exact.width + 17);
        CHECK(static_cast<std::uint8_t>(bytes[at]) == exact.at(17, 5)[3]);
      }
      for (const BlockLevel& level : result.blocks)
        if (level.texture == texture) {
          CHECK((level.fourth_apart && !level.fallback));
          CHECK(level.bytes == level.texels + 16 * level.blocks);
          for (const BlockMaterial& m : level.materials) CHECK((m.met && m.fourth_largest == 0));
        }
    }

    options.output.write.formats = kinds;
    (void)pack_text(folder, manifest, options);
    const AtlasLayout layout = packed_layout(folder);
    CHECK(layout.pages[0].fourth_beside_first(Texture::diffuse_alpha) == "page0_alpha.ktx2");
    for (const char* define : {"ETAK_ALPHA_APART", "ETAK_GLOSS_APART"})
      CHECK(std::ranges::count(layout.materials[0].defines, define) == 1);
    CHECK(layout.xxh128.contains("page0_gloss.ktx2"));
    CHECK(rules_of(folder.file("out/layout.json"), picture_door()) == rules);
    const Pictures seen =
        load_pictures(targets_of_layout(folder.file("out/layout.json"), "l").at(0), picture_door());
    const Image8 gloss = file_of(folder, "page0_gloss.ktx2").levels[0];
    CHECK(seen.b.at(20, 30)[3] == gloss.at(20, 30)[0]);
    // What is not there any more goes.
    (void)pack_text(folder, manifest, in_blocks("none", kinds));
    CHECK_FALSE(is_there(folder.file("out/page0_gloss.ktx2")));
  }
}

TEST_CASE("levels of one channel whose lengths are no multiples of 4 are read as they were written") {
  std::vector<std::string> texels{std::string(15, 'a'), std::string(2, 'b'), std::string(1, 'c')};
  std::vector<TextureLevel> levels;
  for (std::size_t l = 0; l < texels.size(); ++l)
    levels.push_back({std::max(1, 5 >> l), std::max(1, 3 >> l), texels[l]});
  std::string file;
  write_ktx2(levels, block_format_named("R8"), false, 0,
             {[&](std::string_view more) { file += more; },
              [&](std::size_t at, std::string_view with) { file.replace(at, with.size(), with); }});
  const TextureFile read = read_ktx2(file, "a.ktx2");
  REQUIRE(read.levels.size() == 3);
  for (std::size_t l = 0; l < texels.size(); ++l)
    CHECK(std::string(read.levels[l].values.begin(), read.levels[l].values.end()) == texels[l]);
}

TEST_CASE("a fourth channel apart that holds floats is refused in one clear line") {
  const TempFolder folder;
  PackOptions options = in_blocks("auto", {"ktx2"});
  options.output.compress.budget = parse_block_budget("diffuse=3,f0=3");
  (void)pack_text(folder, noisy_fourths(folder, false), options);
  const Image8 gloss = file_of(folder, "page0_gloss.ktx2").levels[0];
  const BlockFormat* const floats = block_format_named("BC6H");
  const std::string bytes(texture_level_bytes(floats, gloss.width, gloss.height), '\3');
  const std::vector<TextureLevel> levels{{gloss.width, gloss.height, bytes}};
  std::string file;
  write_ktx2(levels, floats, false, 0,
             {[&](std::string_view more) { file += more; },
              [&](std::size_t at, std::string_view with) { file.replace(at, with.size(), with); }});
  spit(folder.file("out/page0_gloss.ktx2"), file);
  std::string told;
  for (const CheckTarget& target : targets_of_layout(folder.file("out/layout.json"), "l"))
    for (const Finding& finding : check(target, picture_door(), Settings{}).findings)
      if (finding.rule == "ETK001") told += finding.file + ": " + finding.message + '\n';
  CHECK(contains(told, "page0_gloss.ktx2"));
  CHECK(contains(told, "floats"));
  CHECK(std::ranges::count(told, '\n') == 1);
}

TEST_CASE("a fourth channel apart does not save colours that miss the budget") {
  const TempFolder folder;
  (void)pack_text(folder, noisy_fourths(folder, true), in_blocks("auto", {"png", "ktx2"}));
  const AtlasLayout layout = packed_layout(folder);
  CHECK((layout.pages[0].fourth_apart == std::array{false, true}));
  CHECK(file_of(folder, "page0_diffuse_alpha.ktx2").blocks == nullptr);
  CHECK_FALSE(is_there(folder.file("out/page0_alpha.ktx2")));
}

TEST_CASE(
    "small levels that no block holds are exact in a file of their own, and the others stay in blocks") {
  const TempFolder folder;
  // Squares of 8 x 8 texels of one colour each: blocks of levels 0 and 1 hold one colour, those of level 2 four,
  // and those of level 3 sixteen.
  const Image8 few = noise(16, 16, 3, 4);
  Image8 squares(128, 128, 3);
  for (int y = 0; y < squares.height; ++y)
    for (int x = 0; x < squares.width; ++x)
      std::copy_n(few.at(x / 8, y / 8).data(), 3, squares.at(x, y).data());
  save_png(folder.file("d.png"), squares);
  const std::string manifest =
      manifest_of({R"({"name": "w", "diffuse": "d.png", "gloss": 0.5, "specular": [0.04, 0.04, 0.04]})"});
  PackOptions options = in_blocks("auto");
  options.layout.mips = 0;
  (void)pack_text(folder, manifest, options);
  std::vector<Image8> exact;
  for (int l = 0; l < 8; ++l)
    exact.push_back(load_png(
        folder.file("out/page0_diffuse_alpha" + (l == 0 ? "" : ".mip" + std::to_string(l)) + ".png")));
  CHECK(packed_layout(folder).pages[0].tail_beside_first(Texture::diffuse_alpha).empty());
  const std::vector<std::string> rules = rules_of(folder.file("out/layout.json"), picture_door());
  options.output.write.formats = {"ktx2", "dds"};
  const PackResult result = pack_text(folder, manifest, options);
  for (const std::string kind : {"ktx2", "dds"}) {
    CAPTURE(kind);
    const TextureFile held = file_of(folder, "page0_diffuse_alpha." + kind),
                      tail = file_of(folder, "page0_diffuse_alpha_tail." + kind);
    REQUIRE(held.levels.size() == 3);
    CHECK((held.blocks->name == "BC7" && tail.blocks == nullptr && tail.srgb));
    REQUIRE(tail.levels.size() + 3 == exact.size());
    for (std::size_t l = 0; l < tail.levels.size(); ++l) CHECK(tail.levels[l].values == exact[l + 3].values);
  }
  for (const BlockLevel& level : result.blocks) {
    CHECK_FALSE(level.fallback);
    CHECK(level.tail == (level.level >= 3));
    CHECK(level.format == (level.tail ? "RGBA8" : "BC7"));
  }
  CHECK(result.blocks.size() == exact.size());
  const AtlasLayout layout = packed_layout(folder);
  CHECK(layout.pages[0].tail_beside_first(Texture::diffuse_alpha) == "page0_diffuse_alpha_tail.ktx2");
  CHECK(layout.pages[0].tail_beside_first(Texture::specular_gloss).empty());
  CHECK(std::ranges::count(layout.materials[0].defines, "ETAK_DIFFUSE_ALPHA_TAIL") == 1);
  CHECK(layout.xxh128.contains("page0_diffuse_alpha_tail.dds"));
  CHECK(rules_of(folder.file("out/layout.json"), picture_door()) == rules);
  options.output.compress = compress_word("bc7");
  (void)pack_text(folder, manifest, options);
  CHECK(file_of(folder, "page0_diffuse_alpha.ktx2").levels.size() == exact.size());
  CHECK_FALSE(is_there(folder.file("out/page0_diffuse_alpha_tail.ktx2")));
}

namespace {

// A material of 64 x 64 texels whose F0 is `specular`.
std::string material_of_f0(const TempFolder& folder, const std::string& name, const Image8& specular,
                           unsigned seed) {
  const std::string entry = blocks_material(folder, name, 64, 64, seed, 2);
  save_png(folder.file(name + "_specular.png"), specular);
  return entry;
}

Image8 grey_waves(unsigned seed) {
  const Image8 from = waves(64, 64, 1, seed, 2);
  Image8 out(64, 64, 3);
  for (std::size_t i = 0; i < out.values.size(); ++i) out.values[i] = from.values[i / 3];
  return out;
}

Image8 one_colour(std::array<std::uint8_t, 3> codes) {
  Image8 out(64, 64, 3);
  for (std::size_t i = 0; i < out.values.size(); ++i) out.values[i] = codes[i % 3];
  return out;
}

}  // namespace

TEST_CASE(
    "auto keeps of F0 and gloss the channels that vary, and layout, validator and OpenImageIO read them") {
  const TempFolder folder;
  const std::string a = material_of_f0(folder, "a", one_colour({60, 50, 40}), 1),
                    b = material_of_f0(folder, "b", one_colour({200, 200, 190}), 5),
                    grey = material_of_f0(folder, "g", grey_waves(9), 9),
                    coloured = blocks_material(folder, "c", 64, 64, 13, 1);
  struct Case {
    std::vector<std::string> entries;
    std::string format;
    std::vector<std::string> channels;
    std::string define;
  };
  const std::vector<Case> cases{{{a, b}, "BC4", {"gloss"}, "ETAK_GLOSS_IN_RED"},
                                {{a, grey}, "BC5", {"specular", "gloss"}, "ETAK_F0_GLOSS_IN_RED_GREEN"},
                                {{a, grey, coloured}, "BC7", {}, ""}};
  for (const Case& each : cases) {
    CAPTURE(each.format);
    // With PNG first, the defines are those of PNG.
    PackOptions exact = in_blocks("auto", {"png", "ktx2"});
    exact.output.compress.budget = parse_block_budget("5");
    (void)pack_text(folder, manifest_of(each.entries), exact);
    const Image8 page = load_png(folder.file("out/page0_specular_gloss.png"));
    const AtlasLayout with_png = packed_layout(folder);
    CHECK(with_png.pages[0].in_blocks == each.channels);
    for (const AtlasMaterialRow& row : with_png.materials)
      CHECK((each.define.empty() || std::ranges::count(row.defines, each.define) == 0));
    const std::vector<std::string> rules = rules_of(folder.file("out/layout.json"), picture_door());

    PackOptions options = in_blocks("auto", {"ktx2", "dds"});
    options.output.compress.budget = exact.output.compress.budget;
    const PackResult result = pack_text(folder, manifest_of(each.entries), options);
    const AtlasLayout layout = packed_layout(folder);
    CHECK(layout.pages[0].in_blocks == each.channels);
    const TextureFile ktx2 = ktx2_page(folder, "specular_gloss");
    const TextureFile dds = read_dds(slurp(folder.file("out/page0_specular_gloss.dds")), "page");
    CHECK(ktx2.blocks->name == each.format);
    CHECK((dds.blocks == ktx2.blocks && dds.levels == ktx2.levels));
    CHECK(ktx2.srgb == (each.format == "BC7"));
    CHECK(dds.srgb == ktx2.srgb);
    CHECK(rules_of(folder.file("out/layout.json"), picture_door()) == rules);
    const auto level = std::ranges::find(result.blocks, Texture::specular_gloss, &BlockLevel::texture);
    CHECK(level->format == each.format);
    if (each.define.empty()) continue;
    // An independent decoder, and the pictures that the validator sees.
    const std::string file = folder.file("out/page0_specular_gloss.dds");
    const Image8 theirs = codes_of(picture_door().file(file), false);
    const Pictures seen =
        load_pictures(targets_of_layout(folder.file("out/layout.json"), "l").at(0), picture_door());
    for (const BlockMaterial& m : level->materials) {
      CAPTURE(m.id);
      const AtlasRect& rect = rect_named(layout, m.id);
      const AtlasMaterialRow& row = *std::ranges::find(layout.materials, m.id, &AtlasMaterialRow::name);
      CHECK(std::ranges::count(row.defines, each.define) == 1);
      double colour = 0, gloss = 0;
      int apart = 0;
      for (int y = rect.y; y < rect.y + rect.height; ++y)
        for (int x = rect.x; x < rect.x + rect.width; ++x) {
          const auto from = page.at(x, y);
          const auto to = seen.b.at(x, y);
          if (row.constant[4])
            apart += to[0] != row.constant[4] || to[1] != row.constant[5] || to[2] != row.constant[6];
          const auto ours = theirs.at(x, y);
          const std::size_t at = each.format == "BC4" ? 0 : 1;
          apart += std::abs(ours[at] - to[3]) > 1;
          if (!row.constant[4]) apart += std::abs(ours[0] - to[0]) > 1;
          colour = std::max(colour, delta_e_of(from.data(), to.data()));
          gloss = std::max(gloss, 100 * (std::exp2(12 * std::abs(from[3] - to[3]) / 255.0) - 1));
        }
      CHECK(apart == 0);
      CHECK(m.colour_largest == Approx(colour).margin(1e-9));
      CHECK(m.fourth_largest == Approx(gloss).margin(1e-9));
    }
  }
}

}  // namespace etak
