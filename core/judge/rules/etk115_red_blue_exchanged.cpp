// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

// The metal whose colour this is with red and blue exchanged; null: there is none, or the colour is that of a
// material as it is.
const KnownF0* exchanged_metal(const RuleCheck& check, const std::array<double, 3>& f0, double& distance) {
  const std::array<double, 3> exchanged{f0[2], f0[1], f0[0]};
  const KnownF0* metal = nullptr;
  distance = check.parameter("match_bytes");
  for (const KnownF0& entry : known_materials(check.settings).f0()) {
    if (code_distance(f0, entry, check.settings.transfer) <= check.parameter("apart")) return nullptr;
    if (!entry.conductor) continue;
    const double d = code_distance(exchanged, entry, check.settings.transfer);
    if (d > distance || (metal != nullptr && d == distance)) continue;
    metal = &entry;
    distance = d;
  }
  return metal;
}

}  // namespace

constinit const Rule etk115_red_blue_exchanged{
    .id = "ETK115",
    .slug = "red-blue-exchanged",
    .title = "A metal with red and blue exchanged",
    .severity = Severity::warning,
    .needs = {Need::bytes_b, Need::regions},
    .parameters = {{"match_bytes", 6, 6, "codes",
                    "distance at which the exchanged colour counts as a metal of the library"},
                   {"apart", 12, 12, "codes",
                    "least difference of blue and red, and least distance as it is from a material"}},
    .source = "The material library of etak, none of whose metals is reported as it is",
    .what =
        "A plateau of metal whose blue is more than 12 codes above its red, further than 12 codes from every material of the library, and within 6 codes of a metal once red and blue are exchanged. Where the "
        "file names a material of the library, ETK112 says it.",
    .why =
        "Coloured metals are yellow, red or brown: they reflect less of blue light. Next to none reflects less of red light.",
    .example = "A loader that takes BGR for RGB: gold comes out as light blue.",
    .fix = "Exchange the two channels on export, or name the material if the colour is meant.",
    .region = RegionKind::blue_metal,
    .check = [](RuleCheck& check) {
      for (const auto& [tile, plateaus] : check.regions(RegionKind::blue_metal)) {
        // Where the file names a material, ETK112 says that the colour is not its own, and why.
        if (!known_materials(check.settings).f0_of(tile.tile.material).empty()) continue;
        std::size_t area = 0;
        const Plateau* shown = nullptr;
        const KnownF0* metal = nullptr;
        double distance = 0;
        for (const Plateau& plateau : plateaus.largest) {
          double d = 0;
          const KnownF0* found = exchanged_metal(check, plateau.specular, d);
          if (found == nullptr) continue;
          area += plateau.area;
          if (shown != nullptr) continue;
          shown = &plateau;
          metal = found;
          distance = d;
        }
        if (shown == nullptr) continue;
        Finding& finding = check.report(tile, plateaus, *shown);
        finding.box = shown->box;
        finding.area_px = area;
        finding.limit = "no metal with red and blue exchanged";
        finding.cause = "possible cause: red and blue exchanged; then it is " + metal->id + ", within " +
                        number(distance, 2) + " codes";
        finding.message = finding.value + " on " + area_text(area, tile.counts.texels);
      }
    }};

}  // namespace etak
