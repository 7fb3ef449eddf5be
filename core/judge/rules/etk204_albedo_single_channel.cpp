// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk204_albedo_single_channel{
    .id = "ETK204",
    .slug = "albedo-single-channel",
    .title = "Albedo without one of the three colours",
    .severity = {Severity::info, Severity::warning},
    .needs = {Need::bytes_a, Need::regions},
    .source = "etak",
    .what = "A plateau with one diffuse channel above 0.2 and another exactly 0.",
    .why =
        "No pigment absorbs a third of the spectrum completely. Saturated paint comes close (blood, anodised aluminium), so it is information only.",
    .example = "Pure red, 255 0 0, from a colour picker.",
    .fix = "Lift the lowest channel a little.",
    .region = RegionKind::albedo_single,
    .check = [](RuleCheck& check) {
      for (const auto& [tile, plateaus] : check.regions(RegionKind::albedo_single)) {
        Finding& finding = check.report_diffuse(tile, plateaus);
        finding.limit = "no channel at 0";
      }
    }};

}  // namespace etak
