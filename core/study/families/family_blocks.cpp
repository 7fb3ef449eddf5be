// SPDX-License-Identifier: Apache-2.0
// Family l: textures in blocks, by what they change of a material and not of a picture.
#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/base/number.h"
#include "core/image/astc_codec.h"
#include "core/image/blocks/budget.h"
#include "core/pack/blocks/block_codec.h"
#include "core/study/families/families.h"
#include "core/study/made_pages.h"
#include "core/study/measure.h"

namespace etak {
namespace {

constexpr int timed_side = 64;

// A way to keep a texture in blocks.
//   alike   all channels weigh the same, as tools weigh them that know no material
struct Way {
  std::string id, title, format;
  int effort = 2;
  bool alike = false;
};

std::vector<Way> block_ways() {
  std::vector<Way> out;
  for (int effort = 1; effort <= 3; ++effort)
    out.push_back({"bc7_" + std::to_string(effort), "BC7, effort " + std::to_string(effort), "BC7", effort});
  out.push_back({"bc7_alike", "BC7, effort 2, all channels alike", "BC7", 2, true});
  constexpr std::array presets{"fast", "medium", "thorough"};
  for (int effort = 1; effort <= 3; ++effort) {
    const std::string preset = presets[static_cast<std::size_t>(effort - 1)];
    out.push_back({"astc4_" + std::to_string(effort), "ASTC 4x4, " + preset, "ASTC 4x4", effort});
  }
  out.push_back({"astc4_alike", "ASTC 4x4, medium, all channels alike", "ASTC 4x4", 2, true});
  for (const int side : {5, 6, 8}) {
    const std::string sides = std::to_string(side) + 'x' + std::to_string(side);
    out.push_back({"astc" + std::to_string(side), "ASTC " + sides + ", medium", "ASTC " + sides});
  }
  return out;
}

std::vector<AnyBlock> blocks_of(const Image8& page, const BlockFormat& format, const BlockMeasure& measure,
                                bool alike) {
  std::vector<AnyBlock> out;
  for (int top = 0; top < page.height; top += format.block_height)
    for (int left = 0; left < page.width; left += format.block_width) {
      AnyBlock& block = out.emplace_back();
      const int count = format.block_width * format.block_height;
      for (int i = 0; i < count; ++i) {
        const auto texel = page.at(std::min(page.width - 1, left + i % format.block_width),
                                   std::min(page.height - 1, top + i / format.block_width));
        std::copy_n(texel.data(), 4, block.texels[static_cast<std::size_t>(i)].data());
        block.counting |= std::uint64_t{1} << i;
      }
      if (!alike) measure.weigh(block);
    }
  return out;
}

// What a way makes of a page: colour in dE2000, and the fourth channel in percent.
struct BlockErrors {
  TexelSpread colour{0.01}, fourth{0.05};
  double colour_sum = 0, fourth_sum = 0;
};

BlockErrors errors_of(const Image8& page, const BlockCodec& codec, const Way& way,
                      const BlockMeasure& measure) {
  const BlockFormat& format = codec.format();
  const std::vector<AnyBlock> blocks = blocks_of(page, format, measure, way.alike);
  std::vector<std::uint8_t> bytes(format.block_bytes * blocks.size());
  codec.encode(blocks, {way.effort}, bytes.data());
  const auto texels = codec.decode(bytes.data(), blocks.size());
  BlockErrors out;
  const int across = (page.width + format.block_width - 1) / format.block_width;
  for (int y = 0; y < page.height; ++y)
    for (int x = 0; x < page.width; ++x) {
      const auto block = static_cast<std::size_t>(y / format.block_height * across + x / format.block_width);
      const auto in_block =
          static_cast<std::size_t>(y % format.block_height * format.block_width + x % format.block_width);
      std::array<std::uint8_t, 4> from{};
      std::copy_n(page.at(x, y).data(), 4, from.data());
      const auto& to = texels[codec.texels() * block + in_block];
      const double colour = measure.colour(from, to), fourth = measure.fourth(from[3], to[3], -1);
      out.colour.add(colour);
      out.fourth.add(fourth);
      out.colour_sum += colour;
      out.fourth_sum += fourth;
    }
  return out;
}

TimedCase timed_way(const Image8& page, const Way& way, const std::shared_ptr<const BlockMeasure>& measure,
                    const std::shared_ptr<const AstcDoor>& door) {
  const BlockFormat& format = *block_format_named(way.format);
  Image8 part(timed_side, timed_side, 4);
  for (int y = 0; y < timed_side; ++y)
    for (int x = 0; x < timed_side; ++x) std::copy_n(page.at(x, y).data(), 4, part.at(x, y).data());
  const auto blocks =
      std::make_shared<const std::vector<AnyBlock>>(blocks_of(part, format, *measure, way.alike));
  const auto bytes = std::make_shared<std::vector<std::uint8_t>>(format.block_bytes * blocks->size());
  return {way.id, std::size_t{timed_side} * timed_side, [blocks, bytes, door, &format, effort = way.effort] {
            BlockCodec(format, *door).encode(*blocks, {effort}, bytes->data());
            keep(bytes->data());
          }};
}

ErrorTimeTable block_table(const MadePage& page, Texture texture, std::vector<TimedSet>& timings) {
  const auto measure = std::make_shared<const BlockMeasure>(texture, GlossForm::schueler, BlockBudget{});
  const auto door = std::make_shared<const AstcDoor>(astc_door());
  const bool gloss = texture == Texture::specular_gloss;
  ErrorTimeTable table;
  table.id = page.id;
  table.title = gloss ? "F0 and gloss" : "Diffuse colour";
  table.time_unit = "ns per texel";
  table.base = "bc7_2";
  if (gloss)
    table.metrics = {{"gloss_p99", "exponent, 99 % of texels within", "%"},
                     {"gloss_mean", "exponent, mean", "%"},
                     {"f0_de_p99", "F0, 99 % of texels within", "\u0394E2000"},
                     {"f0_de_mean", "F0, mean", "\u0394E2000"}};
  else
    table.metrics = {{"diffuse_de_p99", "99 % of texels within", "\u0394E2000"},
                     {"diffuse_de_mean", "mean", "\u0394E2000"}};
  table.metrics.push_back({"bits", "bits a texel", ""});
  std::vector<TimedCase> cases;
  for (const Way& way : block_ways()) {
    const BlockCodec codec(*block_format_named(way.format), *door);
    const BlockErrors found = errors_of(page.pixels, codec, way, *measure);
    const double bits = bits_per_texel(codec.format());
    const auto count = static_cast<double>(page.pixels.pixel_count());
    ErrorTimeRow row;
    row.id = way.id;
    row.title = way.title;
    if (gloss) row.errors = {found.fourth.percentile_99(), found.fourth_sum / count};
    row.errors.insert(row.errors.end(), {found.colour.percentile_99(), found.colour_sum / count, bits});
    row.truth = number(bits, 3) + " bits a texel";
    table.rows.push_back(std::move(row));
    cases.push_back(timed_way(page.pixels, way, measure, door));
  }
  timings.push_back({{table.id}, std::move(cases)});
  return table;
}

const ErrorTimeRow& way_named(const ErrorTimeTable& table, std::string_view id) {
  return *std::ranges::find(table.rows, id, &ErrorTimeRow::id);
}

}  // namespace

ErrorTimeFamily block_family(const ReportOptions& options) {
  const int side = options.full ? 512 : 128;
  const std::vector<MadePage> pages = made_pages(side);
  const auto page = [&](std::string_view id) -> const MadePage& {
    return *std::ranges::find_if(pages, [&](const MadePage& each) { return each.id == id; });
  };
  ErrorTimeFamily family;
  family.id = "blocks";
  family.letter = "l";
  family.title = "Textures in blocks for a GPU";
  family.reference = "the texture as RGBA8; gloss by the exponent, colours by CIEDE2000";
  family.grid = "made pages of " + std::to_string(side) + " x " + std::to_string(side);
  family.tables = {block_table(page("materials"), Texture::specular_gloss, family.timed),
                   block_table(page("stone"), Texture::diffuse_alpha, family.timed)};
  const auto within = [&](std::size_t table, std::string_view id) {
    return number(way_named(family.tables[table], id).errors[0], 2);
  };
  family.advice =
      "Give F0 with gloss 8 bits a texel, and save bits on diffuse colour: 99 % of exponents are within " +
      within(0, "bc7_2") + " % in BC7 and " + within(0, "astc4_2") + " % in ASTC 4x4, " + within(0, "astc5") +
      " % at 5.1 bits (ASTC 5x5), " + within(0, "astc6") + " % at 3.6 (6x6) and " + within(0, "astc8") +
      " % at 2 (8x8); of diffuse colours 99 % are within \u0394E2000 " + within(1, "bc7_2") + ", " +
      within(1, "astc4_2") + ", " + within(1, "astc5") + ", " + within(1, "astc6") + " and " +
      within(1, "astc8") + ".";
  family.picks = {
      {"F0 and gloss on desktop and consoles", "materials", "bc7_2",
       "8 bits a texel, each channel weighed by what it changes",
       "etak pack IN -o OUT --textures dds --compress auto"},
      {"F0 and gloss on phones", "materials", "astc4_2", "8 bits a texel; fewer show in the gloss first",
       "etak pack IN -o OUT --textures ktx2 --compress astc"}};
  family.notes = {
      "Ways of the same number of bits a texel are compared with each other.",
      "ASTC is compressed by astcenc, in Debian's build, which has no vector instructions.",
      "Times are of one thread, without what etak pack does beside: measuring each texel, and trying blocks "
      "again that miss the budget."};
  return family;
}

}  // namespace etak
