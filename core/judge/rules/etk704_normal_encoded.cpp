// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk704_normal_encoded{
    .id = "ETK704",
    .slug = "normal-encoded",
    .title = "A normal map went through the sRGB curve",
    .severity = Severity::error,
    .needs = {Need::maps},
    .source = "glTF 2.0, 3.9.3: the texture is linear; unit length is the evidence",
    .what =
        "More than half of the texels have another length than 1, and undoing one of the sRGB conversions leaves a tenth at most, or brings a mean that leans along both axes back to straight up, which tells JPEG and lossy WebP. Found from the first conversion on, of a map of one colour too.",
    .why = "All normals lean to one side, and lighting has an edge at every UV seam.",
    .example = "An editor of pictures that works in linear light and saves every picture as sRGB.",
    .fix = "Undo the conversion, and treat normal maps as plain data.",
    .check = [](RuleCheck& check) {
      for_each_map(check, FileRole::normal, [&](const MapEvidence& map) {
        if (damage_of(map) != NormalDamage::encoded) return;
        const bool is_encoded = normal_codes(map.normals) == NormalCodes::encoded;
        Finding& finding = check.report(map);
        finding.value = is_encoded ? "flat is code 188" : "flat is code 55";
        finding.limit = "flat is code 128";
        const double wrong =
            static_cast<double>(is_encoded ? map.normals.not_unit_decoded : map.normals.not_unit_encoded) /
            static_cast<double>(map.normals.texels);
        const auto code = [&](std::size_t c) { return number(127.5 + 127.5 * map.normals.mean(c), 3); };
        finding.message =
            std::string("the codes were ") + (is_encoded ? "encoded to" : "decoded from") + " sRGB: " +
            (wrong <= 0.1 ? "undoing it gives unit length to all but " + percent(wrong) + " of the texels"
                          : "the mean of red and green is " + code(0) + " and " + code(1) +
                                ", and undoing it lets the mean normal stand up");
        finding.fix = is_encoded ? "Decode the codes from sRGB, and export normal maps as plain data."
                                 : "Encode the codes to sRGB, and import normal maps as plain data.";
      });
    }};

}  // namespace etak
