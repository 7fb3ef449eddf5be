// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk102_f0_transition{
    .id = "ETK102",
    .slug = "f0-transition",
    .title = "Texels in the forbidden zone that belong to no plateau",
    .severity = Severity::info,
    .needs = {Need::bytes_b, Need::regions},
    .parameters = {{"warn_share", 10, 10, "%", "share of the tile above which it is a warning"}},
    .source =
        "etak: filtered edges between metal and dielectric fill 0.5 to 30 % of a tile, by their softness",
    .what =
        "Texels in the zone that are filtered edges, soft masks or features thinner than 5 texels, summed up, and solid patches with hard edges that are too small for ETK101 (7 or 8 texels a side), of "
        "which the largest is shown. A warning above 10 % of the tile.",
    .why =
        "Edges pass through the zone; that is not a mistake. Wide soft masks are: they show as a seam of a material that does not exist.",
    .example = "A metal mask blurred with a large brush.",
    .fix = "Use a sharper metal mask, or more texels; give a patch the F0 of its material.",
    .region = RegionKind::zone,
    .check = [](RuleCheck& check) {
      for (const TileEvidence& tile : check.evidence.tiles) {
        const PlateauSummary* zone = tile.region(RegionKind::zone);
        if (zone == nullptr || zone->masked <= zone->area) continue;
        const std::size_t count = zone->masked - zone->area;
        const double share = static_cast<double>(count) / static_cast<double>(tile.counts.texels);
        Finding& finding = check.report(tile, FileRole::specular_gloss);
        if (100 * share > check.parameter("warn_share")) finding.severity = check.at_least(Severity::warning);
        finding.area_px = count;
        finding.area_share = share;
        finding.value = percent(share);
        finding.limit = number(check.parameter("warn_share"), 3) + " %";
        finding.box = zone->masked_box;
        if (zone->patches == 0) {
          finding.message =
              "edges and thin features inside the forbidden zone on " + area_text(count, tile.counts.texels);
          continue;
        }
        const Plateau& patch = zone->largest_patch;
        finding.box = patch.box;
        finding.linear = patch.specular;
        finding.byte = check.bytes(patch.specular);
        finding.luminance = luminance_of(patch.specular);
        finding.message = "a solid patch of F0 " + check.colour(patch.specular) + ", " +
                          std::to_string(patch.box.width) + " x " + std::to_string(patch.box.height) +
                          " px with hard edges";
        if (zone->patches > 1) finding.message += ", the largest of " + in_thousands(zone->patches);
        finding.message += ", too small for ETK101";
        if (count > zone->patch_area)
          finding.message +=
              "; edges and thin features on " + area_text(count - zone->patch_area, tile.counts.texels);
      }
    }};

}  // namespace etak
