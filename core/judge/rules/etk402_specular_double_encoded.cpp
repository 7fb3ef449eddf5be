// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

// Share of the texels darker than metals whose green has the codes of dielectrics encoded twice. A plateau is
// judged by its mean, which tells nothing of a wide gradient.
double doubled_share(const RuleCheck& check, const TileEvidence& tile) {
  const Histogram& green = tile.detail.b[1];
  const int metal = check.tables.encode(check.settings.zone.high);
  std::uint64_t below = 0, doubled = 0;
  for (int code = 0; code < metal; ++code) {
    const std::uint64_t count = green[static_cast<std::size_t>(code)];
    below += count;
    if (doubled_dielectric_codes.holds(code)) doubled += count;
  }
  return below == 0 ? 0 : static_cast<double>(doubled) / static_cast<double>(below);
}

// Whether the codes are those of the material that the file names, or of a gem.
bool is_gem(const RuleCheck& check, const TileEvidence& tile, const Plateau& plateau) {
  const KnownMaterials& known = known_materials(check.settings);
  const auto within = [&](const KnownF0& entry, double codes) {
    return code_distance(plateau.specular, entry, check.settings.transfer) <= codes;
  };
  for (const KnownF0* entry : known.f0_of(tile.tile.material))
    if (within(*entry, check.parameter("named_codes"))) return true;
  return std::ranges::any_of(known.f0(), [&](const KnownF0& entry) {
    return entry.preferred && entry.gem && entry.luminance > most_dielectric_f0 &&
           within(entry, check.parameter("gem_codes"));
  });
}

}  // namespace

constinit const Rule etk402_specular_double_encoded{
    .id = "ETK402",
    .slug = "specular-double-encoded",
    .title = "F0 was encoded to sRGB twice",
    .severity = Severity::error,
    .needs = {Need::bytes_a, Need::bytes_b, Need::regions},
    .parameters = {{"share", 80, 80, "%", "of the achromatic non-metal plateau area, and of the texels"},
                   {"named_codes", 3, 3, "codes",
                    "distance at which the material that the file names explains a plateau"},
                   {"gem_codes", 0.5, 0.5, "codes",
                    "distance at which a gem of the library explains a plateau"}},
    .source =
        "Leave-one-out over 109 materials: 95 % of dielectrics recognised; 0.04 reads as 0.221, and 47 of 77 dielectrics land in the forbidden zone (etak)",
    .what =
        "At least 80 % of the area of achromatic non-metal plateaus has codes 105 to 155, whose second decoding is an ordinary dielectric F0 of 0.017 to 0.09, and so have 80 % of the texels darker than "
        "metals (a wide ramp has their mean only). Plateaus over black diffuse are not judged: a grey metal stored linear has the same codes. A warning where there is no diffuse picture, and where all of it "
        "lies below the forbidden zone, or is the grey 127 or 128 that many scales begin with: F0 0.02 to 0.03 encoded twice has the codes 109 to 120. Plateaus that the material which the file names explains, or whose three codes are those of a gem (diamond: 115 115 117), are not counted.",
    .why = "One conversion too many in the export chain.",
    .example = "An sRGB texture read as linear and encoded on writing.",
    .fix = "Remove one of the two conversions.",
    .region = RegionKind::any_f0,
    .check = [](RuleCheck& check) {
      const double gems_end = check.tables.moved(check.settings.zone.low, half_a_code);
      for (const TileEvidence& tile : check.evidence.tiles) {
        const PlateauSummary* plateaus = tile.region(RegionKind::any_f0);
        if (plateaus == nullptr || plateaus->regions == 0 ||
            check.settings.transfer == TextureTransfer::linear)
          continue;
        std::size_t grey = 0, doubled = 0;
        const Plateau* shown = nullptr;
        const bool has_diffuse = check.evidence.a.has_value();
        bool above_gems = false;
        for (const Plateau& plateau : plateaus->largest) {
          const auto codes = check.bytes(plateau.specular);
          const int spread =
              *std::max_element(codes.begin(), codes.end()) - *std::min_element(codes.begin(), codes.end());
          if (spread > 4 || luminance_of(plateau.specular) >= check.settings.zone.high) continue;
          grey += plateau.area;
          if (!doubled_dielectric_codes.holds(check.tables.encode(luminance_of(plateau.specular)))) continue;
          if (has_diffuse && luminance_of(plateau.diffuse) <= 0.004) continue;
          if (is_gem(check, tile, plateau)) continue;
          doubled += plateau.area;
          above_gems = above_gems || luminance_of(plateau.specular) > gems_end;
          if (shown == nullptr) shown = &plateau;
        }
        if (shown == nullptr ||
            100.0 * static_cast<double>(doubled) < check.parameter("share") * static_cast<double>(grey) ||
            100 * doubled_share(check, tile) < check.parameter("share"))
          continue;
        const double meant = check.tables.decode(255 * luminance_of(shown->specular));
        if (meant < least_dielectric_f0 || meant > most_dielectric_f0) continue;
        Finding& finding = check.report(tile, *plateaus, *shown);
        const bool middle = is_middle_grey(check.bytes(shown->specular));
        const bool sure = has_diffuse && above_gems && !middle;
        if (!sure) finding.severity = check.at_most(Severity::warning);
        finding.box = shown->box;
        finding.area_px = doubled;
        finding.limit = "codes 36 to 84";
        finding.cause = std::string(sure ? "" : "possible cause: ") +
                        "encoded twice; decoded once more it is F0 " + number(meant, 2) +
                        (middle ? ", or the middle of the scale of an input that is no F0" : "");
        finding.message =
            finding.value + " on " + area_text(doubled, tile.counts.texels) + "; " + finding.cause;
      }
    }};

}  // namespace etak
