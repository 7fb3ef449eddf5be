// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>
#include <utility>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

// Whether a plateau is half metal, which ETK113 reports: ETK101 gives at most a warning for it.
bool is_half_metal(const RuleCheck& check, const Plateau& plateau) {
  return check.evidence.metal_rough && plateau.metallic > half_metal_above && plateau.metallic < metal_from;
}

// Share of the opaque texels whose F0 is that of ordinary dielectrics.
double ordinary_share(const TileEvidence& tile) {
  std::uint64_t others = tile.counts.metals;
  for (const RegionKind kind : {RegionKind::zone, RegionKind::gem, RegionKind::f0_low, RegionKind::f0_zero})
    if (const PlateauSummary* found = tile.region(kind)) others += found->masked;
  if (tile.counts.opaque == 0 || others >= tile.counts.opaque) return 0;
  return static_cast<double>(tile.counts.opaque - others) / static_cast<double>(tile.counts.opaque);
}

// Whether most texels of a plateau have codes next to its mean. Of a wide gradient the mean alone matches anything.
bool is_flat(const RuleCheck& check, const TileEvidence& tile, const Plateau& plateau) {
  constexpr int near = 4;  // codes
  const int green = check.bytes(plateau.specular)[1];
  std::uint64_t beside = 0;
  for (int code = std::max(0, green - near); code <= std::min(255, green + near); ++code)
    beside += tile.detail.b[1][static_cast<std::size_t>(code)];
  return 2 * static_cast<double>(beside) * static_cast<double>(tile.counts.texels) >=
         static_cast<double>(plateau.area) * static_cast<double>(tile.detail.opaque);
}

struct PlateauVerdict {
  Severity severity;
  std::string reason;  // why it is no error; empty: it is one
};

// "; no error, because it is within 3 codes of graphite, which is common (2 publications; ...)".
std::string softened_by(const KnownF0& common, bool near, double codes) {
  return "; no error, because it " +
         (near ? "is within " + number(codes, 2) + " codes of " + common.id
               : "lies where half of new publications of " + common.id + " would") +
         ", which is common" + (common.band ? " (" + words(*common.band) + ")" : "");
}

// The severity of a plateau. A common material of the zone at that colour lowers an error to a warning; a
// material that the file names lowers it to information.
PlateauVerdict verdict_on(const RuleCheck& check, const TileEvidence& tile, const Plateau& plateau) {
  if (is_half_metal(check, plateau)) return {check.at_most(Severity::warning), {}};
  const ZoneSettings& zone = check.settings.zone;
  const KnownMaterials& known = known_materials(check.settings);
  const double codes = check.parameter("match_bytes");
  const TextureTransfer transfer = check.settings.transfer;
  const auto is_in_zone = [&](double luminance) { return luminance > zone.low && luminance < zone.high; };
  if (const auto own = known.dataset_around(tile.tile.material, plateau.specular, transfer, codes);
      own && is_in_zone(own->luminance))
    return {check.at_most(Severity::info), "; information: " + dataset_in_zone(*own)};
  if (const auto band = known.band_around(tile.tile.material, plateau.specular, transfer, codes);
      band && band->holds)
    return {check.at_most(Severity::info), "; information, because it lies in the band of " +
                                               tile.tile.material + " (" + words(band->band) + ")"};
  double nearest = 255;
  PlateauVerdict out{check.severity(), {}};
  for (const KnownF0& entry : known.f0()) {
    // Only common ones count, by their preferred dataset: all datasets together would excuse a fifth of the greys.
    if (!is_in_zone(entry.luminance) || !entry.preferred || !entry.common) continue;
    const double distance = code_distance(plateau.specular, entry, transfer);
    const bool near = distance <= codes;
    if (distance >= nearest || !(near || in_half_band(plateau.specular, entry))) continue;
    nearest = distance;
    out = {check.at_most(Severity::warning), softened_by(entry, near, codes)};
  }
  return out;
}

}  // namespace

