// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/validate/rules/rows.h"

namespace etak {

namespace {

constexpr RuleParameter etk404_parameters[] = {
    {"share", 99.9, 99.9, "%", "of dark values in the comb"},
    {"min_values", 4096, 4096, "", "fewer dark values are not judged"},
    {"codes", 8, 8, "", "least number of distinct dark codes"},
};

void etk404(RuleCheck& check) {
  for (const TileEvidence& tile : check.evidence.tiles) {
    const Detail& d = tile.detail;
    if (!d.every_row) continue;
    for (const bool diffuse : {true, false}) {
      const auto& picture = diffuse ? check.evidence.a : check.evidence.b;
      if (!picture || picture->header.bits != 8 || (!diffuse && check.evidence.metal_rough)) continue;
      std::uint64_t low = 0, among = 0;
      int distinct = 0;
      for (std::size_t code = 0; code <= 100; ++code) {
        std::uint64_t count = 0;
        for (std::size_t c = 0; c < 3; ++c) count += (diffuse ? d.a : d.b)[c][code];
        low += count;
        if (comb_codes()[code]) among += count;
        distinct += count != 0;
      }
      if (static_cast<double>(low) < check.parameter("min_values") || distinct < check.parameter("codes") ||
          100.0 * static_cast<double>(among) < check.parameter("share") * static_cast<double>(low))
        continue;
      Finding& finding = check.report(tile, diffuse ? FileRole::diffuse_alpha : FileRole::specular_gloss);
      finding.value = percent(static_cast<double>(among) / static_cast<double>(low)) + " in the comb";
      finding.limit = number(check.parameter("share"), 4) + " %";
      finding.message = in_thousands(low) + " dark values use " + std::to_string(distinct) +
                        " of 101 codes, those of an 8-bit linear source";
    }
  }
}

}  // namespace

constinit const Rule etk404_linear8_comb{
    "ETK404",
    "linear8-comb",
    "Codes of an 8-bit linear source",
    Severity::warning,
    Severity::error,
    {Need::bytes_a, Need::bytes_b},
    etk404_parameters,
    "Comb share 1.0000 for re-encoded sources, 0.39 to 0.59 for untouched smooth textures; "
    "183 of 256 codes survive (etak)",
    "At least 4,096 values with code 100 or less and at least 8 distinct ones, of which 99.9 "
    "% are among the 33 codes that an 8-bit linear source reaches. One finding per picture "
    "and tile.",
    "Dark tones were quantised before the curve: steps of up to 13 codes, which show as "
    "bands.",
    "A texture converted to linear 8 bits for editing and back.",
    "Edit in 16 bits or float.",
    &etk404};

}  // namespace etak
