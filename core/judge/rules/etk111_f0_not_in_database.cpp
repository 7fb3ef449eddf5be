// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

constexpr RuleParameter etk111_parameters[] = {
    {"distance", 6, 6, "codes", "largest channel difference that counts as known"},
};

void etk111(RuleCheck& check) {
  for (const TileEvidence& tile : check.evidence.tiles) {
    const PlateauSummary* plateaus = tile.region(RegionKind::any_f0);
    if (plateaus == nullptr) continue;
    std::size_t area = 0;
    const Plateau* shown = nullptr;
    for (const Plateau& plateau : plateaus->largest) {
      const auto nearest =
          nearest_materials(known_materials(check.settings), plateau.specular, check.settings.transfer, 1);
      if (nearest.empty() || nearest.front().bytes <= check.parameter("distance")) continue;
      area += plateau.area;
      if (shown == nullptr) shown = &plateau;
    }
    if (shown == nullptr) continue;
    Finding& finding = check.report(tile, *plateaus, *shown, false);
    finding.box = shown->box;
    finding.area_px = area;
    finding.limit = number(check.parameter("distance"), 3) + " codes";
    finding.message = finding.value + " on " + area_text(area, tile.counts.texels) + "; nearest";
    for (const NearestMaterial& n : finding.nearest)
      finding.message += " " + n.id + " (" + number(n.bytes, 3) + ")";
  }
}

}  // namespace

constinit const Rule etk111_f0_not_in_database{
    "ETK111",
    "f0-not-in-database",
    "F0 is that of no known material",
    Severity::off,
    Severity::info,
    {Need::bytes_b, Need::regions},
    etk111_parameters,
    "The material library of etak",
    "A plateau further than 6 codes from every dataset of the library; the three nearest are "
    "named. Off by default.",
    "A measured value is a better start than a painted one.",
    "An F0 found by eye.",
    "Take the F0 of one of the nearest materials.",
    &etk111,
    RegionKind::any_f0};

}  // namespace etak
