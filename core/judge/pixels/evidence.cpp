// SPDX-License-Identifier: Apache-2.0
#include "core/judge/pixels/evidence.h"

#include <algorithm>

namespace etak {

CodeSteps code_steps(const Histogram& codes) {
  std::uint64_t all = 0, below = 0;
  for (const std::uint32_t count : codes) all += count;
  CodeSteps out{-1, -1};
  for (int code = 0; code < 256; ++code) {
    below += codes[static_cast<std::size_t>(code)];
    if (out.first < 0 && 100 * below > all) out.first = code;
    if (out.last < 0 && 100 * below >= 99 * all) out.last = code;
  }
  std::vector<int> steps;
  int before = -1;
  for (int code = out.first; code >= 0 && code <= out.last; ++code) {
    if (codes[static_cast<std::size_t>(code)] == 0) continue;
    ++out.used;
    if (before >= 0) steps.push_back(code - before);
    before = code;
  }
  if (steps.empty()) return out;
  std::ranges::sort(steps);
  out.median_step = steps[steps.size() / 2];
  out.widest_step = steps.back();
  return out;
}

void ByteCounts::add(const ByteCounts& o) {
  if (o.energy_over != 0) {
    energy_box = energy_over == 0 ? o.energy_box : around(energy_box, o.energy_box);
    // Among equal sums the upper, then the left one is kept, so that the number of workers does not matter.
    const bool earlier = o.energy_place[1] < energy_place[1] ||
                         (o.energy_place[1] == energy_place[1] && o.energy_place[0] < energy_place[0]);
    if (o.energy_worst > energy_worst || (o.energy_worst == energy_worst && earlier)) {
      energy_worst = o.energy_worst;
      energy_at = o.energy_at;
      energy_place = o.energy_place;
    }
  }
  texels += o.texels;
  opaque += o.opaque;
  alpha_zero += o.alpha_zero;
  alpha_full += o.alpha_full;
  zone_any += o.zone_any;
  zone_all += o.zone_all;
  black += o.black;
  metals += o.metals;
  energy_over += o.energy_over;
  energy_far_over += o.energy_far_over;
  gloss_zero += o.gloss_zero;
  gloss_full += o.gloss_full;
  gloss_sum += o.gloss_sum;
  gloss_squares += o.gloss_squares;
  gloss_texels += o.gloss_texels;
  gloss_least = std::min(gloss_least, o.gloss_least);
  gloss_most = std::max(gloss_most, o.gloss_most);
  middle += o.middle;
  middle_below += o.middle_below;
  sum_max += o.sum_max;
  sum_alpha += o.sum_alpha;
  sum_max2 += o.sum_max2;
  sum_alpha2 += o.sum_alpha2;
  sum_product += o.sum_product;
}

void Detail::add(const Detail& o) {
  texels += o.texels;
  opaque += o.opaque;
  smooth_a += o.smooth_a;
  smooth_b += o.smooth_b;
  for (std::size_t c = 0; c < 4; ++c)
    for (std::size_t i = 0; i < 256; ++i) {
      a[c][i] += o.a[c][i];
      b[c][i] += o.b[c][i];
    }
}

DarkValues dark_values(const std::array<Histogram, 4>& picture) {
  const std::array<bool, 101>& comb = comb_codes();
  std::array<std::uint64_t, 101> counts{};
  std::uint64_t all = 0;
  for (std::size_t code = 0; code < counts.size(); ++code) {
    for (std::size_t c = 0; c < 3; ++c) counts[code] += picture[c][code];
    all += counts[code];
  }
  DarkValues out;
  for (std::size_t code = 0; code < counts.size(); ++code) {
    if (counts[code] == 0 || 4 * counts[code] > all) continue;
    out.count += counts[code];
    if (comb[code]) out.in_comb += counts[code];
    ++out.codes;
  }
  return out;
}

const PlateauSummary* TileEvidence::region(RegionKind kind) const {
  const auto found = std::find(kinds.begin(), kinds.end(), kind);
  return found == kinds.end() ? nullptr : &regions[static_cast<std::size_t>(found - kinds.begin())];
}

double DataCodes::share(std::size_t channel, int first, int last) const {
  std::uint64_t count = 0;
  for (int code = first; code <= last; ++code) count += codes[channel][static_cast<std::size_t>(code)];
  return texels == 0 ? 0 : static_cast<double>(count) / static_cast<double>(texels);
}

}  // namespace etak
