// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk709_gloss_ignores_normals{
    .id = "ETK709",
    .slug = "gloss-ignores-normals",
    .title = "Gloss does not widen where normals vary",
    .severity = {Severity::info, Severity::warning},
    .needs = {Need::maps},
    .parameters = {{"share", 0.05, 0.05, "", "share of the blocks from which it is a finding"}},
    .source =
        "Toksvig 2005, Mipmapping Normal Maps: a mean normal of length m allows an exponent of m / (1 - m)",
    .what =
        "In 5 % of the blocks of 4 x 4 texels the mean normal is shorter than 0.9 and the highlight more than four times narrower than it allows, and roughness does not rise with what the mean normal "
        "lacks (correlation at most 0.1). Found for roughness below 0.48 beside normals 26 degrees around their mean.",
    .why =
        "From afar the highlight of one texel flickers on and off, since mips average normals but keep the gloss.",
    .example = "Gloss painted flat over a rough relief.",
    .fix = "Raise roughness by what the normals vary, or let the mips do it.",
    .check = [](RuleCheck& check) {
      for_each_map(check, FileRole::normal, [&](const MapEvidence& map) {
        const NormalDamage damage = damage_of(map);
        if (!map.gloss || damage == NormalDamage::height || damage == NormalDamage::encoded) return;
        const GlossBesideNormals& gloss = *map.gloss;
        const double share =
            static_cast<double>(gloss.narrow) / static_cast<double>(std::max<std::uint64_t>(1, gloss.blocks));
        if (share < check.parameter("share") || gloss.relation.correlation() > 0.1) return;
        Finding& finding = check.report(map);
        finding.file = gloss.label;
        finding.area_share = share;
        finding.value = percent(share) + " of the blocks";
        finding.message = "highlights are four times narrower than the normals of 4 x 4 texels allow on " +
                          percent(share) + " of the map, and no rougher where the normals vary";
      });
    }};

}  // namespace etak
