// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk109_dielectric_black_diffuse{
    .id = "ETK109",
    .slug = "dielectric-black-diffuse",
    .title = "A dielectric without any diffuse colour",
    .severity = Severity::info,
    .needs = {Need::bytes_a, Need::bytes_b, Need::regions},
    .source = "etak",
    .what =
        "A plateau of dielectric F0 whose diffuse has no channel above code 2, in a file that is not marked transparent.",
    .why = "It may be glass or soot, but it is also what a metal looks like whose F0 was forgotten.",
    .example = "Metal mask applied to diffuse but not to specular.",
    .fix = "Give the metal its F0, or mark the material transparent.",
    .region = RegionKind::black_diffuse,
    .check = [](RuleCheck& check) {
      if (check.target.manifest.transparent || check.settings.alpha_is_transparency) return;
      for (const auto& [tile, plateaus] : check.regions(RegionKind::black_diffuse)) {
        Finding& finding = check.report(tile, plateaus);
        finding.limit = "diffuse above code 2";
        finding.message += " with black diffuse: glass, or a metal without its F0";
      }
    }};

}  // namespace etak
