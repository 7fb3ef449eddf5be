// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

// How `found` may have come about from `expected`, in all three channels: by the curve applied twice or not
// at all, or with red and blue exchanged; empty: in none of these ways.
std::string cause_of(const CodeTables& tables, const std::array<double, 3>& found,
                     const std::array<double, 3>& expected) {
  double twice = 0, never = 0, exchanged = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const int code = tables.encode(found[c]);
    twice = std::max<double>(twice, std::abs(code - tables.encode(tables.encode(expected[c]) / 255.0)));
    never = std::max(never, std::abs(code - 255 * std::clamp(expected[c], 0.0, 1.0)));
    exchanged = std::max<double>(exchanged, std::abs(code - tables.encode(expected[2 - c])));
  }
  if (exchanged < 4 && exchanged <= std::min(twice, never)) return "red and blue exchanged";
  if (twice < 4 && twice <= never) return "encoded twice";
  return never < 4 ? "stored linear" : "";
}

}  // namespace

constinit const Rule etk112_f0_wrong_material{
    .id = "ETK112",
    .slug = "f0-wrong-material",
    .title = "F0 is not that of the named material",
    .severity = Severity::error,
    .needs = {Need::bytes_b, Need::regions, Need::named},
    .parameters = {{"distance", 3, 3, "codes", "largest channel difference from the nearest dataset"}},
    .source =
        "The material library of etak: titanium spans 0.40 to 0.60 over its datasets, so all of them are compared; bands of new publications (uncertainty.md)",
    .what =
        "The file names a material of the library, and a plateau differs by more than 3 codes from every dataset of it and lies outside of the band that holds nine of ten new publications of it (etak f0 NAME -v). Within 3 codes of another metal's stated F0 the band excuses nothing.",
    .why = "Name and value contradict each other: one of them is wrong.",
    .example = "A tile named gold with the F0 of brass.",
    .fix = "Correct the F0 (etak f0 NAME prints it) or the name.",
    .region = RegionKind::any_f0,
    .check = [](RuleCheck& check) {
      for (const TileEvidence& tile : check.evidence.tiles) {
        const PlateauSummary* plateaus = tile.region(RegionKind::any_f0);
        const std::vector<const KnownF0*> datasets =
            known_materials(check.settings).f0_of(tile.tile.material);
        if (plateaus == nullptr || datasets.empty()) continue;
        std::size_t area = 0;
        const Plateau* shown = nullptr;
        double shown_distance = 0;
        std::optional<NamedBand> shown_band;
        for (const Plateau& plateau : plateaus->largest) {
          double distance = 1e9;
          for (const KnownF0* entry : datasets)
            distance = std::min(distance, code_distance(plateau.specular, *entry, check.settings.transfer));
          const double codes = check.parameter("distance");
          if (distance <= codes) continue;
          const KnownMaterials& known = known_materials(check.settings);
          const TextureTransfer transfer = check.settings.transfer;
          const auto band = known.band_around(tile.tile.material, plateau.specular, transfer, codes);
          if ((band && band->holds) ||
              known.dataset_around(tile.tile.material, plateau.specular, transfer, codes))
            continue;
          area += plateau.area;
          if (shown == nullptr) {
            shown = &plateau;
            shown_distance = distance;
            shown_band = band;
          }
        }
        if (shown == nullptr) continue;
        Finding& finding = check.report(tile, *plateaus, *shown);
        finding.box = shown->box;
        finding.area_px = area;
        finding.limit = number(check.parameter("distance"), 3) + " codes from " + datasets.front()->id;
        finding.message = finding.value + " on " + area_text(area, tile.counts.texels) + ", " +
                          number(shown_distance, 2) + " codes from the nearest dataset of " +
                          datasets.front()->id;
        if (shown_band) finding.message += " (" + words(shown_band->band) + ")";
        // The value of a metal does not tell how it came about. Here the material is named, so that a possible
        // cause can be given.
        for (const KnownF0* entry : datasets) {
          const auto cause = cause_of(check.tables, shown->specular, entry->linear);
          if (cause.empty()) continue;
          finding.cause = "possible cause: " + cause;
          break;
        }
      }
    }};

}  // namespace etak
