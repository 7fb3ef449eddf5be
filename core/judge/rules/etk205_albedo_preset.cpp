// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

struct AlbedoBand {
  std::string_view name;
  double low, high;
};
constexpr AlbedoBand bands[] = {
    {"black-paint", 0.03, 0.07}, {"dark-soil", 0.05, 0.14}, {"worn-asphalt", 0.10, 0.15},
    {"dry-clay", 0.15, 0.35},    {"grass", 0.16, 0.26},     {"old-concrete", 0.17, 0.30},
    {"red-tile", 0.23, 0.33},    {"dry-sand", 0.20, 0.45},  {"new-concrete", 0.32, 0.55},
    {"white-paint", 0.75, 0.85}, {"snow", 0.85, 0.95}};

}  // namespace

constinit const Rule etk205_albedo_preset{
    .id = "ETK205",
    .slug = "albedo-preset",
    .title = "Albedo outside of the named surface's band",
    .severity = {Severity::off, Severity::warning},
    .needs = {Need::bytes_a, Need::named},
    .source = "Albedo bands of Unity's material charts",
    .what =
        "The file names a class of surface, and the mean diffuse luminance lies outside of its band: black-paint 0.03-0.07, dark-soil 0.05-0.14, worn-asphalt 0.10-0.15, dry-clay 0.15-0.35, grass "
        "0.16-0.26, old-concrete 0.17-0.30, red-tile 0.23-0.33, dry-sand 0.20-0.45, new-concrete 0.32-0.55, white-paint 0.75-0.85, snow 0.85-0.95.",
    .why = "Scenes of assets from many hands agree in exposure only when their albedos do.",
    .example = "Concrete painted from a photograph taken in shadow.",
    .fix = "Scale the diffuse texture so that its mean lies in the band.",
    .check = [](RuleCheck& check) {
      for (const TileEvidence& tile : check.evidence.tiles) {
        const auto* band = std::find_if(std::begin(bands), std::end(bands), [&](const AlbedoBand& b) {
          return b.name == tile.tile.surface_class;
        });
        if (band == std::end(bands) || tile.detail.opaque == 0) continue;
        std::array<double, 3> mean{};
        for (std::size_t c = 0; c < 3; ++c)
          for (std::size_t code = 0; code < 256; ++code)
            mean[c] +=
                tile.detail.a[c][code] * check.tables.decoded[code] / static_cast<double>(tile.detail.opaque);
        const double luminance = luminance_of(mean);
        if (luminance >= band->low && luminance <= band->high) continue;
        Finding& finding = check.report(tile, FileRole::diffuse_alpha);
        finding.linear = mean;
        finding.byte = check.bytes(mean);
        finding.luminance = luminance;
        finding.value = "mean albedo " + number(luminance, 3);
        finding.limit = number(band->low, 3) + " to " + number(band->high, 3);
        finding.message = finding.value + ", " + std::string(band->name) + " has " + finding.limit;
      }
    }};

}  // namespace etak
