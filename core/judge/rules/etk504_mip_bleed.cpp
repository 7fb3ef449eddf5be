// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk504_mip_bleed{
    .id = "ETK504",
    .slug = "mip-bleed",
    .title = "Neighbouring tiles mix in the mip levels",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::bytes_a, Need::bytes_b, Need::layout},
    .parameters = {{"mips", 4, 4, "levels", "that must be clean where the layout does not say"},
                   {"difference", 2, 2, "/255", "largest linear difference"}},
    .source =
        "Tiles with gutter g stay clean up to level log2(g) + 1, and power-of-two aligned ones to their alignment; then they jump by up to 0.455 at once (etak)",
    .what =
        "Atlas: in a box mip chain of the page some texel whose centre lies in the tile differs by more than 2/255 (linear) from that of the tile with its edge repeated, up to level 4 or the one the layout promises.",
    .why =
        "The neighbour shines through at a distance; a metal beside a dielectric bleeds straight into the forbidden zone.",
    .example = "Tiles packed edge to edge at odd positions.",
    .fix = "Align tiles to 2^level, or give them a gutter of 2^(level - 1) texels.",
    .check = [](RuleCheck& check) {
      if (check.target.manifest.tiles.empty()) return;
      for (const TileEvidence& tile : check.evidence.tiles)
        for (std::size_t level = 0; level < tile.mip_bleed.size(); ++level) {
          if (255 * tile.mip_bleed[level] <= check.parameter("difference")) continue;
          Finding& finding = check.report(tile, FileRole::specular_gloss);
          finding.value = number(255 * tile.mip_bleed[level], 3) + "/255";
          finding.limit = number(check.parameter("difference"), 3) + "/255";
          finding.message = "at mip level " + std::to_string(level + 1) + " the tile differs by " +
                            finding.value + " from its own mips";
          break;
        }
    }};

}  // namespace etak
