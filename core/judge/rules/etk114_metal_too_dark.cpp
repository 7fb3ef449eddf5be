// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk114_metal_too_dark{
    .id = "ETK114",
    .slug = "metal-too-dark",
    .title = "A metal darker than any metal",
    .severity = Severity::error,
    .needs = {Need::metal_rough, Need::regions},
    .parameters = {{"error_share", 10, 10, "%", "share of the metal from which on it is an error"}},
    .source =
        "The library's darkest metals have F0 of 0.40 and more; found on a public sample asset, metallic 1 with F0 0.08",
    .what =
        "Metal-rough sets: a plateau with metallic 0.9 or more and F0 luminance of 0.20 or less. An error where that is a tenth of the metal, else a warning: small dark places on bright metal are dirt or "
        "occlusion painted into the base colour.",
    .why =
        "No metal reflects that little. The surface is a dielectric that was painted as metal, and loses its diffuse colour by that.",
    .example = "Black coated frames painted as metal with a dark base colour.",
    .fix = "Set metallic to 0 for paint and coatings; give bare metal its real F0.",
    .region = RegionKind::dark_metal,
    .check = [](RuleCheck& check) {
      for (const auto& [tile, plateaus] : check.regions(RegionKind::dark_metal)) {
        Finding& finding = check.report(tile, plateaus);
        const double metal = static_cast<double>(plateaus.area + tile.counts.metals);
        if (100 * static_cast<double>(plateaus.area) < check.parameter("error_share") * metal)
          finding.severity = check.at_most(Severity::warning);
        finding.limit = "above " + percent(check.settings.zone.low) + " for metals";
        finding.message = "metal of " + finding.message;
      }
    }};

}  // namespace etak
