// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <optional>
#include <string>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

// The channel of a picture that holds metal; none where it holds none.
std::optional<std::size_t> metal_channel(const PictureEvidence& picture) {
  if (!picture.channels.empty()) {
    const std::size_t at = picture.channels.find('m');
    return at < 3 ? std::optional(at) : std::nullopt;
  }
  if (picture.role == FileRole::metallic) return 0;
  return picture.role == FileRole::metal_rough ? std::optional<std::size_t>(2) : std::nullopt;
}

// "as a metal it could be iron (p 0.6)": what the base colour of a plateau is as F0; empty: no material. The plateau's F0 lies
// between a dielectric's and that.
std::string metal_that_it_could_be(const RuleCheck& check, const Plateau& plateau) {
  constexpr double dielectric = 0.04;  // of glTF 2.0
  std::array<double, 3> base{};
  for (std::size_t c = 0; c < 3; ++c)
    base[c] = (plateau.specular[c] - dielectric * (1 - plateau.metallic)) / plateau.metallic;
  const std::string could = known_materials(check.settings).could_be(base, true);
  return could.empty() ? could : "as a metal it " + could;
}

// Metal that is all over a little less than metal: no texel is what a full metal is.
void report_nearly_metal(RuleCheck& check) {
  constexpr int least_full = 250;  // JPEG moves codes by some
  for (const PictureEvidence& picture : check.evidence.headers) {
    const auto channel = picture.data ? metal_channel(picture) : std::nullopt;
    if (!channel) continue;
    const double nearly = picture.data->share(*channel, metal_first_code, least_full - 1);
    if (nearly < 0.05 || picture.data->share(*channel, least_full, 255) > 0.01 * nearly) continue;
    Finding& finding = check.report(picture);
    finding.value = "metallic below " + number(least_full / 255.0, 2);
    finding.limit = "1, of metal";
    finding.message = "metal has metallic of " + number(metal_first_code / 255.0, 2) + " to " +
                      number((least_full - 1) / 255.0, 2) + " on " + percent(nearly) +
                      " of the texels, and 1 nowhere";
  }
}

}  // namespace

constinit const Rule etk113_half_metal{
    .id = "ETK113",
    .slug = "half-metal",
    .title = "Neither metal nor dielectric",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::metal_rough, Need::regions},
    .source = "Khronos glTF 2.0 and Filament: metallic is close to 0 or 1",
    .what =
        "Metal-rough sets: a plateau with metallic between 0.1 and 0.9; or metal on 5 % of the texels or more whose metallic is 0.9 to 0.98, with hardly any of 1.",
    .why =
        "A surface is metal or it is not; the values between are there for filtered edges only and give F0 of the forbidden zone.",
    .example = "Metallic painted at 0.5 for 'semi-metallic' paint.",
    .fix = "Set metallic to 0 or 1; for rust and dirt use a sharp mask.",
    .region = RegionKind::half_metal,
    .check = [](RuleCheck& check) {
      for (const auto& [tile, plateaus] : check.regions(RegionKind::half_metal)) {
        const Plateau& largest = plateaus.largest.front();
        Finding& finding = check.report(tile, plateaus);
        finding.file = check.file_of(FileRole::metal_rough);
        finding.nearest.clear();  // a metallic value is no F0
        finding.value = "metallic " + number(largest.metallic, 2);
        finding.limit = "below 0.1 or above 0.9";
        finding.cause = metal_that_it_could_be(check, largest);
        finding.message = finding.value + " on " + area_text(plateaus.area, tile.counts.texels);
      }
      report_nearly_metal(check);
    }};

}  // namespace etak