constinit const Rule etk101_f0_forbidden_zone{
    .id = "ETK101",
    .slug = "f0-forbidden-zone",
    .title = "F0 lies where no common material is",
    .severity = Severity::error,
    .needs = {Need::bytes_b, Need::regions},
    .parameters = {{"match_bytes", 3, 3, "codes",
                    "distance at which a plateau counts as a material of the library"},
                   {"error_share", 0.01, 0.01, "%",
                    "share of the tile's texels below which plateaus are at most a warning"}},
    .source =
        "Hoffman, \"Crafting Physically Motivated Shading Models\"; MoonRay calls conductors below 0.4564 invalid; thresholds of the region analysis measured on synthetic edges (etak)",
    .what =
        "A plateau of F0 with luminance between the zone's limits, 0.20 and 0.45 (sRGB codes 125 to 177 for greys). A warning where the colour is within 3 codes of a common material of the library that lies "
        "in the zone itself (silicon, graphite, hematite, titanium nitride), or where half of its new publications would lie (of three known ones or more), information when the file names a material and the colour is that of a dataset in the zone, or lies in the band that holds nine of ten new publications of the material and within 3 codes of no other metal's stated F0, and a warning where a metal-rough set is half "
        "metal (ETK113). Plateaus of less than 0.01 % of a tile's texels are at most a warning. The F0 that a project takes from a cited record is measured and no mistake: it is information, which names the other datasets. Regions, not texels: what filtering makes of an edge between metal and dielectric is left to ETK102. The smallest region is 32 texels and 0.001 % of the tile: a first limit of 0.01 "
        "% would have hidden a patch of 10 x 10 in a tile of 1024 x 1024. Codes are rounded: what lies within half a code of a limit (0.0028 at 0.45, 0.0018 at 0.20) counts as outside, such as Hoffman's "
        "0.200, code 124, and indium antimonide, 0.4492.",
    .why =
        "Dielectrics reflect 2 to 5 %, gems up to 17 %, metals half or more. Between lie only semiconductors and a few compounds.",
    .example =
        "Plastic of F0 0.04 encoded to sRGB twice reads as 0.22; a 50 % grey specular map reads as 0.21.",
    .fix =
        "Decide whether the surface is metal or not; re-export without a second sRGB conversion; or name the material.",
    .region = RegionKind::zone,
    .check = [](RuleCheck& check) {
      const ZoneSettings& zone = check.settings.zone;
      for (const auto& [tile, plateaus] : check.regions(RegionKind::zone)) {
        const Plateau* shown = nullptr;
        PlateauVerdict worst{Severity::off, {}};
        for (const Plateau& plateau : plateaus.largest) {
          PlateauVerdict verdict = verdict_on(check, tile, plateau);
          if (verdict.severity <= worst.severity) continue;
          worst = std::move(verdict);
          shown = &plateau;
        }
        Finding& finding = check.report(tile, plateaus, *shown);
        const bool few = 100 * finding.area_share < check.parameter("error_share");
        finding.severity = few ? std::min(worst.severity, check.at_most(Severity::warning)) : worst.severity;
        finding.limit = percent(zone.low) + " to " + percent(zone.high);
        const Explanation why =
            explain_f0(known_materials(check.settings), shown->specular, check.settings.transfer);
        if (is_half_metal(check, *shown)) {
          finding.cause = "metallic is " + number(shown->metallic, 2);
          finding.message += "; " + finding.cause;
        } else if (why.cause == Explanation::Cause::doubled && !check.evidence.metal_rough &&
                   is_flat(check, tile, *shown)) {
          finding.cause = "matches a dielectric of F0 " + number(why.original, 2) + " (" + why.material +
                          ") sRGB-encoded twice, within " + number(why.distance, 2) + " codes";
          // Beside ordinary dielectrics it may be a patch instead of a second conversion, and the middle of the scale
          // may be a number that is no F0.
          const bool middle = is_middle_grey(check.bytes(shown->specular)),
                     patch = ordinary_share(tile) > 0.1;
          if (middle)
            finding.cause +=
                "; or the middle of the scale of an input that is no F0, as Unreal's Specular (0.5 there is F0 0.04)";
          if (middle || patch) finding.cause = "possible cause: " + finding.cause;
          if (middle || !patch) finding.message += "; " + finding.cause;
        } else if (worst.severity > Severity::info) {
          finding.cause = known_materials(check.settings).could_be(shown->specular);
        }
        if (few && worst.severity > finding.severity)
          finding.message += "; no error, because it is less than " +
                             number(check.parameter("error_share"), 2) + " % of the texels";
        finding.message += worst.reason;
      }
    }};

}  // namespace etak
