// SPDX-License-Identifier: Apache-2.0
#include "core/image/blocks/budget.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <type_traits>

#include "core/color/srgb.h"
#include "core/math/functions.h"

namespace etak {

void TexelSpread::add(double difference, std::uint8_t share) {
  // Differences beyond the last bin are told as the largest.
  const auto bin =
      static_cast<std::size_t>(std::min(static_cast<double>(bin_count - 1), std::ceil(difference / unit_)));
  bins_[bin] += share;
  count_ += share;
  largest_ = std::max(largest_, difference);
}

void TexelSpread::add(const TexelSpread& other) {
  for (std::size_t b = 0; b < bins_.size(); ++b) bins_[b] += other.bins_[b];
  count_ += other.count_;
  largest_ = std::max(largest_, other.largest_);
}

double TexelSpread::percentile_99() const {
  std::uint64_t left = count_ - count_ / 100;
  for (std::size_t b = 0; b + 1 < bins_.size(); ++b) {
    if (bins_[b] >= left) return std::min(largest_, static_cast<double>(b) * unit_);
    left -= bins_[b];
  }
  return largest_;
}

std::uint64_t TexelSpread::above(double difference) const {
  const auto first =
      std::min(static_cast<std::ptrdiff_t>(std::lround(difference / unit_)) + 1, std::ssize(bins_));
  return std::accumulate(bins_.begin() + first, bins_.end(), std::uint64_t{0});
}

BlockMeasure::BlockMeasure(Texture texture, GlossForm gloss, const BlockBudget& budget)
    : is_gloss_(texture == Texture::specular_gloss),
      colour_budget_(is_gloss_ ? budget.f0 : budget.diffuse),
      fourth_budget_(is_gloss_ ? budget.gloss : budget.alpha) {
  for (std::size_t code = 0; code < 256; ++code) {
    const double value = static_cast<double>(code) / 255;
    linear_[code] = srgb_decode(value);
    // The exponent of a roughness of 0 is infinite, and that of 1 is 0: the ends of what gloss can tell take their place.
    const double roughness = gloss == GlossForm::roughness ? value : 1 - value;
    exponent_log2_[code] =
        12 * (gloss == GlossForm::schueler ? value : std::clamp(gloss_of_roughness(roughness), -1.0, 2.0));
  }
}

double BlockMeasure::colour(const std::array<std::uint8_t, 4>& from,
                            const std::array<std::uint8_t, 4>& to) const {
  if (std::equal(from.begin(), from.begin() + 3, to.begin())) return 0;
  return delta_e2000(lab(from), lab(to));
}

double BlockMeasure::fourth(std::uint8_t from, std::uint8_t to, int cutoff) const {
  if (is_gloss_) return 100 * (math::exp2(std::abs(exponent_log2_[from] - exponent_log2_[to])) - 1);
  if (cutoff >= 0) return (from >= cutoff) == (to >= cutoff) ? 0 : 100;
  return std::abs(from - to) / 2.55;
}

TexelForm BlockMeasure::form_around(const Code& texel) const {
  // What a code changes is looked up around the texel.
  constexpr int step = 3;
  const Lab at = lab(texel);
  std::array<Vec3, 3> change{};
  for (std::size_t c = 0; c < 3; ++c) {
    const int codes = texel[c] < 128 ? step : -step;
    Code beside = texel;
    beside[c] = static_cast<std::uint8_t>(texel[c] + codes);
    const Lab to = lab(beside);
    change[c] = {(to.l - at.l) / codes, (to.a - at.a) / codes, (to.b - at.b) / codes};
  }
  const Mat3 metric = delta_e2000_around(at);
  constexpr float least_delta_e = 0.05f;
  TexelForm out;
  for (std::size_t a = 0; a < 3; ++a) {
    const Vec3 by = metric * change[a];
    out.weights[a] = std::max(least_delta_e * least_delta_e, static_cast<float>(dot(by, change[a])));
    for (std::size_t b = a + 1; b < 3; ++b) out.pairs[a + b - 1] = static_cast<float>(dot(by, change[b]));
  }
  return out;
}

TexelForm BlockMeasure::form_of(const Code& texel) const {
  // A texture has few colours, and what a thread has computed for one stays in the row of its last bits.
  struct Known {
    std::uint32_t colour = 0;  // with a bit above it; 0: none yet
    TexelForm form;
  };
  constexpr unsigned rows = 8;
  thread_local std::array<Known, rows * rows * rows> all_known;
  static_assert(std::is_trivially_destructible_v<decltype(all_known)>);
  Known& known = all_known[(texel[0] % rows * rows + texel[1] % rows) * rows + texel[2] % rows];
  const std::uint32_t colour = 1u << 24 | unsigned{texel[0]} << 16 | unsigned{texel[1]} << 8 | texel[2];
  if (known.colour != colour) known = {colour, form_around(texel)};
  TexelForm out = known.form;
  const auto budgets = static_cast<float>(colour_budget_ * colour_budget_);
  for (std::size_t c = 0; c < 3; ++c) out.weights[c] /= budgets, out.pairs[c] /= budgets;
  constexpr double alpha_percent = 1 / 2.55, most_gloss_percent = 30;
  const auto next = static_cast<std::uint8_t>(texel[3] < 255 ? texel[3] + 1 : 254);
  const double fourth_budgets =
      (is_gloss_ ? std::min(most_gloss_percent, fourth(texel[3], next, -1)) : alpha_percent) / fourth_budget_;
  out.weights[3] = static_cast<float>(fourth_budgets * fourth_budgets);
  return out;
}

void BlockMeasure::weigh(AnyBlock& block) const {
  std::array<int, 4> sum{};
  for (std::uint64_t left = block.counting; left != 0; left &= left - 1)
    for (std::size_t c = 0; c < 4; ++c)
      sum[c] += block.texels[static_cast<std::size_t>(std::countr_zero(left))][c];
  const int count = std::max(1, std::popcount(block.counting));
  Code mean{};
  for (std::size_t c = 0; c < 4; ++c) mean[c] = static_cast<std::uint8_t>(sum[c] / count);
  const TexelForm form = form_of(mean);
  block.weights = form.weights;
  block.pairs = form.pairs;
}

}  // namespace etak
