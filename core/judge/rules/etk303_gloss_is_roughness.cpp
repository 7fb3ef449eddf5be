// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk303_gloss_is_roughness{
    .id = "ETK303",
    .slug = "gloss-is-roughness",
    .title = "Gloss may be roughness",
    .severity = {Severity::info, Severity::warning},
    .needs = {Need::bytes_b, Need::named},
    .source = "etak (proposed; needs three materials because one alone says nothing)",
    .what =
        "The file gives the typical gloss of at least three materials, and 1 - gloss fits better for all of them.",
    .why = "The two conventions differ by an inversion only, and both look plausible alone.",
    .example = "A roughness map saved into the gloss channel.",
    .fix = "Invert the channel.",
    .check = [](RuleCheck& check) {
      std::size_t asked = 0, inverted = 0;
      for (const TileEvidence& tile : check.evidence.tiles) {
        if (!tile.tile.typical_gloss || tile.counts.gloss_texels == 0) continue;
        ++asked;
        const double mean = static_cast<double>(tile.counts.gloss_sum) /
                            (255 * static_cast<double>(tile.counts.gloss_texels));
        inverted += std::abs(1 - mean - *tile.tile.typical_gloss) < std::abs(mean - *tile.tile.typical_gloss);
      }
      if (asked < 3 || inverted < asked) return;
      Finding& finding = check.report();
      finding.value = std::to_string(inverted) + " of " + std::to_string(asked) + " materials";
      finding.message = "1 - gloss is nearer to the typical gloss of all " + std::to_string(asked) +
                        " materials than gloss is";
    }};

}  // namespace etak
