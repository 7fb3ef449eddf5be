// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/image/blocks/blocks.h"
#include "core/judge/rules/rows.h"
#include "core/judge/rules/tile_boxes.h"

namespace etak {

namespace {

const std::string& owner_of(const CheckTile& tile) {
  return tile.island_of.empty() ? tile.name : tile.island_of;
}

// The tiles of a mip level, in blocks.
std::vector<TileBox> in_blocks(const std::vector<CheckTile>& tiles, int page_mips, int level,
                               const BlockFormat& format) {
  std::vector<TileBox> out;
  for (const CheckTile& tile : tiles) {
    const PixelBox& box = tile.box;
    if (box.width <= 0 || box.height <= 0 || level > tile.mips.value_or(page_mips)) continue;
    const auto first = [&](int at, int side) { return (at >> level) / side; };
    const auto last = [&](int at, int length, int side) { return ((at + length - 1) >> level) / side; };
    const int x = first(box.x, format.block_width), y = first(box.y, format.block_height);
    out.push_back({&tile,
                   {x, y, last(box.x, box.width, format.block_width) - x + 1,
                    last(box.y, box.height, format.block_height) - y + 1}});
  }
  sort_by_row(out);
  return out;
}

}  // namespace

constinit const Rule etk018_blocks_shared{
    .id = "ETK018",
    .slug = "blocks-shared",
    .title = "A block of texels belongs to two materials",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::header, Need::layout},
    .source = "Khronos Data Format Specification 1.3, chapters 18 to 23: a block has its own few colours",
    .what =
        "Atlas in DDS or KTX2: on a mip level that is kept, texels of two materials lie in one block, of 4 x 4 texels in BC1 to BC7.",
    .why =
        "The texels of a block share two or a few colours. Where two materials meet in one, each takes on something of the other, and no encoder can prevent it.",
    .example = "Regions on odd places, compressed after packing by a tool that knows no regions.",
    .fix = "Pack again with --compress, which puts regions on the grid of the blocks at every kept level.",
    .check = [](RuleCheck& check) {
      const Manifest& manifest = check.target.manifest;
      const int page_mips = manifest.mips.value_or(0);
      int levels = page_mips;
      for (const CheckTile& tile : manifest.tiles) levels = std::max(levels, tile.mips.value_or(page_mips));
      for (const PictureEvidence& picture : check.evidence.headers) {
        const BlockFormat* format = block_format_named(picture.header.blocks);
        if (format == nullptr) continue;
        std::vector<const CheckTile*> told;  // one finding a tile, at its first level
        for (int level = 0; level <= levels; ++level) {
          const std::vector<TileBox> all = in_blocks(manifest.tiles, page_mips, level, *format);
          for (std::size_t i = 0; i < all.size(); ++i) {
            const CheckTile* other = met_tile(
                all, i, [&](const CheckTile& each) { return owner_of(each) != owner_of(*all[i].tile); });
            if (other == nullptr || std::ranges::find(told, all[i].tile) != told.end()) continue;
            told.push_back(all[i].tile);
            Finding& finding = check.report(picture);
            finding.tile = all[i].tile->name;
            finding.box = all[i].tile->box;
            finding.value = std::string(format->name);
            finding.message = "on level " + std::to_string(level) + " the tile shares a block of " +
                              std::to_string(format->block_width) + " x " +
                              std::to_string(format->block_height) + " texels with \"" + other->name + "\"";
          }
        }
      }
    }};

}  // namespace etak
