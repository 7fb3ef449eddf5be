// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk301_gloss_constant{
    .id = "ETK301",
    .slug = "gloss-constant",
    .title = "Gloss is constant",
    .severity = {Severity::info, Severity::warning},
    .needs = {Need::bytes_b},
    .parameters = {{"deviation", 0.5, 0.5, "codes", "standard deviation below which gloss is constant"},
                   {"min_texels", 4096, 4096, "px", "smaller tiles are not judged"}},
    .source = "Schueler 2009: variety of a material is put into g",
    .what =
        "Inside a tile of more than 4,096 texels the standard deviation of gloss is below 0.5 codes; a warning when all tiles of an atlas are like that.",
    .why = "Real surfaces vary in polish, dust and wear; constant gloss looks like plastic.",
    .example = "Gloss slot filled with one grey.",
    .fix = "Paint gloss; or, if one number is meant, leave the texture out and use the number.",
    .check = [](RuleCheck& check) {
      if (!check.has_gloss()) return;
      std::size_t large = 0;
      std::vector<std::size_t> constant;
      for (std::size_t i = 0; i < check.evidence.tiles.size(); ++i) {
        // A constant that a layout stores as a number is what this rule advises.
        if (check.evidence.tiles[i].tile.flat[1]) continue;
        const ByteCounts& counts = check.evidence.tiles[i].counts;
        if (static_cast<double>(counts.texels) <= check.parameter("min_texels") || counts.gloss_texels == 0)
          continue;
        ++large;
        const double n = static_cast<double>(counts.gloss_texels),
                     mean = static_cast<double>(counts.gloss_sum) / n;
        const double variance = static_cast<double>(counts.gloss_squares) / n - mean * mean;
        if (std::sqrt(std::max(0.0, variance)) < check.parameter("deviation")) constant.push_back(i);
      }
      for (const std::size_t i : constant) {
        const TileEvidence& tile = check.evidence.tiles[i];
        Finding& finding = check.report(tile, FileRole::specular_gloss);
        if (large > 1 && constant.size() == large) finding.severity = check.at_least(Severity::warning);
        const double mean =
            static_cast<double>(tile.counts.gloss_sum) / static_cast<double>(tile.counts.gloss_texels);
        finding.value = "gloss " + number(mean / 255, 2);
        finding.limit = "standard deviation of " + number(check.parameter("deviation"), 2) + " codes";
        finding.message = "gloss is " + number(mean / 255, 2) + " (byte " +
                          number(std::floor(mean + 0.5), 3) + ") all over " +
                          in_thousands(tile.counts.texels) + " px";
      }
    }};

}  // namespace etak
