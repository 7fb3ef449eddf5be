// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk302_gloss_clipped{
    .id = "ETK302",
    .slug = "gloss-clipped",
    .title = "Gloss is cut off at 0 or 1",
    .severity = Severity::warning,
    .needs = {Need::bytes_b},
    .parameters = {{"share", 5, 5, "%", "share of opaque texels that may stand at an end"}},
    .source = "Godot and PBR-Check flag roughness below 0.01 and above 0.99",
    .what = "More than 5 % of the opaque texels have gloss code 0, or 255.",
    .why =
        "A level adjustment or a conversion between gloss conventions has thrown structure away; gloss 1 is a perfect mirror. Schueler's g saturates for glTF roughness below 0.149 and above 0.904.",
    .example = "Contrast of a roughness map pushed up until the ends clip.",
    .fix = "Lower the contrast before export, or convert roughness by another convention.",
    .check = [](RuleCheck& check) {
      if (!check.has_gloss()) return;
      for (const TileEvidence& tile : check.evidence.tiles) {
        const ByteCounts& counts = tile.counts;
        const std::uint64_t least = check.least_area(tile);
        for (const bool full : {false, true}) {
          const std::uint64_t count = full ? counts.gloss_full : counts.gloss_zero;
          const double share =
              static_cast<double>(count) / static_cast<double>(std::max<std::uint64_t>(1, counts.opaque));
          // ETK301 reports a constant gloss.
          if (100 * share <= check.parameter("share") || count < least ||
              counts.gloss_least == counts.gloss_most)
            continue;
          Finding& finding = check.report(tile, FileRole::specular_gloss);
          finding.area_px = count;
          finding.area_share = share;
          finding.value = full ? "gloss 1" : "gloss 0";
          finding.limit = number(check.parameter("share"), 3) + " %";
          finding.message = "gloss stands at " + std::string(full ? "255" : "0") + " on " +
                            area_text(count, counts.opaque) + " of the opaque texels";
          break;
        }
      }
    }};

}  // namespace etak
