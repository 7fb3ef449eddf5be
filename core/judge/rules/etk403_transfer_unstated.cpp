// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk403_transfer_unstated{
    .id = "ETK403",
    .slug = "transfer-unstated",
    .title = "The codes look like a power of 2.2",
    .severity = {Severity::info, Severity::warning},
    .needs = {Need::bytes_b, Need::regions, Need::named},
    .source = "Schueler's table (exponent 1/2.2) against Hoffman's (sRGB): 0.02 is code 44 or 39",
    .what =
        "No transfer function was stated, and the plateaus of at least two named dielectrics lie nearer to the table of exponent 1/2.2 than to that of sRGB.",
    .why = "The two differ by up to 5 codes in the range of dielectrics.",
    .example = "Codes copied from an article that uses a plain power.",
    .fix = "State transfer = \"power-2.2\", or re-encode.",
    .check = [](RuleCheck& check) {
      if (check.settings.transfer_stated || check.target.manifest.transfer ||
          check.settings.transfer != TextureTransfer::srgb)
        return;
      std::size_t power = 0, srgb = 0;
      for (const TileEvidence& tile : check.evidence.tiles) {
        const PlateauSummary* plateaus = tile.region(RegionKind::any_f0);
        const auto datasets = known_materials(check.settings).f0_of(tile.tile.material);
        if (plateaus == nullptr || plateaus->regions == 0 || datasets.empty() || datasets.front()->conductor)
          continue;
        const double code = check.tables.encode(luminance_of(plateaus->largest.front().specular));
        double to_srgb = 1e9, to_power = 1e9;
        for (const KnownF0* entry : datasets) {
          to_srgb = std::min<double>(
              to_srgb, std::abs(code - code_tables(TextureTransfer::srgb).encode(entry->luminance)));
          to_power = std::min<double>(
              to_power, std::abs(code - code_tables(TextureTransfer::power_22).encode(entry->luminance)));
        }
        power += to_power < to_srgb;
        srgb += to_srgb < to_power;
      }
      if (power < 2 || power <= srgb) return;
      Finding& finding = check.report();
      finding.value = std::to_string(power) + " dielectrics";
      finding.message = std::to_string(power) + " named dielectrics have the codes of exponent 1/2.2, " +
                        std::to_string(srgb) + " those of sRGB";
    }};

}  // namespace etak
