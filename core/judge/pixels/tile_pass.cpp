// SPDX-License-Identifier: Apache-2.0
#include "core/judge/pixels/tile_pass.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <tuple>

namespace etak {

namespace {

constexpr int fringe_reach = 2;        // texels
constexpr int fringe_difference = 16;  // codes
constexpr int rows_between_samples = 16;
constexpr int always_sampled_height = 64;

template <class Act>
void each_bit(std::uint64_t bits, Act act) {
  for (; bits != 0; bits &= bits - 1) act(std::countr_zero(bits));
}

// For each level of Y, which of 64 texels are at or above it.
struct LevelBits {
  std::uint64_t b_from[ByteLimits::b_levels], a_from[ByteLimits::a_levels];
};

// Which of 64 texels have some metallic, are half metal, or metal. In a metal-rough set the F0 of texels that
// are not quite dielectric comes from the base colour, and metallic makes their diffuse black. Rules 113 and
// 114 judge metallic; the other rules judge dielectric texels only.
struct MetallicBits {
  std::uint64_t some = 0, half = 0, full = 0;
};

MetallicBits metallic_bits(std::uint64_t opaque, const RowPointers& row, int x0) {
  MetallicBits out;
  if (row.metallic == nullptr) return out;
  each_bit(opaque, [&](int i) {
    const std::uint8_t code = row.metallic[4 * (x0 + i)];
    out.some |= std::uint64_t{code > 0} << i;
    out.half |= std::uint64_t{code >= half_metal_first_code && code < metal_first_code} << i;
    out.full |= std::uint64_t{code >= metal_first_code} << i;
  });
  return out;
}

// The texels of a word that meet the condition of a kind.
std::uint64_t bits_of_kind(RegionKind kind, const MaskWords& m, const LevelBits& y,
                           const MetallicBits& metallic, bool has_b) {
  const std::uint64_t below_zone = ~y.b_from[b_zone];
  const std::uint64_t dielectric = below_zone & ~(metallic.half | metallic.full);
  switch (kind) {
    case RegionKind::zone:
      return y.b_from[b_zone] & ~y.b_from[b_metal];
    case RegionKind::f0_low:
      return ~y.b_from[b_low] & ~m.nearly_black;
    case RegionKind::f0_zero:
      return m.nearly_black;
    case RegionKind::gem:
      return y.b_from[b_gem] & dielectric;
    case RegionKind::coloured:
      return below_zone & m.spread & ~metallic.some;
    case RegionKind::metal_with_diffuse:
      return y.b_from[b_metal] & m.diffuse_on_metal;
    case RegionKind::black_diffuse:
      return dielectric & m.diffuse_black;
    case RegionKind::any_f0:
      return ~std::uint64_t{0};
    case RegionKind::half_metal:
      return metallic.half;
    case RegionKind::dark_metal:
      return metallic.full & below_zone;
    case RegionKind::blue_metal:
      return y.b_from[b_metal] & m.bluish;
    // Black diffuse is right for metals: only texels that reflect like dielectrics are judged by their
    // albedo.
    case RegionKind::albedo_dark:
      return ~y.a_from[a_dark] & (has_b ? dielectric : ~std::uint64_t{0});
    case RegionKind::albedo_bright:
      return y.a_from[a_bright];
    case RegionKind::albedo_single:
      return m.single_channel;
  }
  return 0;
}

}  // namespace

TilePass::TilePass(const CheckTile& tile, const PassPlan& plan, int strip_rows, bool every_row)
    : plan_(plan), strip_rows_(strip_rows) {
  evidence_.tile = tile;
  const PixelBox& box = tile.box;
  sample_step_ = every_row || box.height <= always_sampled_height ? 1 : rows_between_samples;
  words_ = (static_cast<std::size_t>(box.width) + 63) / 64;
  counts_.resize(plan.workers);
  mask_counts_.resize(plan.workers);
  details_.resize(plan.workers);
  scratch_.assign(plan.workers, std::vector<MaskWords>(words_));
  if (plan.fringe) invisible_.resize(words_ * 4 * static_cast<std::size_t>(strip_rows));
  if (!plan.kinds.empty()) {
    masks_.resize(2 * static_cast<std::size_t>(strip_rows) * plan.kinds.size() * words_);
    regions_ = std::make_unique<RegionAnalysis>(box, plan.kinds, plan.zone.erode,
                                                least_region(plan.zone, box.area()), *plan.tables);
    if (plan.recorder) regions_->record(plan.recorder);
  }
}

std::uint64_t* TilePass::masks_of_row(int y) {
  return masks_.data() + static_cast<std::size_t>(y % (2 * strip_rows_)) * plan_.kinds.size() * words_;
}

// Four strips are kept, because a strip is counted before it is followed, and following looks back.
std::uint64_t* TilePass::invisible_row(int y) {
  return invisible_.data() + static_cast<std::size_t>(y % (4 * strip_rows_)) * words_;
}

void TilePass::count_row(unsigned worker, int y, const RowPointers& row) {
  const auto width = static_cast<std::size_t>(box().width);
  std::vector<MaskWords>& words = scratch_[worker];
  MaskCounts& counts = mask_counts_[worker];
  const std::size_t whole = width / 64, rest = width % 64;
  const ByteMasks masks = byte_masks();
  masks(row.a, row.b, whole, ~std::uint64_t{0}, plan_.transparency, plan_.limits, words.data(), counts);
  if (rest != 0) {
    // The rest of the last word repeats the last texel, which changes no extreme, with alpha 0, which adds to
    // no sum.
    std::uint8_t a[256], b[256];
    for (std::size_t i = 0; i < 64; ++i) {
      std::memcpy(a + 4 * i, row.a + 4 * (64 * whole + std::min(i, rest - 1)), 4);
      std::memcpy(b + 4 * i, row.b + 4 * (64 * whole + std::min(i, rest - 1)), 4);
      if (i >= rest) a[4 * i + 3] = 0;
    }
    masks(a, b, 1, (std::uint64_t{1} << rest) - 1, plan_.transparency, plan_.limits, words.data() + whole,
          counts);
  }
  counts_[worker].texels += width;
  count_words(counts_[worker], words, y, row, plan_.kinds.empty() ? nullptr : masks_of_row(y));
  if ((y - box().y) % sample_step_ == 0) add_detail(details_[worker], row);
}

std::uint64_t TilePass::sum_is_from(std::uint64_t doubt, const std::uint8_t* texels,
                                    std::uint32_t limit) const {
  std::uint64_t from = 0;
  std::uint32_t before = 0;  // flat colours are common, so that the sum of equal neighbours is computed once
  bool answer = plan_.tables->luminance(reinterpret_cast<const std::uint8_t*>(&before)) >= limit;
  each_bit(doubt, [&](int i) {
    std::uint32_t now;
    std::memcpy(&now, texels + 4 * i, 4);
    if (now != before) answer = plan_.tables->luminance(texels + 4 * i) >= limit;
    before = now;
    from |= std::uint64_t{answer} << i;
  });
  return from;
}

void TilePass::count_words(ByteCounts& counts, const std::vector<MaskWords>& words, int y,
                           const RowPointers& row, std::uint64_t* masks) {
  std::uint64_t* invisible = plan_.fringe ? invisible_row(y) : nullptr;
  for (std::size_t w = 0; w < words_; ++w) {
    const MaskWords& m = words[w];
    const std::uint64_t opaque = m.opaque;
    const int x0 = static_cast<int>(64 * w);
    if (invisible != nullptr) invisible[w] = m.alpha_zero;
    if ((m.energy_doubt & opaque) != 0) count_energy(counts, m.energy_doubt & opaque, x0, y, row);

    // Compares Y with the levels: the channels decide where all of them agree, else the sum.
    LevelBits bits;
    for (std::size_t level = 0; level < ByteLimits::b_levels; ++level)
      if (plan_.zone.metric == ZoneMetric::max && level >= b_zone)
        bits.b_from[level] = ~m.b_below[level];  // the largest channel decides the zone's two levels
      else
        bits.b_from[level] = m.b_from[level] | sum_is_from(opaque & ~(m.b_from[level] | m.b_below[level]),
                                                           row.b + 4 * x0, plan_.b_y[level]);
    const std::uint64_t metals = bits.b_from[b_metal] & opaque;
    if (metals != 0) counts.metals += static_cast<std::uint64_t>(std::popcount(metals));
    if (const std::uint64_t middle = m.alpha_middle & ~m.diffuse_black & ~bits.b_from[b_metal]; middle != 0)
      count_middle(counts, middle, x0, row);
    if (masks == nullptr) continue;
    for (std::size_t level = 0; level < ByteLimits::a_levels; ++level)
      bits.a_from[level] = m.a_from[level] | sum_is_from(opaque & ~(m.a_from[level] | m.a_below[level]),
                                                         row.a + 4 * x0, plan_.a_y[level]);
    const MetallicBits metallic = metallic_bits(opaque, row, x0);
    for (std::size_t k = 0; k < plan_.kinds.size(); ++k)
      masks[k * words_ + w] = bits_of_kind(plan_.kinds[k], m, bits, metallic, plan_.has_b) & opaque;
  }
}

void TilePass::count_energy(ByteCounts& counts, std::uint64_t doubt, int x0, int y, const RowPointers& row) {
  const auto& linear = plan_.tables->linear;
  each_bit(doubt, [&](int i) {
    const int x = x0 + i;
    const std::uint8_t *a = row.a + 4 * x, *b = row.b + 4 * x;
    std::uint64_t worst = 0;
    std::size_t channel = 0;
    const std::uint64_t largest = std::max({linear[b[0]], linear[b[1]], linear[b[2]]});
    for (std::size_t c = 0; c < 3; ++c) {
      std::uint64_t diffuse = linear[a[c]];
      if (plan_.specular_weighs)
        diffuse = diffuse * (linear_one - std::min<std::uint64_t>(largest, linear_one)) >> 24;
      const std::uint64_t sum = diffuse + linear[b[c]];
      if (sum > worst) {
        worst = sum;
        channel = c;
      }
    }
    if (worst <= plan_.energy_limit) return;
    ++counts.energy_over;
    counts.energy_far_over += worst > plan_.energy_far_limit;
    const PixelBox here{box().x + x, y, 1, 1};
    counts.energy_box = counts.energy_over == 1 ? here : around(counts.energy_box, here);
    if (worst > counts.energy_worst) {
      counts.energy_worst = worst;
      counts.energy_at = {a[channel], b[channel]};
      counts.energy_place = {here.x, y};
    }
  });
}

void TilePass::count_middle(ByteCounts& counts, std::uint64_t bits, int x0, const RowPointers& row) {
  each_bit(bits, [&](int i) {
    const std::uint8_t* a = row.a + 4 * (x0 + i);
    const std::uint64_t most = std::max({a[0], a[1], a[2]}), alpha = a[3];
    ++counts.middle;
    counts.middle_below += most <= alpha + 1;
    counts.sum_max += most;
    counts.sum_alpha += alpha;
    counts.sum_max2 += most * most;
    counts.sum_alpha2 += alpha * alpha;
    counts.sum_product += most * alpha;
  });
}

void TilePass::add_detail(Detail& detail, const RowPointers& row) {
  const int width = box().width;
  detail.texels += static_cast<std::uint64_t>(width);
  for (int x = 0; x < width; ++x) {
    const std::uint8_t *a = row.a + 4 * x, *b = row.b + 4 * x;
    if (a[3] == 0) continue;
    ++detail.opaque;
    for (std::size_t c = 0; c < 4; ++c) {
      ++detail.a[c][a[c]];
      ++detail.b[c][b[c]];
    }
  }
  for (int x = 1; x < width; ++x) {
    detail.smooth_a += std::abs(row.a[4 * x + 1] - row.a[4 * x - 3]) <= 1;
    detail.smooth_b += std::abs(row.b[4 * x + 1] - row.b[4 * x - 3]) <= 1;
  }
}

void TilePass::follow_row(int y, const std::function<RowPointers(int)>& rows) {
  const int top = box().y;
  if (regions_) regions_->push(y - top, masks_of_row(y), [&](int local) { return rows(top + local); });
  if (plan_.fringe) {
    const bool last = y == top + box().height - 1;
    for (int judged = y - fringe_reach; judged <= (last ? y : y - fringe_reach); ++judged)
      if (judged >= top) follow_fringe(judged, rows);
  }
}

void TilePass::follow_fringe(int y, const std::function<RowPointers(int)>& rows) {
  const int top = box().y, bottom = top + box().height - 1, width = box().width;
  const std::uint64_t* here = invisible_row(y);
  const int first = std::max(top, y - fringe_reach), last = std::min(bottom, y + fringe_reach);
  for (std::size_t w = 0; w < words_; ++w) {
    if (here[w] == 0) continue;
    // The texels that have a visible one within two columns in some of the 5 rows.
    std::uint64_t near = 0;
    for (int other = first; other <= last; ++other) {
      const std::uint64_t* row = invisible_row(other);
      const auto visible = [&](std::size_t word) {
        const std::size_t rest = static_cast<std::size_t>(width) % 64;
        const bool end = word + 1 == words_ && rest != 0;
        return ~row[word] & (end ? (std::uint64_t{1} << rest) - 1 : ~std::uint64_t{0});
      };
      const std::uint64_t v = visible(w);
      const std::uint64_t before = w == 0 ? 0 : visible(w - 1), after = w + 1 == words_ ? 0 : visible(w + 1);
      near |= v | v << 1 | v << 2 | v >> 1 | v >> 2 | before >> 63 | before >> 62 | after << 63 | after << 62;
    }
    each_bit(here[w] & near, [&](int i) {
      const int x = static_cast<int>(64 * w) + i;
      const std::uint8_t* texel = rows(y).a + 4 * x;
      int best = 1000, difference = 0;
      for (int other = first; other <= last; ++other) {
        const std::uint8_t* row = rows(other).a;
        for (int u = std::max(0, x - fringe_reach); u <= std::min(width - 1, x + fringe_reach); ++u) {
          const int distance = (u - x) * (u - x) + (other - y) * (other - y);
          if (row[4 * u + 3] == 0 || distance >= best) continue;
          best = distance;
          difference = 0;
          for (int c = 0; c < 3; ++c) difference = std::max(difference, std::abs(row[4 * u + c] - texel[c]));
        }
      }
      if (difference <= fringe_difference) return;
      ++evidence_.fringe;
      if (difference > evidence_.fringe_worst) {
        evidence_.fringe_worst = difference;
        evidence_.fringe_place = {box().x + x, y};
      }
    });
  }
}

TileEvidence TilePass::finish() {
  for (std::size_t worker = 0; worker < counts_.size(); ++worker) {
    ByteCounts& counts = counts_[worker];
    const MaskCounts& masks = mask_counts_[worker];
    counts.opaque = masks.opaque;
    counts.alpha_zero = masks.alpha_zero;
    counts.alpha_full = masks.alpha_full;
    counts.zone_any = masks.zone_any;
    counts.zone_all = masks.zone_all;
    counts.black = masks.black;
    counts.gloss_zero = masks.gloss_zero;
    counts.gloss_full = masks.gloss_full;
    counts.gloss_sum = masks.gloss_sum;
    counts.gloss_squares = masks.gloss_squares;
    counts.gloss_texels = counts.texels - masks.alpha_zero;
    counts.gloss_least = masks.gloss_least;
    counts.gloss_most = masks.gloss_most;
    evidence_.counts.add(counts);
  }
  for (const Detail& detail : details_) evidence_.detail.add(detail);
  evidence_.detail.every_row = sample_step_ == 1;
  evidence_.kinds = plan_.kinds;
  if (regions_) evidence_.regions = regions_->finish();
  return std::move(evidence_);
}

}  // namespace etak
