// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/number.h"
#include "core/validate/rules/rows.h"

namespace etak {

namespace {

constexpr RuleParameter etk110_parameters[] = {
    {"deviation", 3, 3, "codes", "largest standard deviation of a channel"},
};

void etk110(RuleCheck& check) {
  std::map<std::string, std::vector<const TileEvidence*>> materials;
  for (const TileEvidence& tile : check.evidence.tiles)
    if (!tile.tile.material.empty() && tile.detail.every_row) materials[tile.tile.material].push_back(&tile);
  for (const auto& [material, tiles] : materials) {
    double most = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      double count = 0, sum = 0, squares = 0;
      for (const TileEvidence* tile : tiles)
        for (std::size_t code = 0; code < 256; ++code) {
          const double texels = tile->detail.b[c][code], value = static_cast<double>(code);
          count += texels;
          sum += texels * value;
          squares += texels * value * value;
        }
      if (count > 0)
        most = std::max(most, std::sqrt(std::max(0.0, squares / count - sum / count * sum / count)));
    }
    if (most <= check.parameter("deviation")) continue;
    Finding& finding = check.report(*tiles.front(), FileRole::specular_gloss);
    finding.value = "standard deviation " + number(most, 2) + " codes";
    finding.limit = number(check.parameter("deviation"), 3) + " codes";
    finding.message = "F0 of \"" + material + "\" varies: " + finding.value;
    if (tiles.size() > 1) finding.message += " over " + std::to_string(tiles.size()) + " tiles";
  }
}

}  // namespace

constinit const Rule etk110_f0_varies{
    "ETK110",
    "f0-varies",
    "F0 varies inside one material",
    Severity::warning,
    Severity::error,
    {Need::bytes_b, Need::named},
    etk110_parameters,
    "Schueler 2009: one F0 per material, the variety belongs into gloss",
    "Where tiles are named: inside one material the standard deviation of some channel of F0 "
    "exceeds 3 codes.",
    "F0 follows from the index of refraction, which does not change with scratches or dirt.",
    "Noise or a photo overlaid on the specular map.",
    "Use one F0 for the material and put the variation into gloss.",
    &etk110};

}  // namespace etak
