// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

void etk204(RuleCheck& check) {
  for_each_region(check, RegionKind::albedo_single,
                  [&](const TileEvidence& tile, const PlateauSummary& plateaus) {
                    Finding& finding = check.report(tile, plateaus, plateaus.largest.front(), true);
                    finding.limit = "no channel at 0";
                  });
}

}  // namespace

constinit const Rule etk204_albedo_single_channel{
    "ETK204",
    "albedo-single-channel",
    "Albedo without one of the three colours",
    Severity::info,
    Severity::warning,
    {Need::bytes_a, Need::regions},
    {},
    "etak",
    "A plateau with one diffuse channel above 0.2 and another exactly 0.",
    "No pigment absorbs a third of the spectrum completely. Saturated paint comes close "
    "(blood, anodised aluminium), so it is information only.",
    "Pure red, 255 0 0, from a colour picker.",
    "Lift the lowest channel a little.",
    &etk204,
    RegionKind::albedo_single};

}  // namespace etak
