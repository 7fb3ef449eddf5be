// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk714_normal_hollow{
    .id = "ETK714",
    .slug = "normal-hollow",
    .title = "Normals are hollow where the height map stands out",
    .severity = Severity::warning,
    .needs = {Need::maps},
    .source =
        "The slope of a surface along the rows is that of its heights, and red is less than 128 where it rises",
    .what =
        "The slopes that red tells are those of the height map beside with the other sign, to 50 %. Red points to the right in every convention, so that one of the two is inverted.",
    .why = "Relief that displacement raises is lit as if it were cut in.",
    .example = "A depth map named height; normals of which both axes, or red alone, were inverted.",
    .fix =
        "Invert what is inverted: the height map, or red of the normal map, with green where that is inverted too.",
    .check = [](RuleCheck& check) {
      for_each_map(check, FileRole::normal, [&](const MapEvidence& map) {
        constexpr double least_agreement = 0.5;
        constexpr std::uint64_t least_texels = 64;
        const double along = map.shape.relief_x.correlation_about_zero();
        if (map.shape.relief_x.count < least_texels || along > -least_agreement) return;
        Finding& finding = check.report(map);
        finding.value = "inverted";
        finding.limit = "slopes of the height map";
        finding.message =
            "red tells the slopes of the height map beside with the other sign: they agree to " +
            percent(-along);
        finding.cause =
            "possible cause: red and green inverted, which turns the relief inside out, red alone, or a map of depths beside";
      });
    }};

}  // namespace etak
