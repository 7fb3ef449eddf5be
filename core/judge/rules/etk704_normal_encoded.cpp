// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

void etk704(RuleCheck& check) {
  for_each_map(check, FileRole::normal, [&](const MapEvidence& map) {
    if (damage_of(map) != NormalDamage::encoded) return;
    const bool is_encoded = normal_codes(map.normals) == NormalCodes::encoded;
    Finding& finding = check.report(map);
    finding.value = is_encoded ? "flat is code 188" : "flat is code 55";
    finding.limit = "flat is code 128";
    finding.message = std::string("the codes were ") + (is_encoded ? "encoded to" : "decoded from") +
                      " sRGB: undoing it gives unit length to all but " +
                      percent(static_cast<double>(is_encoded ? map.normals.not_unit_decoded
                                                             : map.normals.not_unit_encoded) /
                              static_cast<double>(map.normals.texels)) +
                      " of the texels";
    finding.fix = is_encoded ? "Decode the codes from sRGB, and export normal maps as plain data."
                             : "Encode the codes to sRGB, and import normal maps as plain data.";
  });
}

}  // namespace

constinit const Rule etk704_normal_encoded{
    "ETK704",
    "normal-encoded",
    "A normal map went through the sRGB curve",
    Severity::error,
    Severity::error,
    {Need::maps},
    {},
    "glTF 2.0, 3.9.3: the texture is linear; unit length is the evidence",
    "More than half of the texels have another length than 1, and undoing one of the sRGB conversions leaves "
    "a tenth at most. Found from the first conversion on, of a map of one colour too.",
    "All normals lean to one side, and lighting has an edge at every UV seam.",
    "An editor of pictures that works in linear light and saves every picture as sRGB.",
    "Undo the conversion, and treat normal maps as plain data.",
    &etk704};

}  // namespace etak
