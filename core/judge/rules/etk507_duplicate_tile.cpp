// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <tuple>

#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk507_duplicate_tile{
    .id = "ETK507",
    .slug = "duplicate-tile",
    .title = "Two tiles hold the same texels",
    .severity = Severity::info,
    .needs = {Need::bytes_a, Need::bytes_b, Need::layout},
    .source = "etak",
    .what = "Atlas: two tiles are equal in both pictures, byte by byte.",
    .why = "Wasted area: both materials can use one tile.",
    .example = "One texture set used by two materials, packed twice.",
    .fix = "Let the packer join equal materials.",
    .check = [](RuleCheck& check) {
      std::map<std::tuple<std::uint64_t, std::uint64_t, int, int>, const TileEvidence*> seen;
      for (const TileEvidence& tile : check.evidence.tiles) {
        // The constants of a layout are no texels, so that none are stored twice.
        if (!tile.hashed || (tile.tile.flat[0] && tile.tile.flat[1])) continue;
        const auto [first, fresh] =
            seen.try_emplace({tile.hash[0], tile.hash[1], tile.tile.box.width, tile.tile.box.height}, &tile);
        if (fresh) continue;
        Finding& finding = check.report(tile, FileRole::diffuse_alpha);
        finding.area_px = tile.counts.texels;
        finding.area_share = 1;
        finding.value = "equal to \"" + first->second->tile.name + "\"";
        finding.message = "the tile equals \"" + first->second->tile.name + "\"";
      }
    }};

}  // namespace etak
