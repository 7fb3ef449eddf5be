// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

constexpr const char* black_fix =
    "Leave it black if it is glass (mark it transparent) or a metal (give it the F0 of that metal); brighten what is neither to code 30 or more.";

}  // namespace

constinit const Rule etk202_albedo_too_dark{
    .id = "ETK202",
    .slug = "albedo-too-dark",
    .title = "Albedo darker than natural surfaces",
    .severity = Severity::warning,
    .needs = {Need::bytes_a, Need::bytes_b, Need::regions},
    .parameters = {{"min_byte", 30, 50, "code", "smallest grey code that is let pass"}},
    .source =
        "Filament, Substance, Godot and DONTNOD charts; strict: 50. 7 to 20 % of measured materials lie outside of published ranges, so it is never an error",
    .what =
        "A plateau of dielectric surface with diffuse luminance below sRGB code 30 (strict: 50). Metals are not judged: their diffuse is black.",
    .why = "Charcoal reflects 2 to 4 %. Darker paint swallows bounced light and looks like a hole.",
    .example = "Black plastic painted at code 10.",
    .fix =
        "Brighten to code 30 or more, unless it was measured. Black (code 2 or less) may be glass, or a metal that lacks its F0: these stay black.",
    .region = RegionKind::albedo_dark,
    .check = [](RuleCheck& check) {
      for (const auto& [tile, plateaus] : check.regions(RegionKind::albedo_dark)) {
        Finding& finding = check.report_diffuse(tile, plateaus);
        finding.limit = "code " + number(check.parameter("min_byte"), 3);
        // Brightening makes glass milky and puts diffuse light on a metal that lacks its F0.
        if (check.tables.encode(luminance_of(plateaus.largest.front().diffuse)) <= 2) finding.fix = black_fix;
      }
    }};

}  // namespace etak
