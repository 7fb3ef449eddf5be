// SPDX-License-Identifier: Apache-2.0
// Atlases whose textures are in blocks.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <map>
#include <numbers>
#include <random>
#include <thread>
#include <tuple>

#include "core/brdf/models.h"
#include "core/color/delta_e.h"
#include "core/color/srgb.h"
#include "core/image/astc_codec.h"
#include "core/image/blocks/budget.h"
#include "core/image/files/containers.h"
#include "core/image/flip.h"
#include "core/image/image_io.h"
#include "core/light/lights.h"
#include "core/validate/files/check.h"
#include "core/validate/files/layout_targets.h"
#include "core/validate/files/load.h"
#include "tests/core/atlas/blocks_support.h"

namespace etak {
namespace {

using namespace test;

// The value that 99 of 100 do not exceed.
double percentile_99_of(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() - values.size() / 100 - 1];
}

}  // namespace

TEST_CASE("KTX2 and DDS hold the same blocks, which change each material by what the report says") {
  const TempFolder folder;
  const std::string manifest =
      manifest_of({blocks_material(folder, "a", 96, 64, 1, 3), blocks_material(folder, "b", 40, 72, 5, 9)});
  const PackResult result = pack_text(folder, manifest, in_blocks("bc7"));
  const AtlasLayout layout = packed_layout(folder);
  for (const std::string texture : {"diffuse_alpha", "specular_gloss"}) {
    const TextureFile ktx2 = ktx2_page(folder, texture);
    const TextureFile dds = read_dds(slurp(folder.file("out/page0_" + texture + ".dds")), "page");
    CHECK(ktx2.blocks->code == BlockCode::bc7);
    CHECK(dds.blocks == ktx2.blocks);
    CHECK((ktx2.srgb && dds.srgb));
    CHECK(dds.custom_alpha == (texture == "specular_gloss"));
    CHECK(ktx2.levels == dds.levels);
    CHECK(static_cast<int>(ktx2.levels.size()) == layout.levels);
    const Image8 exact = load_png(folder.file("out/page0_" + texture + ".png"));
    for (const BlockLevel& level : result.blocks) {
      if (level.level != 0 || name(level.texture) != texture) continue;
      CHECK(level.format == "BC7");
      CHECK(level.shared == 0);
      CHECK(8 * level.bytes == 8 * level.texels);
      CHECK(level.materials.size() == 2);
      for (const BlockMaterial& m : level.materials) {
        CAPTURE(texture, m.id);
        const AtlasRect& rect = rect_named(layout, m.id);
        std::vector<double> colour, fourth;
        for (int y = rect.y; y < rect.y + rect.height; ++y)
          for (int x = rect.x; x < rect.x + rect.width; ++x) {
            const auto from = exact.at(x, y), to = ktx2.levels[0].at(x, y);
            colour.push_back(delta_e_of(from.data(), to.data()));
            const double off = std::abs(from[3] - to[3]);
            fourth.push_back(texture == "specular_gloss" ? 100 * (std::exp2(12 * off / 255) - 1)
                                                         : 100 * off / 255);
          }
        CHECK(m.colour_p99 == Approx(percentile_99_of(colour)).margin(0.0101));
        CHECK(m.fourth_p99 == Approx(percentile_99_of(fourth)).margin(0.101));
        CHECK(m.colour_largest == Approx(*std::ranges::max_element(colour)).margin(1e-9));
        CHECK(m.fourth_largest == Approx(*std::ranges::max_element(fourth)).margin(1e-9));
        CHECK(m.met == (m.colour_p99 <= 1 && m.fourth_p99 <= (texture == "specular_gloss" ? 10 : 0.5)));
      }
    }
  }
  CHECK(result.totals->output[0].totals.gpu <
        static_cast<std::uint64_t>(result.pages[0].width * result.pages[0].height * 3 / 2));
}

