// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk406_posterised{
    .id = "ETK406",
    .slug = "posterised",
    .title = "A gradient in few steps",
    .severity = {Severity::info, Severity::warning},
    .needs = {Need::bytes_a, Need::bytes_b},
    .source =
        "etak (proposed); at least 8 steps of similar width are asked for, because flat artwork of a few colours is no mistake",
    .what =
        "Diffuse or F0 (green) is smooth along 80 % of neighbouring texels, and uses less than a quarter of the codes between its 1st and 99th percentile, in at least 8 steps of similar width. One finding "
        "per picture and tile. Fewer levels of F0 are what a few materials have.",
    .why = "Bands show in gradients.",
    .example = "A texture saved with a palette, or quantised by a video codec.",
    .fix = "Export again from the source.",
    .check = [](RuleCheck& check) {
      for (const TileEvidence& tile : check.evidence.tiles) {
        const Detail& d = tile.detail;
        if (!d.every_row || d.opaque < 4096) continue;
        for (const bool diffuse : {true, false}) {
          const std::uint64_t smooth = diffuse ? d.smooth_a : d.smooth_b;
          // The F0 of a metal-rough set comes from its base colour, which is judged as diffuse.
          if (!(diffuse ? check.evidence.a : check.evidence.b) || (!diffuse && check.evidence.metal_rough) ||
              static_cast<double>(smooth) < 0.8 * static_cast<double>(d.texels))
            continue;
          const CodeSteps steps = code_steps((diffuse ? d.a : d.b)[1]);
          const int span = steps.last - steps.first + 1;
          if (steps.used < 8 || 4 * steps.used >= span || steps.widest_step > 2 * steps.median_step) continue;
          Finding& finding = check.report(tile, diffuse ? FileRole::diffuse_alpha : FileRole::specular_gloss);
          finding.value = std::to_string(steps.used) + " codes";
          finding.limit = "a quarter of " + std::to_string(span);
          finding.message = std::string("a smooth gradient of ") + (diffuse ? "diffuse" : "F0") + " uses " +
                            finding.value + " between " + std::to_string(steps.first) + " and " +
                            std::to_string(steps.last);
        }
      }
    }};

}  // namespace etak
