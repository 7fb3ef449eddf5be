// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk108_metal_has_diffuse{
    .id = "ETK108",
    .slug = "metal-has-diffuse",
    .title = "A metal with a diffuse colour",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::bytes_a, Need::bytes_b, Need::regions},
    .parameters = {{"warning_byte", 30, 30, "code", "largest diffuse channel that is let pass"},
                   {"error_byte", 50, 50, "code", "above which it is an error"}},
    .source = "Schueler 2009: diffuse of metals is black; Unity, \"pure metal\"",
    .what =
        "A plateau with F0 at or above the zone's upper end and a diffuse channel above sRGB code 30 (0.013); an error above code 50 (0.032). Metal-rough sets are not judged: there the metallic channel decides.",
    .why = "Free electrons absorb what is not reflected: no light comes back out of a metal to be diffuse.",
    .example = "A metal-rough base colour copied into the diffuse slot of a specular workflow.",
    .fix = "Paint diffuse black under metals.",
    .region = RegionKind::metal_with_diffuse,
    .check = [](RuleCheck& check) {
      for (const auto& [tile, plateaus] : check.regions(RegionKind::metal_with_diffuse)) {
        const Plateau& largest = plateaus.largest.front();
        const auto codes = check.bytes(largest.diffuse);
        const int most = *std::max_element(codes.begin(), codes.end());
        Finding& finding = check.report_diffuse(tile, plateaus);
        if (most > check.parameter("error_byte")) finding.severity = check.at_least(Severity::error);
        finding.limit = "code " + number(check.parameter("warning_byte"), 3);
        finding.message += " under metal of F0 " + check.colour(largest.specular);
      }
    }};

}  // namespace etak
