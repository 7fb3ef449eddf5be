// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

void etk109(RuleCheck& check) {
  if (check.target.manifest.transparent || check.settings.alpha_is_transparency) return;
  for_each_region(check, RegionKind::black_diffuse,
                  [&](const TileEvidence& tile, const PlateauSummary& plateaus) {
                    Finding& finding = check.report(tile, plateaus, plateaus.largest.front(), false);
                    finding.limit = "diffuse above code 2";
                    finding.message += " with black diffuse: glass, or a metal without its F0";
                  });
}

}  // namespace

constinit const Rule etk109_dielectric_black_diffuse{
    "ETK109",
    "dielectric-black-diffuse",
    "A dielectric without any diffuse colour",
    Severity::info,
    Severity::info,
    {Need::bytes_a, Need::bytes_b, Need::regions},
    {},
    "etak",
    "A plateau of dielectric F0 whose diffuse has no channel above code 2, in a file that is "
    "not marked transparent.",
    "It may be glass or soot, but it is also what a metal looks like whose F0 was forgotten.",
    "Metal mask applied to diffuse but not to specular.",
    "Give the metal its F0, or mark the material transparent.",
    &etk109,
    RegionKind::black_diffuse};

}  // namespace etak
