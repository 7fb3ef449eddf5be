// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

bool is_known_metal(const KnownMaterials& known, const std::array<double, 3>& linear) {
  return std::ranges::any_of(known.f0(), [&](const KnownF0& entry) {
    double distance = 0;
    for (std::size_t c = 0; c < 3; ++c) distance = std::max(distance, std::abs(linear[c] - entry.linear[c]));
    return entry.conductor && distance <= 0.03;
  });
}

// "red", "red and green".
std::string names_of(const std::vector<std::string_view>& channels) {
  std::string out;
  for (const std::string_view channel : channels) out += (out.empty() ? "" : " and ") + std::string(channel);
  return out;
}

// Looks for a coloured metal in codes: one or two channels at code 255, and another far from it.
void check_codes(RuleCheck& check, const TileEvidence& tile) {
  const Detail& d = tile.detail;
  const std::uint64_t least = std::min({d.b[0][255], d.b[1][255], d.b[2][255]});
  std::uint64_t most = 0;
  std::vector<std::string_view> full, others;
  for (std::size_t c = 0; c < 3; ++c) {
    constexpr std::array<std::string_view, 3> channels{"red", "green", "blue"};
    const std::uint64_t count = d.b[c][255];
    const bool stands =
        count >= std::max<std::uint64_t>(check.least_area(tile), d.opaque / 100) && 10 * least <= count;
    (stands ? full : others).push_back(channels[c]);
    if (stands) most = std::max(most, count);
  }
  if (full.empty()) return;
  Finding& finding = check.report(tile, FileRole::specular_gloss);
  const bool several = full.size() > 1;
  finding.value = names_of(full) + " 255";
  finding.limit = "254";
  finding.area_share = static_cast<double>(most) / static_cast<double>(std::max<std::uint64_t>(1, d.texels));
  finding.message = "F0 " + names_of(full) + (several ? " stand" : " stands") + " at code 255 on " +
                    (several ? "up to " : "") + percent(finding.area_share) + " of the texels while " +
                    names_of(others) + (others.size() > 1 ? " do not" : " does not") +
                    ": clipped or mapped into the gamut";
}

}  // namespace

constinit const Rule etk107_f0_above_one{
    .id = "ETK107",
    .slug = "f0-above-one",
    .title = "F0 above 1, or cut off there",
    .severity = {Severity::info, Severity::warning},
    .needs = {Need::bytes_b, Need::floats},
    .source = "Hoffman prints gold with red 1.022; glTF refuses F0 above 1",
    .what =
        "Float: a channel above 1; information while the luminance is not above 1 and a metal of the library matches, else an error. 8 bits: a channel (or two) at code 255 on bright coloured F0, which was "
        "clipped or mapped into the gamut by somebody.",
    .why =
        "Gold's red lies outside of linear sRGB, so 1.02 to 1.06 is right there. Anything else above 1 creates energy.",
    .example = "Specular multiplied by an exposure; gold exported to 8 bits, red clipped.",
    .fix = "Bring F0 to at most 1; for gold and copper say which gamut mapping was used.",
    .check = [](RuleCheck& check) {
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
      for (const TileEvidence& tile : check.evidence.tiles) check_codes(check, tile);
    }};

}  // namespace etak
