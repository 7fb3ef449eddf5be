// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <string_view>
#include <tuple>
#include <vector>

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
      // The pieces of an island that is packed by its outline have one name, and are one tile.
      std::vector<std::vector<const TileEvidence*>> islands;
      std::map<std::string_view, std::size_t> by_name;
      for (const TileEvidence& tile : check.evidence.tiles) {
        // The constants of a layout are no texels, so that none are stored twice.
        if (!tile.hashed || (tile.tile.flat[0] && tile.tile.flat[1])) continue;
        const auto [known, fresh] = by_name.try_emplace(tile.tile.name, islands.size());
        if (fresh) islands.emplace_back();
        islands[known->second].push_back(&tile);
      }
      using Texels = std::tuple<std::uint64_t, std::uint64_t, int, int>;
      std::map<std::vector<Texels>, const TileEvidence*> seen;
      for (const std::vector<const TileEvidence*>& island : islands) {
        const TileEvidence& tile = *island.front();
        std::vector<Texels> texels;
        for (const TileEvidence* piece : island)
          texels.emplace_back(piece->hash[0], piece->hash[1], piece->tile.box.width, piece->tile.box.height);
        const auto [first, fresh] = seen.try_emplace(texels, &tile);
        if (fresh) continue;
        Finding& finding = check.report(tile, FileRole::diffuse_alpha);
        finding.area_px = tile.counts.texels;
        finding.area_share = 1;
        finding.value = "equal to \"" + first->second->tile.name + "\"";
        finding.message = "the tile equals \"" + first->second->tile.name + "\"";
      }
    }};

}  // namespace etak
