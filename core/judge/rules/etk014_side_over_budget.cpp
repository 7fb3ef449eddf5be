// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk014_side_over_budget{
    .id = "ETK014",
    .slug = "side-over-budget",
    .title = "A picture is larger than the project allows",
    .severity = Severity::error,
    .needs = {Need::header, Need::maps},
    .parameters = {{"colour_side", 0, 0, "texels", "longest side of colours, F0 and emission; 0: any"},
                   {"normal_side", 0, 0, "texels", "longest side of normal maps; 0: any"},
                   {"data_side", 0, 0, "texels",
                    "longest side of roughness, metallic, gloss, height and occlusion; 0: any"}},
    .source = "The budget of the project, in etak.toml",
    .what =
        "A side of a picture is longer than [rules] ETK014 of etak.toml allows for its class. Silent without a limit.",
    .why = "Twice the side is four times the memory, and the eye sees roughness in less detail than colour.",
    .example = "A roughness map left at 4096 where 1024 was agreed on.",
    .fix = "Export the picture at the agreed size.",
    .check = [](RuleCheck& check) {
      const auto look = [&](FileRole role, int width, int height, auto& picture) {
        const double most = check.parameter(parameter_of_class(role, "side"));
        if (most <= 0 || std::max(width, height) <= most) return;
        Finding& finding = check.report(picture);
        finding.value = std::to_string(width) + " x " + std::to_string(height);
        finding.limit = number(most, 9) + " on a side";
        finding.message = "the picture is " + finding.value + ", where the project allows " + finding.limit;
      };
      for (const PictureEvidence& picture : check.evidence.headers)
        look(picture.role, picture.header.width, picture.header.height, picture);
      for (const MapEvidence& map : check.evidence.maps) look(map.role, map.width, map.height, map);
    }};

}  // namespace etak
