// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk203_albedo_too_bright{
    .id = "ETK203",
    .slug = "albedo-too-bright",
    .title = "Albedo brighter than natural surfaces",
    .severity = Severity::warning,
    .needs = {Need::bytes_a, Need::regions},
    .parameters = {{"max_byte", 250, 240, "code", "largest grey code that is let pass"}},
    .source = "The charts of ETK202; strict: 240. Fresh snow is 0.85 to 0.95 in Unity's presets",
    .what = "A plateau with diffuse luminance above sRGB code 250 (strict: 240).",
    .why =
        "Nothing but reference tiles of pressed powder is whiter than snow; light then bounces almost without loss.",
    .example = "Paper painted at pure white.",
    .fix = "Darken to code 240 or less.",
    .region = RegionKind::albedo_bright,
    .check = [](RuleCheck& check) {
      for (const auto& [tile, plateaus] : check.regions(RegionKind::albedo_bright)) {
        Finding& finding = check.report_diffuse(tile, plateaus);
        finding.limit = "code " + number(check.parameter("max_byte"), 3);
      }
    }};

}  // namespace etak
