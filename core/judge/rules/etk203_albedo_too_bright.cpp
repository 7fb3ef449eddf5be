// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

constexpr RuleParameter etk203_parameters[] = {
    {"max_byte", 250, 240, "code", "largest grey code that is let pass"},
};

void etk203(RuleCheck& check) {
  for_each_region(check, RegionKind::albedo_bright,
                  [&](const TileEvidence& tile, const PlateauSummary& plateaus) {
                    Finding& finding = check.report(tile, plateaus, plateaus.largest.front(), true);
                    finding.limit = "code " + number(check.parameter("max_byte"), 3);
                  });
}

}  // namespace

constinit const Rule etk203_albedo_too_bright{
    "ETK203",
    "albedo-too-bright",
    "Albedo brighter than natural surfaces",
    Severity::warning,
    Severity::warning,
    {Need::bytes_a, Need::regions},
    etk203_parameters,
    "The charts of ETK202; strict: 240. Fresh snow is 0.85 to 0.95 in Unity's presets",
    "A plateau with diffuse luminance above sRGB code 250 (strict: 240).",
    "Nothing but reference tiles of pressed powder is whiter than snow; light then bounces "
    "almost without loss.",
    "Paper painted at pure white.",
    "Darken to code 240 or less.",
    &etk203,
    RegionKind::albedo_bright};

}  // namespace etak
