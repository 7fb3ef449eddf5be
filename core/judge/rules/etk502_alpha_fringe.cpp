// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk502_alpha_fringe{
    .id = "ETK502",
    .slug = "alpha-fringe",
    .title = "Hidden texels beside visible ones have another colour",
    .severity = Severity::warning,
    .needs = {Need::bytes_a},
    .source = "Bilinear filtering and mips read hidden texels",
    .what =
        "A texel of alpha 0 within 2 texels of a visible one differs from the nearest visible one by more than 16 codes.",
    .why = "Filtering mixes the hidden colour into the edge: a dark or white halo.",
    .example = "A leaf on black: the colour under alpha 0 is black.",
    .fix = "Let the colour bleed outwards under alpha 0.",
    .check = [](RuleCheck& check) {
      if (!check.has_alpha()) return;
      for (const TileEvidence& tile : check.evidence.tiles) {
        if (tile.fringe == 0) continue;
        Finding& finding = check.report(tile, FileRole::diffuse_alpha);
        finding.box = PixelBox{tile.fringe_place[0], tile.fringe_place[1], 1, 1};
        finding.area_px = tile.fringe;
        finding.area_share = static_cast<double>(tile.fringe) / static_cast<double>(tile.counts.texels);
        finding.value = std::to_string(tile.fringe_worst) + " codes";
        finding.limit = "16 codes";
        finding.message = "hidden texels beside visible ones differ by up to " + finding.value + " on " +
                          area_text(tile.fringe, tile.counts.texels);
      }
    }};

}  // namespace etak
