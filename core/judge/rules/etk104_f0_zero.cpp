// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk104_f0_zero{
    .id = "ETK104",
    .slug = "f0-zero",
    .title = "F0 is zero",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::bytes_b, Need::regions},
    .source = "Fresnel: every boundary between two media reflects",
    .what = "An opaque plateau where no channel of F0 exceeds code 1.",
    .why = "Everything reflects. Most often the texture is missing or was never painted.",
    .example = "A black placeholder left in the specular slot.",
    .fix = "Give dielectrics F0 0.04 (sRGB code 56) unless you know better.",
    .region = RegionKind::f0_zero,
    .check = [](RuleCheck& check) {
      for (const auto& [tile, plateaus] : check.regions(RegionKind::f0_zero)) {
        Finding& finding = check.report(tile, plateaus);
        finding.limit = "above code 1";
      }
    }};

}  // namespace etak
