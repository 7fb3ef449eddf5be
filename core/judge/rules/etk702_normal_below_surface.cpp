// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk702_normal_below_surface{
    .id = "ETK702",
    .slug = "normal-below-surface",
    .title = "Normals point into the surface",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::maps},
    .parameters = {{"share", 0.001, 0.0001, "", "share of texels from which it is a finding"}},
    .source = "glTF 2.0, 3.9.3: z of a tangent-space normal is at least 0",
    .what =
        "Blue is below code 127, which is z below 0, on 0.1 % of the texels: found from there on. An error from 5 %.",
    .why = "No light can fall on such a texel of a surface that is seen: it is black, or shines from behind.",
    .example =
        "A map of object-space normals in the slot for tangent space; a cage that the high-detail model pierces.",
    .fix = "Bake again in tangent space, with a larger cage; single texels can be mirrored to z above 0.",
    .check = [](RuleCheck& check) {
      for_each_map(check, FileRole::normal, [&](const MapEvidence& map) {
        const NormalDamage damage = damage_of(map);
        if (damage == NormalDamage::height || damage == NormalDamage::encoded || map.normals.texels == 0 ||
            normal_codes(map.normals) == NormalCodes::two_channels)
          return;
        const double share = static_cast<double>(map.normals.below) / static_cast<double>(map.normals.texels);
        if (share < check.parameter("share") || share == 0) return;
        Finding& finding = check.report(map);
        if (share >= 0.05) finding.severity = check.at_least(Severity::error);
        finding.area_px = map.normals.below;
        finding.area_share = share;
        finding.value = percent(share) + " of the texels";
        finding.limit = "blue of 127";
        finding.message =
            "z is below 0 on " + area_text(map.normals.below, map.normals.texels) + " that were looked at";
        if (share < 0.25) return;
        // Normals of any space have unit length, and colours have not.
        if (2 * map.normals.not_unit > map.normals.texels)
          finding.cause = "possible cause: a picture of colours; most texels have another length than 1";
        else
          finding.cause =
              "possible cause: normals of object space, exchanged channels, or a picture of colours";
      });
    }};

}  // namespace etak
