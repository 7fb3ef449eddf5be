// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk201_energy_sum{
    .id = "ETK201",
    .slug = "energy-sum",
    .title = "Diffuse and specular reflect more than arrives",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::bytes_a, Need::bytes_b},
    .parameters = {{"limit", 1 + 1.0 / 255, 1 + 1.0 / 255, "", "largest sum of a channel that is let pass"},
                   {"far_limit", 1.02, 1.02, "", "above which it is an error"}},
    .source =
        "Energy conservation; of 45 measured materials the brightest, Spectralon, reaches 1.012 and 44 stay below 1",
    .what =
        "Texels where the linear sum of diffuse and F0 exceeds 1 + 1/255 in a channel; an error above 1.02. Where the shader weighs diffuse by what the specular part leaves (glTF), Kd (1 - max Ks) + Ks is "
        "tested instead, which only a value above 1 can break. Reported from the area on that a region needs: single texels are noise.",
    .why = "More light leaves than comes in: interreflections in a renderer grow without end.",
    .example = "White plaster at 1.0 diffuse with F0 0.04 on top.",
    .fix = "Lower diffuse to 1 - F0, or F0 to that of the material.",
    .check = [](RuleCheck& check) {
      for (const TileEvidence& tile : check.evidence.tiles) {
        const ByteCounts& counts = tile.counts;
        if (counts.energy_over < check.least_area(tile)) continue;
        Finding& finding = check.report(tile, FileRole::diffuse_alpha);
        if (counts.energy_far_over >= check.least_area(tile))
          finding.severity = check.at_least(Severity::error);
        finding.box = counts.energy_box;
        finding.area_px = counts.energy_over;
        finding.area_share = static_cast<double>(counts.energy_over) / static_cast<double>(counts.texels);
        const double worst = static_cast<double>(counts.energy_worst) / linear_one;
        finding.value = "sum " + number(worst, 4);
        finding.limit = number(check.parameter("limit"), 4);
        finding.message = "diffuse and F0 add up to " + number(worst, 4) + " (codes " +
                          std::to_string(counts.energy_at[0]) + " and " +
                          std::to_string(counts.energy_at[1]) + ") at worst, above " + finding.limit +
                          " on " + area_text(counts.energy_over, counts.texels);
      }
    }};

}  // namespace etak
