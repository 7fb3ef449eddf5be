// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk708_normal_jpeg{
    .id = "ETK708",
    .slug = "normal-jpeg",
    .title = "A normal map was compressed as JPEG",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::maps},
    .source =
        "ITU-T T.81: coefficients of 8 x 8 blocks are multiples of a step; steps of 3 to 5 codes at quality 85",
    .what =
        "The coefficients of brightness in blocks of 8 x 8 texels are multiples of a step, whatever format the file has now. Found from quality 85 down to 40, where 40 different blocks have something of a "
        "low frequency; not where the picture was cropped or scaled since.",
    .why =
        "Eighths of a block's edge show in highlights, and lengths are wrong; colour subsampling, made for eyes, halves the relief's resolution.",
    .example = "A normal map sent by a web page or a chat.",
    .fix = "Export the map again without loss.",
    .check = [](RuleCheck& check) {
      for_each_map(check, FileRole::normal, [&](const MapEvidence& map) {
        if (!map.jpeg || damage_of(map) != NormalDamage::jpeg) return;
        Finding& finding = check.report(map);
        finding.value = "steps of " + number(map.jpeg->step, 3) + " codes";
        finding.limit = "no steps";
        finding.message = "blocks of 8 x 8 texels bear the " + finding.value +
                          " of a JPEG's lowest frequencies (" + percent(map.jpeg->score) + " agreement)";
      });
    }};

}  // namespace etak