TEST_CASE("no block on a clean level holds texels of two regions, by layout.json alone") {
  std::mt19937 random(9);
  // Sides of blocks, and what else is asked for.
  for (const auto& [side, round] : {std::pair(4, 0), {4, 1}, {4, 2}, {5, 0}, {6, 1}, {6, 2}, {8, 0}}) {
    const TempFolder folder;
    std::vector<std::string> entries;
    for (int i = 0; i < 7; ++i) {
      const auto some = [&] { return 20 + static_cast<int>(random() % 130); };
      const int width = round == 2 ? 64 : some(), height = round == 2 ? 64 : some();
      entries.push_back(blocks_material(folder, "m" + std::to_string(i), width, height,
                                        static_cast<unsigned>(100 * i) + static_cast<unsigned>(random() % 99),
                                        2));
    }
    const std::string sides = std::to_string(side) + 'x' + std::to_string(side);
    PackOptions options = in_blocks(side == 4 ? "bc7" : "astc:" + sides, {"ktx2"});
    options.output.compress.effort = 1;
    options.output.compress.budget = parse_block_budget("1000");  // where blocks lie is all that counts here
    options.layout.rotate = round == 1;
    if (round == 1) options.layout.gutter = 4;
    const PackResult result = pack_text(folder, manifest_of(entries), options);
    for (const BlockLevel& level : result.blocks) CHECK(level.shared == 0);
    const AtlasLayout layout = packed_layout(folder);
    std::map<std::tuple<int, int, int, int>, std::string> holder;  // of a block: page, level, column, row
    std::size_t shared = 0, blocks = 0;
    for (const AtlasRect& rect : layout.rects)
      for (int level = 0; level < rect.mips; ++level) {
        const int texel = 1 << level, block = side * texel;
        const auto first = [&](int at) { return (at - rect.gutter) / block; };
        const auto last = [&](int at, int size) {
          return ((at + size + rect.gutter + texel - 1) / texel * texel - 1) / block;
        };
        for (int y = first(rect.y); y <= last(rect.y, rect.height); ++y)
          for (int x = first(rect.x); x <= last(rect.x, rect.width); ++x, ++blocks)
            shared += holder.try_emplace({rect.page, level, x, y}, rect.name).first->second != rect.name;
      }
    CAPTURE(side, round);
    CHECK(blocks > 400);
    CHECK(shared == 0);
  }
}

TEST_CASE("a texture by which a material misses the budget stays RGBA8, exactly, and the others do not") {
  const TempFolder folder;
  save_png(folder.file("n.png"), noise(64, 64, 3, 1));
  const std::string entry = blocks_material(folder, "a", 64, 64, 1, 1);
  const std::string wild =
      "{\"name\": \"w\", \"diffuse\": \"a_diffuse.png\", \"specular\": "
      "\"n.png\", \"gloss\": \"a_gloss.png\"}";
  const PackResult result = pack_text(folder, manifest_of({entry, wild}), in_blocks("auto"));
  CHECK(ktx2_page(folder, "diffuse_alpha").blocks != nullptr);
  const TextureFile kept = ktx2_page(folder, "specular_gloss");
  CHECK(kept.blocks == nullptr);
  CHECK(kept.levels[0] == load_png(folder.file("out/page0_specular_gloss.png")));
  const auto level = std::ranges::find(result.blocks, Texture::specular_gloss, &BlockLevel::texture);
  CHECK((level->fallback && level->format == "RGBA8"));
  const auto missed = std::ranges::find(level->materials, std::string("w"), &BlockMaterial::id);
  REQUIRE(missed != level->materials.end());
  CHECK((!missed->met && missed->colour_p99 > 1));
  // Whoever wants blocks whatever they cost has them, and so has a budget that allows it.
  PackOptions wide = in_blocks("auto");
  wide.output.compress.budget = parse_block_budget("1000");
  for (const PackOptions& options : {in_blocks("bc7"), wide}) {
    (void)pack_text(folder, manifest_of({entry, wild}), options);
    CHECK(ktx2_page(folder, "specular_gloss").blocks != nullptr);
  }
}

