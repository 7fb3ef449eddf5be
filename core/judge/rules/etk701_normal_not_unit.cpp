// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk701_normal_not_unit{
    .id = "ETK701",
    .slug = "normal-not-unit",
    .title = "Normals are not of unit length",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::maps},
    .parameters = {{"share", 0.02, 0.005, "",
                    "share of texels with a wrong length from which it is a finding"}},
    .source = "glTF 2.0, 3.9.3: normals are unit vectors; rounding to 8 bits makes at most 0.9 codes",
    .what =
        "The length of 2 % of the texels is more than 2.5 codes of 127.5 away from 1: found for lengths off by 4 codes on 5 % of the texels. Not where another rule says why (ETK704, ETK706, ETK708, ETK710), "
        "nor where z is left to the shader (blue all 0, or all 255). Of maps above a million texels evenly spread bands of 16 rows are looked at, by all 7xx rules.",
    .why =
        "Programs that do not normalise shade such texels too dark or too bright, and those that do not store z get another normal.",
    .example = "Two normal maps blended by a layer mode for colours.",
    .fix = "Normalise the map, or blend by a mode for normals (reoriented, whiteout).",
    .check = [](RuleCheck& check) {
      for_each_map(check, FileRole::normal, [&](const MapEvidence& map) {
        const NormalDamage damage = damage_of(map);
        if ((damage != NormalDamage::none && damage != NormalDamage::constant) ||
            normal_codes(map.normals) == NormalCodes::two_channels)
          return;
        // A constant has the length of its one texel.
        const double share = damage == NormalDamage::constant
                                 ? (map.normals.not_unit == 0 ? 0.0 : 1.0)
                                 : static_cast<double>(map.shape.off) /
                                       static_cast<double>(std::max<std::uint64_t>(1, map.shape.texels));
        if (share < check.parameter("share") || share == 0) return;
        Finding& finding = check.report(map);
        finding.area_share = share;
        finding.value = percent(share) + " of the texels";
        finding.limit = percent(check.parameter("share"));
        finding.message = "the length of " + finding.value +
                          " is off by more than 2.5 codes of 127.5; lengths are " +
                          number(std::sqrt(static_cast<double>(map.normals.shortest)) / 255, 3) + " to " +
                          number(std::sqrt(static_cast<double>(map.normals.longest)) / 255, 3);
        if (map.normals.not_unit_encoded == 0 && 2 * map.normals.not_unit > map.normals.texels)
          finding.cause = "possible cause: the codes were decoded from sRGB";
      });
    }};

}  // namespace etak
