// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk106_dielectric_coloured{
    .id = "ETK106",
    .slug = "dielectric-coloured",
    .title = "A dielectric F0 with a hue",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::bytes_b, Need::regions},
    .parameters = {{"spread_warning", 4, 4, "codes", "difference of channels above which it is reported"},
                   {"spread_error", 12, 12, "codes", "above which it is an error"}},
    .source = "Hoffman: F0 of dielectrics is achromatic; Schueler's own diamond row is 114/115/117",
    .what =
        "A plateau below the forbidden zone whose channels are more than 4 codes apart; an error above 12 codes. In metal-rough sets only where metallic is 0: else base colour shines through, as on a "
        "public sample whose lossy metallic channel wavers by a few codes.",
    .why =
        "The index of transparent media hardly changes over the visible range, so their reflections have no hue. Colour belongs into the diffuse texture.",
    .example = "The diffuse colour multiplied into the specular map.",
    .fix = "Make F0 grey; put the hue into diffuse.",
    .region = RegionKind::coloured,
    .check = [](RuleCheck& check) {
      for (const auto& [tile, plateaus] : check.regions(RegionKind::coloured)) {
        // The most colourful plateau is the one to show.
        const Plateau* shown = nullptr;
        int most = 0;
        for (const Plateau& plateau : plateaus.largest) {
          const auto codes = check.bytes(plateau.specular);
          const int spread =
              *std::max_element(codes.begin(), codes.end()) - *std::min_element(codes.begin(), codes.end());
          if (spread > most) {
            most = spread;
            shown = &plateau;
          }
        }
        if (shown == nullptr || most <= check.parameter("spread_warning")) continue;
        Finding& finding = check.report(tile, plateaus, *shown);
        if (most > check.parameter("spread_error")) finding.severity = check.at_least(Severity::error);
        finding.limit = number(check.parameter("spread_warning"), 3) + " codes between channels";
        finding.message += ", channels " + std::to_string(most) + " codes apart";
      }
    }};

}  // namespace etak
