// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

constexpr RuleParameter etk108_parameters[] = {
    {"warning_byte", 30, 30, "code", "largest diffuse channel that is let pass"},
    {"error_byte", 50, 50, "code", "above which it is an error"},
};

void etk108(RuleCheck& check) {
  for_each_region(check, RegionKind::metal_with_diffuse,
                  [&](const TileEvidence& tile, const PlateauSummary& plateaus) {
                    const Plateau& largest = plateaus.largest.front();
                    const auto codes = check.bytes(largest.diffuse);
                    const int most = *std::max_element(codes.begin(), codes.end());
                    Finding& finding = check.report(tile, plateaus, largest, true);
                    if (most > check.parameter("error_byte"))
                      finding.severity = check.at_least(Severity::error);
                    finding.limit = "code " + number(check.parameter("warning_byte"), 3);
                    finding.message += " under metal of F0 " + check.colour(largest.specular);
                  });
}

}  // namespace

constinit const Rule etk108_metal_has_diffuse{
    "ETK108",
    "metal-has-diffuse",
    "A metal with a diffuse colour",
    Severity::warning,
    Severity::error,
    {Need::bytes_a, Need::bytes_b, Need::regions},
    etk108_parameters,
    "Schueler 2009: diffuse of metals is black; Unity, \"pure metal\"",
    "A plateau with F0 at or above the zone's upper end and a diffuse channel above sRGB "
    "code 30 (0.013); an error above code 50 (0.032). Metal-rough sets are not judged: there "
    "the metallic channel decides.",
    "Free electrons absorb what is not reflected: no light comes back out of a metal to be "
    "diffuse.",
    "A metal-rough base colour copied into the diffuse slot of a specular workflow.",
    "Paint diffuse black under metals.",
    &etk108,
    RegionKind::metal_with_diffuse};

}  // namespace etak