TEST_CASE(
    "ASTC takes the bits that its blocks say, changes materials by what the report says, and goes with KTX2 alone") {
  const TempFolder folder;
  const std::string manifest =
      manifest_of({blocks_material(folder, "a", 96, 64, 1, 3), blocks_material(folder, "b", 40, 72, 5, 9)});
  for (const int side : {4, 5, 6, 8}) {
    const std::string sides = std::to_string(side) + 'x' + std::to_string(side);
    CAPTURE(sides);
    std::vector<std::string> files;
    for (const unsigned threads : {1u, 3u}) {
      PackOptions options = in_blocks("astc:" + sides, {"png", "ktx2"});
      options.output.compress.effort = 1;
      options.output.compress.budget = parse_block_budget("1000");  // no block is tried twice
      options.run.threads = threads;
      const PackResult result = pack_text(folder, manifest, options);
      files.push_back(slurp(folder.file("out/page0_specular_gloss.ktx2")));
      const TextureFile texture = ktx2_page(folder, "specular_gloss");
      const AtlasLayout layout = packed_layout(folder);
      CHECK(texture.blocks->name == "ASTC " + sides);
      CHECK(texture.srgb);
      const Image8 exact = load_png(folder.file("out/page0_specular_gloss.png"));
      const auto level = std::ranges::find(result.blocks, Texture::specular_gloss, &BlockLevel::texture);
      CHECK(level->format == "ASTC " + sides);
      const auto blocks = static_cast<std::size_t>((exact.width + side - 1) / side) *
                          static_cast<std::size_t>((exact.height + side - 1) / side);
      CHECK((level->blocks == blocks && level->bytes == 16 * blocks));
      for (const BlockMaterial& m : level->materials) {
        const AtlasRect& rect = rect_named(layout, m.id);
        double colour = 0;
        for (int y = rect.y; y < rect.y + rect.height; ++y)
          for (int x = rect.x; x < rect.x + rect.width; ++x)
            colour = std::max(colour, delta_e_of(exact.at(x, y).data(), texture.levels[0].at(x, y).data()));
        CHECK(m.colour_largest == Approx(colour).margin(1e-9));
      }
    }
    CHECK(files[0] == files[1]);
  }
  // Without the program's encoder there is no such texture, and the folder is as it was.
  PackOptions bare = in_blocks("astc", {"ktx2"});
  bare.input.pictures.door.astc = {};
  CHECK(contains(error_of([&] { (void)pack_text(folder, manifest, bare); }), "no encoder of ASTC"));
  CHECK(ktx2_page(folder, "specular_gloss").blocks->name == "ASTC 8x8");
}

TEST_CASE("blocks are the same for any number of threads, and a mask in blocks is exact") {
  const TempFolder folder;
  Image8 mask(64, 64, 1);
  std::mt19937 random(4);
  for (auto& each : mask.values) each = random() % 3 == 0 ? 0 : 255;
  save_png(folder.file("mask.png"), mask);
  std::string entry = blocks_material(folder, "a", 64, 64, 1, 6);
  entry.insert(entry.size() - 1, R"(, "alpha": "mask.png", "alpha_mode": "mask")");
  std::vector<std::string> files;
  for (const unsigned threads : {1u, 3u}) {
    PackOptions options = in_blocks("bc7", {"ktx2"});
    options.run.threads = threads;
    const PackResult result = pack_text(folder, manifest_of({entry}), options);
    CHECK(result.blocks[0].materials[0].fourth_largest == 0);
    files.push_back(slurp(folder.file("out/page0_diffuse_alpha.ktx2")));
  }
  CHECK(files[0] == files[1]);
}

TEST_CASE("texels that no triangle of a scene reads weigh nothing in its blocks") {
  const TempFolder folder;
  constexpr int side = 64;
  // Beyond the diagonal there is noise, which the one triangle does not reach.
  Image8 picture = waves(side, side, 3, 1, 0);
  std::mt19937 random(2);
  for (int y = 0; y < side; ++y)
    for (int x = side + 2 - y; x < side; ++x)
      for (std::uint8_t& code : picture.at(x, y)) code = static_cast<std::uint8_t>(random());
  save_png(folder.file("colour.png"), picture);
  std::string buffer;
  for (const float value : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f}) {
    std::array<char, sizeof value> bytes{};
    std::memcpy(bytes.data(), &value, sizeof value);
    buffer.append(bytes.data(), bytes.size());
  }
  spit(folder.file("mesh.bin"), buffer);
  spit(folder.file("scene.gltf"), R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}],
    "materials": [{"name": "m", "pbrMetallicRoughness": {"metallicFactor": 0, "baseColorTexture": {"index": 0}}}],
    "textures": [{"source": 0, "sampler": 0}], "samplers": [{"wrapS": 33071, "wrapT": 33071}],
    "images": [{"uri": "colour.png"}], "buffers": [{"uri": "mesh.bin", "byteLength": 60}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
      {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}]})");
  PackOptions options = in_blocks("bc7", {"png", "ktx2"});
  options.leave_out.keep = {"islands"};
  const PackResult result = pack(folder.file("scene.gltf"), folder.file("out"), options, built_in_library());
  const BlockLevel& level = result.blocks.at(0);
  REQUIRE(level.materials.size() == 1);
  CHECK(level.texture == Texture::diffuse_alpha);
  // The whole picture is on the page, but what is told is of the triangle.
  const TextureFile texture = ktx2_page(folder, "diffuse_alpha");
  const Image8 exact = load_png(folder.file("out/page0_diffuse_alpha.png"));
  const AtlasRect rect = rect_named(packed_layout(folder), "m");
  REQUIRE((rect.width == side && rect.height == side));
  double read = 0, all = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const double difference = delta_e_of(exact.at(rect.x + x, rect.y + y).data(),
                                           texture.levels[0].at(rect.x + x, rect.y + y).data());
      all = std::max(all, difference);
      if (x + y < side) read = std::max(read, difference);
    }
  CHECK(level.materials[0].colour_largest >= read - 1e-9);
  CHECK(level.materials[0].colour_largest < 3);
  CHECK(all > 10);
}

