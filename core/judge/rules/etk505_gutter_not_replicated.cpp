// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk505_gutter_not_replicated{
    .id = "ETK505",
    .slug = "gutter-not-replicated",
    .title = "The gutter does not repeat the tile's edge",
    .severity = Severity::warning,
    .needs = {Need::bytes_a, Need::bytes_b, Need::layout},
    .source = "etak",
    .what = "Atlas: a gutter texel differs by more than 2 codes from the nearest texel of its tile.",
    .why = "Filtering reads the gutter at the tile's edge.",
    .example = "A gutter filled with black.",
    .fix = "Pack again with a replicated gutter.",
    .check = [](RuleCheck& check) {
      for (const TileEvidence& tile : check.evidence.tiles) {
        if (tile.gutter_wrong == 0) continue;
        Finding& finding = check.report(tile, FileRole::diffuse_alpha);
        finding.box = PixelBox{tile.gutter_place[0], tile.gutter_place[1], 1, 1};
        finding.area_px = tile.gutter_wrong;
        finding.value = std::to_string(tile.gutter_worst) + " codes";
        finding.limit = "2 codes";
        finding.message = in_thousands(tile.gutter_wrong) +
                          " gutter texels differ from the tile's edge, by up to " + finding.value;
      }
    }};

}  // namespace etak
