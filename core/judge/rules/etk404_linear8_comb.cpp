// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk404_linear8_comb{
    .id = "ETK404",
    .slug = "linear8-comb",
    .title = "Codes of an 8-bit linear source",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::bytes_a, Need::bytes_b},
    .parameters = {{"share", 99.9, 99.9, "%", "of dark values in the comb"},
                   {"min_values", 4096, 4096, "", "fewer dark values are not judged"},
                   {"codes", 8, 8, "", "least number of distinct dark codes"}},
    .source =
        "Comb share 1.0000 for re-encoded sources, 0.39 to 0.59 for untouched smooth textures; 183 of 256 codes survive (etak)",
    .what =
        "At least 4,096 values with code 100 or less and at least 8 distinct ones, of which 99.9 % are among the 33 codes that an 8-bit linear source reaches. A code with more than a quarter of the dark "
        "values is left out: it is a flat area, such as leather of one F0, and would outweigh all others. One finding per picture and tile.",
    .why = "Dark tones were quantised before the curve: steps of up to 13 codes, which show as bands.",
    .example = "A texture converted to linear 8 bits for editing and back.",
    .fix = "Edit in 16 bits or float.",
    .check = [](RuleCheck& check) {
      for (const TileEvidence& tile : check.evidence.tiles) {
        const Detail& d = tile.detail;
        if (!d.every_row) continue;
        for (const bool diffuse : {true, false}) {
          const auto& picture = diffuse ? check.evidence.a : check.evidence.b;
          if (!picture || picture->header.bits != 8 || (!diffuse && check.evidence.metal_rough)) continue;
          const DarkValues dark = dark_values(diffuse ? d.a : d.b);
          const auto count = static_cast<double>(dark.count), in_comb = static_cast<double>(dark.in_comb);
          if (count < check.parameter("min_values") || dark.codes < check.parameter("codes") ||
              100 * in_comb < check.parameter("share") * count)
            continue;
          Finding& finding = check.report(tile, diffuse ? FileRole::diffuse_alpha : FileRole::specular_gloss);
          finding.value = percent(in_comb / count) + " in the comb";
          finding.limit = number(check.parameter("share"), 4) + " %";
          finding.message = in_thousands(dark.count) + " dark values use " + std::to_string(dark.codes) +
                            " of 101 codes, those of an 8-bit linear source";
        }
      }
    }};

}  // namespace etak
