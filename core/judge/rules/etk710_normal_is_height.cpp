// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk710_normal_is_height{
    .id = "ETK710",
    .slug = "normal-is-height",
    .title = "A height map stands in the place of normals",
    .severity = Severity::error,
    .needs = {Need::maps},
    .source = "etak",
    .what = "99 % of the texels are grey: their three codes lie within 2 of each other.",
    .why = "Read as normals, all of it leans to one side.",
    .example = "A bump map in the slot of normals.",
    .fix = "Make normals of the heights, or name it height.",
    .check = [](RuleCheck& check) {
      for_each_map(check, FileRole::normal, [&](const MapEvidence& map) {
        if (damage_of(map) != NormalDamage::height) return;
        Finding& finding = check.report(map);
        finding.value = "grey";
        finding.limit = "red and green about x and y, blue about z";
        finding.message =
            percent(static_cast<double>(map.shape.grey) / static_cast<double>(map.normals.texels)) +
            " of the texels are grey: this is a height (bump) map, or none of normals";
      });
    }};

}  // namespace etak
