// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk707_normal_flat_split{
    .id = "ETK707",
    .slug = "normal-flat-split",
    .title = "Flat areas alternate between codes 127 and 128",
    .severity = {Severity::info, Severity::warning},
    .needs = {Need::maps},
    .source = "A code stands for 2 c / 255 - 1: 0 lies between 127 and 128, which are 0.45 degrees apart",
    .what =
        "A tenth of the map or more has the flattest codes, and on one axis a hundredth of these or more has code 127 and as much code 128; fewer than half as many texels are a code further from flat, as a gentle relief has them.",
    .why = "The step shows as an edge in mirrors and polished metal.",
    .example = "Tiles baked by two programs, one of which rounds 127.5 down.",
    .fix = "Use 128 (or 127) for flat in all of the map.",
    .check = [](RuleCheck& check) {
      for_each_map(check, FileRole::normal, [&](const MapEvidence& map) {
        if (!is_flat_in_two_codes(map.normals)) return;
        const double share = static_cast<double>(map.normals.flat) / static_cast<double>(map.normals.texels);
        Finding& finding = check.report(map);
        finding.area_px = map.normals.flat;
        finding.area_share = share;
        finding.value = "127 and 128";
        finding.limit = "one of them";
        finding.message =
            "flat areas, " + percent(share) + " of the map, are code 127 in some places and 128 in others";
      });
    }};

}  // namespace etak
