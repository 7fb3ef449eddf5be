// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk401_specular_stored_linear{
    .id = "ETK401",
    .slug = "specular-stored-linear",
    .title = "F0 was stored without the sRGB curve",
    .severity = Severity::error,
    .needs = {Need::bytes_b, Need::regions},
    .parameters = {{"share", 80, 80, "%", "of the plateau area with codes up to 84"}},
    .source = "Leave-one-out over 109 materials with 3 codes of noise: 99 % of dielectrics recognised (etak)",
    .what =
        "Of the plateaus with codes up to 84 at least 80 % of the area has codes 4 to 26, and codes 36 to 84 have at most a tenth of that (not none, because half metals of a public sample lie there when "
        "stored linear). Brighter plateaus are not judged: the value of a metal does not tell how it was stored, and metals stored linear lie in the zone or just below it.",
    .why = "F0 0.02 to 0.08 stored linear are codes 5 to 20 and read back as 0.0015 to 0.0072.",
    .example = "A shader graph baked to a linear texture, imported as sRGB.",
    .fix = "Export specular with the sRGB curve, or import it as linear.",
    .region = RegionKind::any_f0,
    .check = [](RuleCheck& check) {
      for (const TileEvidence& tile : check.evidence.tiles) {
        const PlateauSummary* plateaus = tile.region(RegionKind::any_f0);
        if (plateaus == nullptr || plateaus->regions == 0) continue;
        std::size_t dielectric = 0, linear = 0, ordinary = 0;
        for (int code = 0; code <= dielectric_codes.last; ++code) {
          const std::size_t area = plateaus->area_by_code[static_cast<std::size_t>(code)];
          dielectric += area;
          if (linear_dielectric_codes.holds(code)) linear += area;
          if (dielectric_codes.holds(code)) ordinary += area;
        }
        if (linear == 0 || 10 * ordinary > linear ||
            100.0 * static_cast<double>(linear) < check.parameter("share") * static_cast<double>(dielectric))
          continue;
        const auto shown =
            std::find_if(plateaus->largest.begin(), plateaus->largest.end(), [&](const Plateau& p) {
              return linear_dielectric_codes.holds(check.tables.encode(luminance_of(p.specular)));
            });
        if (shown == plateaus->largest.end()) continue;
        Finding& finding = check.report(tile, *plateaus, *shown);
        finding.box = shown->box;
        finding.area_px = linear;
        finding.limit = "sRGB codes 36 to 84";
        const double meant = check.tables.encode(luminance_of(shown->specular)) / 255.0;
        finding.cause = "stored linear: code / 255 is F0 " + number(meant, 2);
        finding.message =
            finding.value + " on " + area_text(linear, tile.counts.texels) + "; " + finding.cause;
      }
    }};

}  // namespace etak
