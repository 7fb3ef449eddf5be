// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

void etk705(RuleCheck& check) {
  for_each_map(check, FileRole::normal, [&](const MapEvidence& map) {
    if (!is_constant(map.normals)) return;
    const auto& codes = map.normals.least;
    Finding& finding = check.report(map);
    finding.byte = std::array<int, 3>{codes[0], codes[1], codes[2]};
    finding.value =
        std::to_string(codes[0]) + ' ' + std::to_string(codes[1]) + ' ' + std::to_string(codes[2]);
    finding.message = "every texel that was looked at is " + finding.value;
  });
}

}  // namespace

constinit const Rule etk705_normal_constant{"ETK705",
                                            "normal-constant",
                                            "A normal map is constant",
                                            Severity::info,
                                            Severity::warning,
                                            {Need::maps},
                                            {},
                                            "etak",
                                            "Every texel has the same three codes.",
                                            "The texture costs memory and bandwidth and shows nothing.",
                                            "A slot filled by the default of an exporter.",
                                            "Leave the normal map out.",
                                            &etk705};

}  // namespace etak
