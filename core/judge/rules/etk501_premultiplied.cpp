// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk501_premultiplied{
    .id = "ETK501",
    .slug = "premultiplied",
    .title = "Colour is multiplied by alpha",
    .severity = Severity::error,
    .needs = {Need::bytes_a},
    .parameters = {{"min_texels", 256, 256, "px", "fewer half-transparent texels are not judged"},
                   {"share", 99.9, 99.9, "%", "of them with max(RGB) at most alpha + 1"},
                   {"correlation", 0.9, 0.9, "", "between max(RGB) and alpha"}},
    .source =
        "Premultiplied: share 1.000, correlation 0.96 to 0.99; straight: share 0.20 to 0.93, correlation within 0.02 (etak). glTF: texels must not be premultiplied",
    .what =
        "Over at least 256 texels with alpha 9 to 246: max(RGB) is at most alpha + 1 for 99.9 % of them and the correlation of the two is 0.9 or more. Metals and black diffuse (code 2 or less) are not "
        "judged: black stays black, whatever it is multiplied by.",
    .why = "The engine multiplies again: dark halos around cut-outs.",
    .example = "A picture saved by a compositor that works premultiplied.",
    .fix = "Export with straight alpha.",
    .check = [](RuleCheck& check) {
      if (!check.has_alpha()) return;
      for (const TileEvidence& tile : check.evidence.tiles) {
        const ByteCounts& c = tile.counts;
        if (static_cast<double>(c.middle) < check.parameter("min_texels")) continue;
        const double n = static_cast<double>(c.middle), share = static_cast<double>(c.middle_below) / n;
        const double mean_max = static_cast<double>(c.sum_max) / n,
                     mean_alpha = static_cast<double>(c.sum_alpha) / n;
        const double spread_max = static_cast<double>(c.sum_max2) / n - mean_max * mean_max;
        const double spread_alpha = static_cast<double>(c.sum_alpha2) / n - mean_alpha * mean_alpha;
        const double together = static_cast<double>(c.sum_product) / n - mean_max * mean_alpha;
        if (spread_max <= 0 || spread_alpha <= 0 || 100 * share < check.parameter("share")) continue;
        const double correlation = together / std::sqrt(spread_max * spread_alpha);
        if (correlation < check.parameter("correlation")) continue;
        Finding& finding = check.report(tile, FileRole::diffuse_alpha);
        finding.area_px = c.middle;
        finding.area_share = n / static_cast<double>(c.texels);
        finding.value = "correlation " + number(correlation, 3);
        finding.limit = number(check.parameter("correlation"), 3);
        finding.message = "diffuse is at most alpha on " + percent(share) + " of " + in_thousands(c.middle) +
                          " half-transparent px that have a colour, and follows it (correlation " +
                          number(correlation, 2) + ")";
      }
    }};

}  // namespace etak
