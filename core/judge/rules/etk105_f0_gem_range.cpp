// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk105_f0_gem_range{
    .id = "ETK105",
    .slug = "f0-gem-range",
    .title = "F0 as of gems",
    .severity = {Severity::info, Severity::warning},
    .needs = {Need::bytes_b, Need::regions},
    .parameters = {{"min_luminance", 0.0812, 0.0812, "", "F0 above which a plateau is reported"}},
    .source =
        "Hoffman: only gemstones and diamond-like materials; MoonRay calls an index above 1.788 invalid for its dielectric",
    .what =
        "A plateau with luminance between 0.0812 and the lower end of the forbidden zone (sRGB codes 81 to 124).",
    .why = "Few things other than gems, some oxides and paints with metal flakes reflect that much.",
    .example = "A specular map painted by eye, at a third of full range.",
    .fix = "Check the material; plastic, wood, stone and skin lie at codes 44 to 66.",
    .region = RegionKind::gem,
    .check = [](RuleCheck& check) {
      for (const auto& [tile, plateaus] : check.regions(RegionKind::gem)) {
        Finding& finding = check.report(tile, plateaus);
        finding.limit = number(check.parameter("min_luminance"), 3);
        if (!finding.nearest.empty()) finding.message += "; nearest " + finding.nearest.front().id;
      }
    }};

}  // namespace etak
