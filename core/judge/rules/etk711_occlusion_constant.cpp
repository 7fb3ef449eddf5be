// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk711_occlusion_constant{
    .id = "ETK711",
    .slug = "occlusion-constant",
    .title = "An occlusion map is constant",
    .severity = {Severity::info, Severity::warning},
    .needs = {Need::maps},
    .source = "etak",
    .what =
        "Every texel of an occlusion map, or of the channel that the name of a packed picture gives to occlusion, has one code; a warning where it is not white. White in a packed picture is no finding: the channel is there anyway.",
    .why = "White costs memory and does nothing; anything darker dims all ambient light on the surface.",
    .example = "A slot filled by the default of an exporter.",
    .fix = "Leave the occlusion map out.",
    .check = [](RuleCheck& check) {
      for_each_map(check, FileRole::occlusion, [&](const MapEvidence& map) {
        const auto& codes = map.grey.codes;
        const auto found = std::ranges::find(codes, map.grey.texels);
        if (found == codes.end() || map.grey.texels == 0) return;
        const auto code = static_cast<int>(found - codes.begin());
        if (map.packed && code == 255) return;  // costs nothing beside roughness
        Finding& finding = check.report(map);
        // Constant white is for nothing; anything else darkens the whole surface.
        if (code < 255) finding.severity = check.at_least(Severity::warning);
        finding.value = "code " + std::to_string(code);
        finding.limit = "a map that varies, or none";
        finding.message = "every texel that was looked at is " + finding.value;
      });
    }};

}  // namespace etak
