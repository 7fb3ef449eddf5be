// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

// Largest directional albedo of the model over the angles, by F0 (rows) and gloss (columns);
// tests/core/judge/test_rules.cpp computes it again from the model.
constexpr double f0_rows[] = {0.02, 0.04, 0.08, 0.2, 0.5, 1.0};
constexpr double gloss_columns[] = {0, 0.25, 0.5, 0.75, 1};
constexpr double albedo[6][5] = {{0.033, 0.063, 0.109, 0.167, 0.220}, {0.066, 0.127, 0.217, 0.334, 0.439},
                                 {0.132, 0.249, 0.421, 0.635, 0.848}, {0.287, 0.509, 0.730, 0.890, 0.990},
                                 {0.481, 0.722, 0.833, 0.959, 0.991}, {0.539, 0.741, 0.954, 0.994, 0.999}};

// The albedo of the table, bilinear; below the first row it is proportional to F0.
double specular_albedo(double f0, double gloss) {
  const double g = std::clamp(gloss, 0.0, 1.0) * 4;
  const auto column = static_cast<std::size_t>(std::min(3.0, g));
  const double right = g - static_cast<double>(column);
  const auto at = [&](std::size_t row) {
    return albedo[row][column] * (1 - right) + albedo[row][column + 1] * right;
  };
  if (f0 <= f0_rows[0]) return at(0) * std::max(0.0, f0) / f0_rows[0];
  const double clamped = std::min(f0, 1.0);
  std::size_t row = 0;
  while (row + 2 < std::size(f0_rows) && clamped > f0_rows[row + 1]) ++row;
  const double down = (clamped - f0_rows[row]) / (f0_rows[row + 1] - f0_rows[row]);
  return at(row) * (1 - down) + at(row + 1) * down;
}

}  // namespace

constinit const Rule etk206_model_gains_energy{
    .id = "ETK206",
    .slug = "model-gains-energy",
    .title = "The shading model gains energy with these values",
    .severity = {Severity::info, Severity::warning},
    .needs = {Need::bytes_a, Need::bytes_b},
    .parameters = {{"limit", 1.001, 1.001, "", "largest directional albedo"}},
    .source =
        "Directional albedo of etak's default model (Schueler's Optimized, bounded) at 0, 60, 80 and 85 degrees, integrated once; TU Graz lecture: the integral is at most 1",
    .what =
        "The mean diffuse colour of a tile plus the model's specular albedo at the tile's mean F0 and gloss exceeds 1.001 for some angle.",
    .why =
        "Adding diffuse and specular without weighing one by the other gains energy at grazing angles. It speaks of the model, not of the artist.",
    .example = "White glossy plastic: 0.9 diffuse plus 0.44 specular albedo at 85 degrees.",
    .fix = "Use a model that weighs diffuse by what specular leaves, or darker diffuse.",
    .check = [](RuleCheck& check) {
      if (check.target.manifest.specular_weighs_diffuse) return;
      for (const TileEvidence& tile : check.evidence.tiles) {
        const Detail& d = tile.detail;
        if (d.opaque == 0) continue;
        double gloss = 0, worst = 0, diffuse_shown = 0, specular_shown = 0;
        for (std::size_t code = 0; code < 256; ++code)
          gloss += d.b[3][code] * static_cast<double>(code) / 255;
        gloss /= static_cast<double>(d.opaque);
        for (std::size_t c = 0; c < 3; ++c) {
          double diffuse = 0, f0 = 0;
          for (std::size_t code = 0; code < 256; ++code) {
            diffuse += d.a[c][code] * check.tables.decoded[code];
            f0 += d.b[c][code] * check.tables.decoded[code];
          }
          diffuse /= static_cast<double>(d.opaque);
          f0 /= static_cast<double>(d.opaque);
          const double specular = specular_albedo(f0, gloss);
          if (diffuse + specular <= worst) continue;
          worst = diffuse + specular;
          diffuse_shown = diffuse;
          specular_shown = specular;
        }
        if (worst <= check.parameter("limit")) continue;
        Finding& finding = check.report(tile, FileRole::specular_gloss);
        finding.value = "albedo " + number(worst, 3);
        finding.limit = number(check.parameter("limit"), 4);
        finding.message = "mean diffuse " + number(diffuse_shown, 2) + " and the model's specular albedo " +
                          number(specular_shown, 2) + " at gloss " + number(gloss, 2) + " come to " +
                          number(worst, 3) + " at a grazing view";
      }
    }};

}  // namespace etak
