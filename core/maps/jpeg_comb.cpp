// SPDX-License-Identifier: Apache-2.0
#include "core/maps/jpeg_comb.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/random.h"
#include "core/math/functions.h"

namespace etak {

namespace {

constexpr std::size_t block_side = 8;

// The frequencies that hold most of a smooth picture, across and down.
constexpr std::array<std::array<std::size_t, 2>, 8> low_frequencies{
    {{1, 0}, {0, 1}, {1, 1}, {2, 0}, {0, 2}, {2, 1}, {1, 2}, {2, 2}}};

// Rows 0 to 2 of the orthonormal cosine transform.
const std::array<std::array<float, block_side>, 3>& cosines() {
  static const auto table = [] {
    std::array<std::array<float, block_side>, 3> out{};
    for (std::size_t u = 0; u < out.size(); ++u)
      for (std::size_t x = 0; x < block_side; ++x)
        out[u][x] = static_cast<float>(
            (u == 0 ? std::sqrt(0.125) : 0.5) *
            math::cos((2.0 * static_cast<double>(x) + 1) * static_cast<double>(u) * std::numbers::pi / 16));
    return out;
  }();
  return table;
}

}  // namespace

void JpegCombSearch::add_block(const std::uint8_t* rgba, std::size_t stride, bool aligned) {
  Grid& grid = grids_[aligned ? 0 : 1];
  const auto& basis = cosines();
  std::array<std::array<float, 3>, block_side> rows{};
  std::uint64_t hash = 0;
  for (std::size_t y = 0; y < block_side; ++y) {
    const std::uint8_t* texel = rgba + y * stride;
    for (std::size_t x = 0; x < block_side; ++x, texel += 4) {
      // The weights of JFIF's Y.
      const int luma = 299 * texel[0] + 587 * texel[1] + 114 * texel[2];
      hash = SplitMix::mixed(hash + static_cast<std::uint64_t>(luma) + 1);
      const float value = static_cast<float>(luma) / 1000;
      for (std::size_t u = 0; u < 3; ++u) rows[y][u] += basis[u][x] * value;
    }
  }
  if (!grid.seen.insert(hash).second) return;
  for (std::size_t i = 0; i < frequencies; ++i) {
    const auto [u, v] = low_frequencies[i];
    float coefficient = 0;
    for (std::size_t y = 0; y < block_side; ++y) coefficient += basis[v][y] * rows[y][u];
    const auto bin = std::lround(coefficient * bins_a_code) + bins_a_code * most_code;
    if (bin >= 0 && static_cast<std::size_t>(bin) < grid.bins[i].size())
      ++grid.bins[i][static_cast<std::size_t>(bin)];
  }
}

JpegComb JpegCombSearch::comb_of(const Grid& grid) {
  constexpr int least_step = 2, most_step = 24;
  constexpr double least_count = 40;
  double sum = 0, weight = 0, lowest_step = 0;
  for (const Bins& bins : grid.bins) {
    double best = 0, best_count = 0;
    int best_step = 0;
    for (int step = least_step; step <= most_step; ++step) {
      // Values that were rounded to 0 say nothing: everything small is near 0.
      const int first = bins_a_code * step / 2 + 1;
      double agreement = 0, count = 0;
      for (int i = first; i <= bins_a_code * most_code; ++i) {
        const auto middle = static_cast<std::size_t>(bins_a_code) * most_code,
                   away = static_cast<std::size_t>(i);
        const double both = bins[middle + away] + bins[middle - away];
        if (both == 0) continue;
        count += both;
        agreement += both * math::cos(2 * std::numbers::pi * i / (bins_a_code * step));
      }
      // The largest step is taken: its divisors fit as well.
      if (count < least_count || agreement / count < best - 0.02) continue;
      best = std::max(best, agreement / count);
      best_count = count;
      best_step = step;
    }
    sum += best * best_count;
    weight += best_count;
    if (lowest_step == 0) lowest_step = best_step;
  }
  return weight > 0 ? JpegComb{lowest_step, sum / weight} : JpegComb{};
}

std::optional<JpegComb> JpegCombSearch::finish() const {
  constexpr double least_score = 0.3, least_lead = 0.2;
  const JpegComb aligned = comb_of(grids_[0]), aside = comb_of(grids_[1]);
  if (aligned.score < least_score || aligned.score < aside.score + least_lead) return std::nullopt;
  return aligned;
}

}  // namespace etak
