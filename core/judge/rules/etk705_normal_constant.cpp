// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk705_normal_constant{
    .id = "ETK705",
    .slug = "normal-constant",
    .title = "A normal map is constant",
    .severity = {Severity::info, Severity::warning},
    .needs = {Need::maps},
    .source = "etak",
    .what = "Every texel has the same three codes.",
    .why = "The texture costs memory and bandwidth and shows nothing.",
    .example = "A slot filled by the default of an exporter.",
    .fix = "Leave the normal map out.",
    .check = [](RuleCheck& check) {
      for_each_map(check, FileRole::normal, [&](const MapEvidence& map) {
        if (!is_constant(map.normals)) return;
        const auto& codes = map.normals.least;
        Finding& finding = check.report(map);
        finding.byte = std::array<int, 3>{codes[0], codes[1], codes[2]};
        finding.value =
            std::to_string(codes[0]) + ' ' + std::to_string(codes[1]) + ' ' + std::to_string(codes[2]);
        finding.message = "every texel that was looked at is " + finding.value;
      });
    }};

}  // namespace etak
