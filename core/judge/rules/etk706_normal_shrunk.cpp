// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk706_normal_shrunk{
    .id = "ETK706",
    .slug = "normal-shrunk",
    .title = "Normals were averaged and not made unit again",
    .severity = {Severity::info, Severity::warning},
    .needs = {Need::maps},
    .source = "The mean of 2 x 2 normals whose neighbours lie d apart lacks d^2 / 32 per axis; Toksvig 2005",
    .what =
        "Texels are short in proportion to how much their neighbours differ, by a quarter of what shrinking by 2 does or more, and 0.1 % on the weighted average (0.75 % in maps of few colours); or, in noise "
        "as fine as the texels, 30 % of them are too short and hardly one too long. Found from a shrinking by 2 of maps whose neighbours then lie 10 degrees apart.",
    .why =
        "Programs that take z from x and y, as two-channel formats do, flatten the relief; others lose light where it is rough.",
    .example = "A texture scaled by an editor of pictures, or mips taken for level 0.",
    .fix = "Normalise after scaling; what was lost in length belongs into roughness.",
    .check = [](RuleCheck& check) {
      for_each_map(check, FileRole::normal, [&](const MapEvidence& map) {
        if (damage_of(map) != NormalDamage::shrunk) return;
        const double mean = map.shape.loss.y / static_cast<double>(map.shape.loss.count);
        Finding& finding = check.report(map);
        finding.value = "length " + number(1 - mean, 3);
        finding.limit = "length 1";
        finding.message =
            "normals are too short where neighbours differ (" + finding.value + " on the average)";
        finding.cause = "possible cause: the map was scaled down or blurred, or normals were blended";
      });
    }};

}  // namespace etak
