// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/number.h"
#include "core/validate/rules/rows.h"

namespace etak {

namespace {

bool is_known_metal(const KnownMaterials& known, const std::array<double, 3>& linear) {
  return std::ranges::any_of(known.f0(), [&](const KnownF0& entry) {
    double distance = 0;
    for (std::size_t c = 0; c < 3; ++c) distance = std::max(distance, std::abs(linear[c] - entry.linear[c]));
    return entry.conductor && distance <= 0.03;
  });
}

void etk107(RuleCheck& check) {
  if (const auto& b = check.evidence.b; b && b->floats && b->floats->above_one != 0) {
    const FloatFacts& f = *b->floats;
    const std::array<double, 3> value{static_cast<double>(f.above_value[0]),
                                      static_cast<double>(f.above_value[1]),
                                      static_cast<double>(f.above_value[2])};
    const bool metal = f.above_luminance <= 1 && is_known_metal(known_materials(check.settings), value);
    Finding& finding = check.report(*b);
    finding.severity = metal ? check.severity() : check.at_least(Severity::error);
    finding.box = PixelBox{f.above_at[0], f.above_at[1], 1, 1};
    finding.area_px = f.above_one;
    finding.linear = value;
    finding.luminance = f.above_luminance;
    finding.value = number(static_cast<double>(f.largest), 4);
    finding.limit = "1";
    finding.message = "F0 up to " + finding.value + " on " + in_thousands(f.above_one) + " px" +
                      (metal ? ", as metals have outside of the sRGB gamut" : "");
    return;
  }
  for (const TileEvidence& tile : check.evidence.tiles) {
    // Codes of a coloured metal: one channel at the end of the scale, another far from it.
    const Detail& d = tile.detail;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint64_t full = d.b[c][255];
      std::uint64_t least = full;
      for (std::size_t other = 0; other < 3; ++other) least = std::min<std::uint64_t>(least, d.b[other][255]);
      if (full < std::max<std::uint64_t>(check.least_area(tile), d.opaque / 100) || 10 * least > full)
        continue;
      Finding& finding = check.report(tile, FileRole::specular_gloss);
      const char* const channel[] = {"red", "green", "blue"};
      finding.value = std::string(channel[c]) + " 255";
      finding.limit = "254";
      finding.area_share =
          static_cast<double>(full) / static_cast<double>(std::max<std::uint64_t>(1, d.texels));
      finding.message = std::string("F0 ") + channel[c] + " stands at code 255 on " +
                        percent(finding.area_share) +
                        " of the texels while the others do not: clipped or mapped into the gamut";
      break;
    }
  }
}

}  // namespace

constinit const Rule etk107_f0_above_one{
    "ETK107",
    "f0-above-one",
    "F0 above 1, or cut off there",
    Severity::info,
    Severity::warning,
    {Need::bytes_b, Need::floats},
    {},
    "Hoffman prints gold with red 1.022; glTF refuses F0 above 1",
    "Float: a channel above 1; information while the luminance is not above 1 and a metal of "
    "the library matches, else an error. 8 bits: a channel at code 255 on bright coloured "
    "F0, which was clipped or mapped into the gamut by somebody.",
    "Gold's red lies outside of linear sRGB, so 1.02 to 1.06 is right there. Anything else "
    "above 1 creates energy.",
    "Specular multiplied by an exposure; gold exported to 8 bits, red clipped.",
    "Bring F0 to at most 1; for gold and copper say which gamut mapping was used.",
    &etk107};

}  // namespace etak
