// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk304_gloss_steps{
    .id = "ETK304",
    .slug = "gloss-steps",
    .title = "Gloss has only a few steps",
    .severity = {Severity::info, Severity::warning},
    .needs = {Need::bytes_b},
    .parameters = {{"codes", 8, 8, "", "most distinct codes that are reported"},
                   {"min_texels", 16384, 16384, "px", "smaller tiles are not judged"},
                   {"span", 32, 32, "codes", "least distance of the ends"}},
    .source = "One step of 8 bits changes the exponent 2^(12 g) by 3.3 % (etak)",
    .what = "At most 8 distinct gloss codes over 16,384 opaque texels or more that span more than 32 codes.",
    .why = "Highlights change their size in visible steps.",
    .example = "Gloss stored in a palette picture or posterised.",
    .fix = "Export gloss from its source with 8 bits.",
    .check = [](RuleCheck& check) {
      if (!check.has_gloss()) return;
      for (const TileEvidence& tile : check.evidence.tiles) {
        const Detail& d = tile.detail;
        if (!d.every_row || static_cast<double>(d.opaque) < check.parameter("min_texels")) continue;
        // Only opaque texels count, so that nothing is judged under an alpha of 0 all over (ETK503).
        int distinct = 0, least = 255, most = 0;
        for (int code = 0; code < 256; ++code) {
          if (d.b[3][static_cast<std::size_t>(code)] == 0) continue;
          ++distinct;
          least = std::min(least, code);
          most = code;
        }
        if (distinct > check.parameter("codes") || most - least <= check.parameter("span")) continue;
        Finding& finding = check.report(tile, FileRole::specular_gloss);
        finding.value = std::to_string(distinct) + " codes";
        finding.limit = "more than " + number(check.parameter("codes"), 3);
        finding.message = "gloss has " + finding.value + " between " + std::to_string(least) + " and " +
                          std::to_string(most) + " over " + in_thousands(d.opaque) + " px";
      }
    }};

}  // namespace etak
