// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

// Tells of a tile that nobody has named and whose dielectrics have two values of F0.
void tell_two_values(RuleCheck& check, const TileEvidence& tile) {
  const Histogram& green = tile.detail.b[1];
  const int first = dielectric_codes.first, end = check.tables.first_code_at_least(first_above(
                                                check.tables.moved(check.settings.zone.low, half_a_code)));
  const int reach = static_cast<int>(check.parameter("deviation"));
  // The texels within `reach` codes of one.
  const auto around = [&](int code) {
    std::uint64_t sum = 0;
    for (int c = std::max(first, code - reach); c <= code + reach && c < end; ++c)
      sum += green[static_cast<std::size_t>(c)];
    return sum;
  };
  std::array<int, 2> code{-1, -1};
  std::array<std::pair<std::uint64_t, std::uint32_t>, 2> most{};  // around the code, and of the code itself
  for (const std::size_t which : {0u, 1u})
    for (int c = first; c < end; ++c) {
      const std::pair here{around(c), green[static_cast<std::size_t>(c)]};
      if (here <= most[which] || (which == 1 && std::abs(c - code[0]) <= 2 * reach)) continue;
      code[which] = c;
      most[which] = here;
    }
  const double share = 100.0 * static_cast<double>(most[1].first) / static_cast<double>(tile.detail.opaque);
  if (code[1] < 0 || share < check.parameter("share")) return;
  Finding& finding = check.report(tile, FileRole::specular_gloss);
  finding.severity = check.at_most(Severity::info);
  std::ranges::sort(code);
  finding.value = "codes " + std::to_string(code[0]) + " and " + std::to_string(code[1]);
  finding.limit = number(check.parameter("deviation"), 3) + " codes";
  finding.message = "F0 of what is no metal has two values, " + finding.value +
                    ", and no name or mask tells the materials apart";
}

}  // namespace

constinit const Rule etk110_f0_varies{
    .id = "ETK110",
    .slug = "f0-varies",
    .title = "F0 varies inside one material",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::bytes_b},
    .parameters = {{"deviation", 3, 3, "codes", "largest standard deviation of a channel"},
                   {"share", 5, 5, "%", "of an unnamed tile from which on a second value is told"}},
    .source = "Schueler 2009: one F0 per material, the variety belongs into gloss",
    .what =
        "Where tiles are named: inside one material the standard deviation of some channel of F0 exceeds 3 codes. Where nothing names the materials of a tile it is information: what is no metal has two "
        "values of F0, each on 5 % of the texels or more and further than 6 codes from the other. Name the materials (--material, tiles of a manifest) to have each judged by itself.",
    .why = "F0 follows from the index of refraction, which does not change with scratches or dirt.",
    .example = "Noise or a photo overlaid on the specular map.",
    .fix = "Use one F0 for the material and put the variation into gloss.",
    .check = [](RuleCheck& check) {
      std::map<std::string, std::vector<const TileEvidence*>> materials;
      for (const TileEvidence& tile : check.evidence.tiles)
        if (!tile.tile.material.empty()) {
          if (tile.detail.every_row) materials[tile.tile.material].push_back(&tile);
        } else if (tile.detail.opaque > 0 && !check.evidence.metal_rough) {
          tell_two_values(check, tile);
        }
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
    }};

}  // namespace etak
