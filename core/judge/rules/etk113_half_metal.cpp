// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk113_half_metal{
    .id = "ETK113",
    .slug = "half-metal",
    .title = "Neither metal nor dielectric",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::metal_rough, Need::regions},
    .source = "Khronos glTF 2.0 and Filament: metallic is close to 0 or 1",
    .what = "Metal-rough sets: a plateau with metallic between 0.1 and 0.9.",
    .why =
        "A surface is metal or it is not; the values between are there for filtered edges only and give F0 of the forbidden zone.",
    .example = "Metallic painted at 0.5 for 'semi-metallic' paint.",
    .fix = "Set metallic to 0 or 1; for rust and dirt use a sharp mask.",
    .region = RegionKind::half_metal,
    .check = [](RuleCheck& check) {
      for (const auto& [tile, plateaus] : check.regions(RegionKind::half_metal)) {
        const Plateau& largest = plateaus.largest.front();
        Finding& finding = check.report(tile, plateaus);
        finding.file = check.file_of(FileRole::metal_rough);
        finding.nearest.clear();  // a metallic value is no F0
        finding.value = "metallic " + number(largest.metallic, 2);
        finding.limit = "below 0.1 or above 0.9";
        finding.message = finding.value + " on " + area_text(plateaus.area, tile.counts.texels);
      }
    }};

}  // namespace etak
