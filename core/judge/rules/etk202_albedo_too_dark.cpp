// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

constexpr RuleParameter etk202_parameters[] = {
    {"min_byte", 30, 50, "code", "smallest grey code that is let pass"},
};

constexpr const char* black_fix =
    "Leave it black if it is glass (mark it transparent) or a metal (give it the F0 of that metal); brighten "
    "what is neither to code 30 or more.";

void etk202(RuleCheck& check) {
  for_each_region(check, RegionKind::albedo_dark,
                  [&](const TileEvidence& tile, const PlateauSummary& plateaus) {
                    Finding& finding = check.report(tile, plateaus, plateaus.largest.front(), true);
                    finding.limit = "code " + number(check.parameter("min_byte"), 3);
                    // Brightening makes glass milky and puts diffuse light on a metal that lacks its F0.
                    if (check.tables.encode(luminance_of(plateaus.largest.front().diffuse)) <= 2)
                      finding.fix = black_fix;
                  });
}

}  // namespace

constinit const Rule etk202_albedo_too_dark{
    "ETK202",
    "albedo-too-dark",
    "Albedo darker than natural surfaces",
    Severity::warning,
    Severity::warning,
    {Need::bytes_a, Need::bytes_b, Need::regions},
    etk202_parameters,
    "Filament, Substance, Godot and DONTNOD charts; strict: 50. 7 to 20 % of measured "
    "materials lie outside of published ranges, so it is never an error",
    "A plateau of dielectric surface with diffuse luminance below sRGB code 30 (strict: 50). "
    "Metals are not judged: their diffuse is black.",
    "Charcoal reflects 2 to 4 %. Darker paint swallows bounced light and looks like a hole.",
    "Black plastic painted at code 10.",
    "Brighten to code 30 or more, unless it was measured. Black (code 2 or less) may be glass, or a "
    "metal that lacks its F0: these stay black.",
    &etk202,
    RegionKind::albedo_dark};

}  // namespace etak
