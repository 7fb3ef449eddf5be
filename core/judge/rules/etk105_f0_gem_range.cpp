// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

constexpr RuleParameter etk105_parameters[] = {
    {"min_luminance", 0.0812, 0.0812, "", "F0 above which a plateau is reported"},
};

void etk105(RuleCheck& check) {
  for_each_region(check, RegionKind::gem, [&](const TileEvidence& tile, const PlateauSummary& plateaus) {
    Finding& finding = check.report(tile, plateaus, plateaus.largest.front(), false);
    finding.limit = number(check.parameter("min_luminance"), 3);
    if (!finding.nearest.empty()) finding.message += "; nearest " + finding.nearest.front().id;
  });
}

}  // namespace

constinit const Rule etk105_f0_gem_range{
    "ETK105",
    "f0-gem-range",
    "F0 as of gems",
    Severity::info,
    Severity::warning,
    {Need::bytes_b, Need::regions},
    etk105_parameters,
    "Hoffman: only gemstones and diamond-like materials; MoonRay calls an index above 1.788 "
    "invalid for its dielectric",
    "A plateau with luminance between 0.0812 and the lower end of the forbidden zone (sRGB "
    "codes 81 to 124).",
    "Few things other than gems, some oxides and paints with metal flakes reflect that much.",
    "A specular map painted by eye, at a third of full range.",
    "Check the material; plastic, wood, stone and skin lie at codes 44 to 66.",
    &etk105,
    RegionKind::gem};

}  // namespace etak
