// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

constexpr RuleParameter etk103_parameters[] = {
    {"max_luminance", least_dielectric_f0, least_dielectric_f0, "", "F0 below which a plateau is reported"},
};

void etk103(RuleCheck& check) {
  for_each_region(check, RegionKind::f0_low, [&](const TileEvidence& tile, const PlateauSummary& plateaus) {
    Finding& finding = check.report(tile, plateaus, plateaus.largest.front(), false);
    finding.limit = number(check.parameter("max_luminance"), 3);
    const Explanation why = explain_f0(known_materials(check.settings), plateaus.largest.front().specular,
                                       check.settings.transfer);
    if (why.cause == Explanation::Cause::missing) {
      finding.cause = "matches a dielectric of F0 " + number(why.original, 2) + " stored linear, within " +
                      number(why.distance, 2) + " codes";
      finding.message += "; " + finding.cause;
    }
  });
}

}  // namespace

constinit const Rule etk103_f0_too_low{
    "ETK103",
    "f0-too-low",
    "F0 below that of any solid or liquid",
    Severity::warning,
    Severity::error,
    {Need::bytes_b, Need::regions},
    etk103_parameters,
    "Lowest entries of the library: index 1.30 to 1.333, F0 0.017 to 0.020; Unreal and "
    "Frostbite take less than 2 % for shadowing; Schueler: min(60 Ks, 1)",
    "A plateau of F0 with luminance above 0 but below 0.017 (sRGB code 36).",
    "No solid or liquid reflects less than ice and water do. Lower values stand for "
    "occlusion painted into the specular map, or for linear codes.",
    "Cavities painted dark in the specular map; F0 0.04 stored as linear code 10, which "
    "reads as 0.003.",
    "Use an occlusion map for cavities; store F0 with the sRGB curve.",
    &etk103,
    RegionKind::f0_low};

}  // namespace etak
