// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk103_f0_too_low{
    .id = "ETK103",
    .slug = "f0-too-low",
    .title = "F0 below that of any solid or liquid",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::bytes_b, Need::regions},
    .parameters = {{"max_luminance", least_dielectric_f0, least_dielectric_f0, "",
                    "F0 below which a plateau is reported"}},
    .source =
        "Lowest entries of the library: index 1.30 to 1.333, F0 0.017 to 0.020; Unreal and Frostbite take less than 2 % for shadowing; Schueler: min(60 Ks, 1)",
    .what = "A plateau of F0 with luminance above 0 but below 0.017 (sRGB code 36).",
    .why =
        "No solid or liquid reflects less than ice and water do. Lower values stand for occlusion painted into the specular map, or for linear codes.",
    .example =
        "Cavities painted dark in the specular map; F0 0.04 stored as linear code 10, which reads as 0.003.",
    .fix = "Use an occlusion map for cavities; store F0 with the sRGB curve.",
    .region = RegionKind::f0_low,
    .check = [](RuleCheck& check) {
      for (const auto& [tile, plateaus] : check.regions(RegionKind::f0_low)) {
        Finding& finding = check.report(tile, plateaus);
        finding.limit = number(check.parameter("max_luminance"), 3);
        const Explanation why = explain_f0(known_materials(check.settings), plateaus.largest.front().specular,
                                           check.settings.transfer);
        if (why.cause == Explanation::Cause::missing) {
          finding.cause = "matches a dielectric of F0 " + number(why.original, 2) +
                          " stored linear, within " + number(why.distance, 2) + " codes";
          finding.message += "; " + finding.cause;
        }
      }
    }};

}  // namespace etak