TEST_CASE("what blocks change of a material under light is told with both textures") {
  const TempFolder folder;
  std::string entry = blocks_material(folder, "a", 32, 32, 1, 12);
  entry.insert(entry.size() - 1, R"(, "alpha_mode": "opaque")");
  const PackResult result = pack_text(folder, manifest_of({entry}), in_blocks("bc7", {"png", "ktx2"}));
  const AtlasRect rect = rect_named(packed_layout(folder), "a");
  using Look = std::array<std::uint8_t, 8>;
  const auto look = [](const Image8& diffuse, const Image8& specular, int x, int y) {
    Look out{};
    std::copy_n(diffuse.at(x, y).data(), 4, out.data());
    std::copy_n(specular.at(x, y).data(), 4, out.data() + 4);
    return out;
  };
  const auto lit = [](const Look& codes, double degrees) {
    const double tilt = degrees * std::numbers::pi / 180;
    Vec3 sum{};
    for (const Light& light : default_lights().lights) {
      const Vec3 to{-light.direction[0], -light.direction[1], std::abs(light.direction[2])};
      const Vec3 key = default_lights().lights[0].direction;
      const double across = std::sin(tilt) / std::hypot(key[0], key[1]);
      const Directions ways{to[0], to[1], to[2], across * key[0], across * key[1], std::cos(tilt)};
      std::array<double, 4> values{};
      for (std::size_t c = 0; c < 3; ++c) values[c] = srgb_decode(codes[4 + c] / 255.0);
      values[3] = codes[7] / 255.0;
      std::array<double, 3> lobe{};
      find_model(default_specular)->f64(ways, values.data(), lobe.data());
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += light.intensity * light.color[c] * to[2] *
                  (srgb_decode(codes[c] / 255.0) / std::numbers::pi + lobe[c]);
    }
    return Vec3{std::min(1.0, sum[0]), std::min(1.0, sum[1]), std::min(1.0, sum[2])};
  };
  const Image8 diffuse = load_png(folder.file("out/page0_diffuse_alpha.png")),
               specular = load_png(folder.file("out/page0_specular_gloss.png"));
  const TextureFile d = ktx2_page(folder, "diffuse_alpha"), s = ktx2_page(folder, "specular_gloss");
  // Differences, and what the region looks like both ways from the direction from which they are largest.
  std::vector<double> differences;
  double most = 0, seen = 0;
  for (const double degrees : {0.0, 20.0, 40.0, 60.0, 75.0}) {
    Image exact(rect.width, rect.height, 3), held = exact;
    double sum = 0;
    for (int y = 0; y < rect.height; ++y)
      for (int x = 0; x < rect.width; ++x) {
        const Vec3 from = lit(look(diffuse, specular, rect.x + x, rect.y + y), degrees),
                   to = lit(look(d.levels[0], s.levels[0], rect.x + x, rect.y + y), degrees);
        for (std::size_t c = 0; c < 3; ++c) {
          exact.at(x, y)[c] = static_cast<float>(from[c]);
          held.at(x, y)[c] = static_cast<float>(to[c]);
        }
        differences.push_back(delta_e2000(to_lab(LinearRgb{from[0], from[1], from[2]}),
                                          to_lab(LinearRgb{to[0], to[1], to[2]})));
        sum += differences.back();
      }
    if (sum <= most) continue;
    most = sum;
    seen = flip(flip_view(exact), flip_view(held)).mean;
  }
  int told = 0;
  for (const BlockLevel& level : result.blocks) {
    if (level.materials.empty()) continue;
    CHECK(level.materials[0].shaded.has_value() == (level.level == 0));
    if (!level.materials[0].shaded) continue;
    ++told;
    CHECK(level.materials[0].shaded->largest == Approx(*std::ranges::max_element(differences)).margin(1e-9));
    CHECK(level.materials[0].shaded->p99 == Approx(percentile_99_of(differences)).margin(0.0101));
    CHECK(level.materials[0].shaded->p99 > 0.1);
    CHECK(level.materials[0].shaded->flip == Approx(seen).epsilon(1e-5));
    CHECK(seen > 0.001);
  }
  CHECK(told == 2);
  CHECK(contains(report_text(result, false), "and by a mean FLIP of "));
}

