// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk712_occlusion_inverted{
    .id = "ETK712",
    .slug = "occlusion-inverted",
    .title = "An occlusion map is dark where it should be light",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::maps},
    .source = "glTF 2.0, 3.9.3: 1 is not occluded; most of a surface is open",
    .what =
        "Half of the texels or more have codes below 64, most of them below 32, and a fifth at most codes above 191: found for an inverted map of a surface half of which is open (its mean above 0.75).",
    .why = "Open surface gets no ambient light, and crevices shine.",
    .example = "A cavity or dirt mask exported as occlusion.",
    .fix = "Invert the map.",
    .check = [](RuleCheck& check) {
      for_each_map(check, FileRole::occlusion, [&](const MapEvidence& map) {
        const GreyFacts& grey = map.grey;
        if (grey.texels == 0 || grey.codes[0] == grey.texels) return;
        const std::uint64_t dark = grey.between(0, 63), light = grey.between(192, 255);
        if (2 * dark < grey.texels || 5 * light > grey.texels || 4 * light > dark) return;
        // A map of a dark place is dark in steps; an inverted one has a peak at black.
        if (grey.between(0, 31) < grey.between(32, 63)) return;
        Finding& finding = check.report(map);
        finding.area_share = static_cast<double>(dark) / static_cast<double>(grey.texels);
        finding.value = percent(finding.area_share) + " below code 64";
        finding.limit = "50 %";
        finding.message = finding.value + " and " +
                          percent(static_cast<double>(light) / static_cast<double>(grey.texels)) +
                          " above 191: open surface seems to be black";
      });
    }};

}  // namespace etak
