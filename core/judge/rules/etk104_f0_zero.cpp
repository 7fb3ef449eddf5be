// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

void etk104(RuleCheck& check) {
  for_each_region(check, RegionKind::f0_zero, [&](const TileEvidence& tile, const PlateauSummary& plateaus) {
    Finding& finding = check.report(tile, plateaus, plateaus.largest.front(), false);
    finding.limit = "above code 1";
  });
}

}  // namespace

constinit const Rule etk104_f0_zero{
    "ETK104",
    "f0-zero",
    "F0 is zero",
    Severity::warning,
    Severity::error,
    {Need::bytes_b, Need::regions},
    {},
    "Fresnel: every boundary between two media reflects",
    "An opaque plateau where no channel of F0 exceeds code 1.",
    "Everything reflects. Most often the texture is missing or was never painted.",
    "A black placeholder left in the specular slot.",
    "Give dielectrics F0 0.04 (sRGB code 56) unless you know better.",
    &etk104,
    RegionKind::f0_zero};

}  // namespace etak
