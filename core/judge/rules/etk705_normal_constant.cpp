// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"
#include "core/math/functions.h"

namespace etak {

namespace {
constexpr double most_lean = 2;  // degrees
}

constinit const Rule etk705_normal_constant{
    .id = "ETK705",
    .slug = "normal-constant",
    .title = "A normal map is constant",
    .severity = {Severity::info, Severity::warning},
    .needs = {Need::maps},
    .source = "etak",
    .what =
        "Every texel has the same three codes. A warning where the one normal leans by more than 2 degrees or has another length than 1.",
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
        const double x = map.normals.mean(0), y = map.normals.mean(1), z = map.normals.mean(2);
        const double lean = math::atan2(math::hypot(x, y), z) * 180 / std::numbers::pi,
                     length = std::sqrt(x * x + y * y + z * z);
        const bool leans = lean > most_lean, has_length = std::abs(length - 1) > normal_tolerance;
        if (!leans && !has_length) return;
        finding.severity = check.at_least(Severity::warning);
        if (has_length) finding.message += ", of length " + number(length, 3);
        if (!leans) return;
        finding.message += ", which leans by " + number(lean, 2) + " degrees";
        finding.fix =
            "Find out why it leans: a flat map is 128 128 255 and can be left out, but without this one the surface is lit as if it had turned.";
      });
    }};

}  // namespace etak