TEST_CASE("FLIP of a material in blocks is of the part that they change most") {
  const TempFolder folder;
  const std::string entry = blocks_material(folder, "a", 512, 256, 1, 0);
  Image8 flat(512, 256, 3, 90);
  save_png(folder.file("a_specular.png"), flat);
  save_png(folder.file("a_gloss.png"), Image8(512, 256, 1, 90));
  paste(waves(40, 40, 3, 1, 60), 400, 200, flat);
  save_png(folder.file("a_diffuse.png"), flat);
  const PackResult result = pack_text(folder, manifest_of({entry}), in_blocks("bc7", {"ktx2"}));
  REQUIRE(result.blocks.at(0).materials.at(0).shaded);
  CHECK(result.blocks[0].materials[0].shaded->flip > 0.001);
}

TEST_CASE("the weights of a block's channels depend on that block alone") {
  std::mt19937 random(9);
  std::vector<AnyBlock> blocks(3000);
  for (AnyBlock& block : blocks) {
    block.counting = 1u + random() % 0xffff;
    for (auto& texel : block.texels)
      for (std::uint8_t& code : texel) code = static_cast<std::uint8_t>(random() % 40);
  }
  const BlockMeasure measure(Texture::diffuse_alpha, GlossForm::schueler, {}),
      other(Texture::specular_gloss, GlossForm::schueler, {2, 3, 4, 5});
  std::vector<AnyBlock> forward = blocks, back = blocks;
  for (AnyBlock& block : forward) measure.weigh(block);
  std::thread([&] {
    for (std::size_t b = blocks.size(); b-- > 0;) {
      AnyBlock beside = blocks[b];
      other.weigh(beside);
      measure.weigh(back[b]);
    }
  }).join();
  for (std::size_t b = 0; b < blocks.size(); ++b)
    CHECK((forward[b].weights == back[b].weights && forward[b].pairs == back[b].pairs));
}

TEST_CASE("pictures show the materials that blocks change most, where they do") {
  const TempFolder folder;
  const std::string flat = blocks_material(folder, "flat", 64, 64, 1, 0),
                    noisy = blocks_material(folder, "noisy", 64, 64, 3, 40),
                    middle = blocks_material(folder, "middle", 64, 64, 5, 10);
  PackOptions options = in_blocks("bc7", {"ktx2"});
  const std::string manifest = manifest_of({flat, noisy, middle});
  CHECK(pack_text(folder, manifest, options).block_pictures.empty());
  options.run.block_pictures = 2;
  const PackResult result = pack_text(folder, manifest, options);
  std::map<std::string, double> told;
  for (const BlockLevel& level : result.blocks)
    for (const BlockMaterial& m : level.materials)
      if (m.shaded) told[m.id] = m.shaded->p99;
  REQUIRE(told.size() == 3);
  REQUIRE(result.block_pictures.size() == 2);
  const BlockPicture &first = result.block_pictures[0], &second = result.block_pictures[1];
  const auto least = std::ranges::min_element(told, {}, [](const auto& each) { return each.second; });
  CHECK(least->first == "flat");
  CHECK(first.material != second.material);
  CHECK(told.at(first.material) >= told.at(second.material));
  CHECK(told.at(second.material) > least->second);
  CHECK(first.shaded.p99 == told.at(first.material));
  const AtlasRect rect = rect_named(packed_layout(folder), first.material);
  CHECK(first.x == rect.x);
  CHECK(first.y == rect.y);
  REQUIRE(first.exact.width == rect.width);
  REQUIRE(first.held.height == rect.height);
  // Pictures have 8 bits, of which half a code in each channel changes dE by up to 1.13 (dark colours).
  std::size_t whites = 0;
  for (int y = 0; y < rect.height; ++y)
    for (int x = 0; x < rect.width; ++x) {
      const double shown = white_difference * first.difference.at(x, y)[0] / 255,
                   of_codes = delta_e_of(first.exact.at(x, y).data(), first.held.at(x, y).data());
      if (shown >= white_difference) ++whites;
      CHECK((shown < white_difference ? std::abs(shown - of_codes) : white_difference - of_codes) < 1.2);
    }
  CHECK(whites > 0);
}

TEST_CASE("a budget is a multiple of the usual one, or names its parts") {
  CHECK(parse_block_budget("2") == BlockBudget{2, 2, 20, 1});
  CHECK(parse_block_budget("gloss=5,alpha=1") == BlockBudget{1, 1, 5, 1});
  for (const char* bad :
       {"", "0", "-1", "nan", "gloss", "gloss=", "gloss=0", "gloss=1,gloss=2", "f0=1,", "g=1", "inf"})
    CHECK(contains(error_of([&] { (void)parse_block_budget(bad); }), "each once"));
}

}  // namespace etak
