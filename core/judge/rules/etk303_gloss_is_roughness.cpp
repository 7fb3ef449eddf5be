// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "core/judge/rules/rows.h"

namespace etak {

namespace {

void etk303(RuleCheck& check) {
  std::size_t asked = 0, inverted = 0;
  for (const TileEvidence& tile : check.evidence.tiles) {
    if (!tile.tile.typical_gloss || tile.counts.gloss_texels == 0) continue;
    ++asked;
    const double mean =
        static_cast<double>(tile.counts.gloss_sum) / (255 * static_cast<double>(tile.counts.gloss_texels));
    inverted += std::abs(1 - mean - *tile.tile.typical_gloss) < std::abs(mean - *tile.tile.typical_gloss);
  }
  if (asked < 3 || inverted < asked) return;
  Finding& finding = check.report();
  finding.value = std::to_string(inverted) + " of " + std::to_string(asked) + " materials";
  finding.message =
      "1 - gloss is nearer to the typical gloss of all " + std::to_string(asked) + " materials than gloss is";
}

}  // namespace

constinit const Rule etk303_gloss_is_roughness{
    "ETK303",
    "gloss-is-roughness",
    "Gloss may be roughness",
    Severity::info,
    Severity::warning,
    {Need::bytes_b, Need::named},
    {},
    "etak (proposed; needs three materials because one alone says nothing)",
    "The file gives the typical gloss of at least three materials, and 1 - gloss fits better "
    "for all of them.",
    "The two conventions differ by an inversion only, and both look plausible alone.",
    "A roughness map saved into the gloss channel.",
    "Invert the channel.",
    &etk303};

}  // namespace etak
