// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk111_f0_not_in_database{
    .id = "ETK111",
    .slug = "f0-not-in-database",
    .title = "F0 is that of no known material",
    .severity = {Severity::off, Severity::info},
    .needs = {Need::bytes_b, Need::regions},
    .parameters = {{"distance", 6, 6, "codes", "largest channel difference that counts as known"}},
    .source = "The material library of etak",
    .what =
        "A plateau further than 6 codes from every dataset of the library; the three nearest are named. Off by default.",
    .why = "A measured value is a better start than a painted one.",
    .example = "An F0 found by eye.",
    .fix = "Take the F0 of one of the nearest materials.",
    .region = RegionKind::any_f0,
    .check = [](RuleCheck& check) {
      for (const TileEvidence& tile : check.evidence.tiles) {
        const PlateauSummary* plateaus = tile.region(RegionKind::any_f0);
        if (plateaus == nullptr) continue;
        std::size_t area = 0;
        const Plateau* shown = nullptr;
        for (const Plateau& plateau : plateaus->largest) {
          const auto nearest = nearest_materials(known_materials(check.settings), plateau.specular,
                                                 check.settings.transfer, 1);
          if (nearest.empty() || nearest.front().bytes <= check.parameter("distance")) continue;
          area += plateau.area;
          if (shown == nullptr) shown = &plateau;
        }
        if (shown == nullptr) continue;
        Finding& finding = check.report(tile, *plateaus, *shown);
        finding.box = shown->box;
        finding.area_px = area;
        finding.limit = number(check.parameter("distance"), 3) + " codes";
        finding.message = finding.value + " on " + area_text(area, tile.counts.texels) + "; nearest";
        for (const NearestMaterial& n : finding.nearest)
          finding.message += " " + n.id + " (" + number(n.bytes, 3) + ")";
      }
    }};

}  // namespace etak
