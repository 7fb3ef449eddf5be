// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

void etk113(RuleCheck& check) {
  for_each_region(check, RegionKind::half_metal,
                  [&](const TileEvidence& tile, const PlateauSummary& plateaus) {
                    const Plateau& largest = plateaus.largest.front();
                    Finding& finding = check.report(tile, plateaus, largest, false);
                    finding.file = check.file_of(FileRole::metal_rough);
                    finding.nearest.clear();  // a metallic value is no F0
                    finding.value = "metallic " + number(largest.metallic, 2);
                    finding.limit = "below 0.1 or above 0.9";
                    finding.message = finding.value + " on " + area_text(plateaus.area, tile.counts.texels);
                  });
}

}  // namespace

constinit const Rule etk113_half_metal{
    "ETK113",
    "half-metal",
    "Neither metal nor dielectric",
    Severity::warning,
    Severity::error,
    {Need::metal_rough, Need::regions},
    {},
    "Khronos glTF 2.0 and Filament: metallic is close to 0 or 1",
    "Metal-rough sets: a plateau with metallic between 0.1 and 0.9.",
    "A surface is metal or it is not; the values between are there for filtered edges only "
    "and give F0 of the forbidden zone.",
    "Metallic painted at 0.5 for 'semi-metallic' paint.",
    "Set metallic to 0 or 1; for rust and dirt use a sharp mask.",
    &etk113,
    RegionKind::half_metal};

}  // namespace etak
