// SPDX-License-Identifier: Apache-2.0
#include <atomic>
#include <utility>

#include "core/image/mip_chain.h"
#include "core/math/functions.h"

namespace etak::mip_detail {
namespace {

// How many of the 16 samples of the patch between four texel centres have at least the opacity `cutoff`.
int passing(float a, float b, float c, float d, float cutoff) {
  if (std::min(std::min(a, b), std::min(c, d)) >= cutoff) return 16;
  if (std::max(std::max(a, b), std::max(c, d)) < cutoff) return 0;
  int count = 0;
  for (int j = 0; j < 4; ++j) {
    const float v = (static_cast<float>(j) + 0.5f) / 4, left = a + v * (c - a), right = b + v * (d - b);
    for (int i = 0; i < 4; ++i)
      count += left + (static_cast<float>(i) + 0.5f) / 4 * (right - left) >= cutoff ? 1 : 0;
  }
  return count;
}

}  // namespace

double coverage(int width, int height, float cutoff, unsigned threads, const OpacityRow& row) {
  // In a picture one texel wide or high, the patches have no extent along that axis.
  const int columns = std::max(1, width - 1), rows = std::max(1, height - 1);
  std::atomic<std::size_t> passed{0};
  parallel_chunks(
      static_cast<std::size_t>(rows), threads, 64, [&](std::size_t begin, std::size_t end, unsigned) {
        std::vector<float> upper(static_cast<std::size_t>(width)), lower(upper.size());
        row(static_cast<int>(begin), lower.data());
        std::size_t count = 0;
        for (std::size_t y = begin; y < end; ++y) {
          upper.swap(lower);
          row(std::min(height - 1, static_cast<int>(y) + 1), lower.data());
          for (std::size_t x = 0; x < static_cast<std::size_t>(columns); ++x) {
            const std::size_t right = std::min(x + 1, upper.size() - 1);
            count +=
                static_cast<std::size_t>(passing(upper[x], upper[right], lower[x], lower[right], cutoff));
          }
        }
        passed += count;
      });
  return static_cast<double>(passed) / (16.0 * columns * rows);
}

float coverage_factor(const OpacityLevel& level, float cutoff, double share, unsigned threads) {
  const std::span<const float> opacities = level.opacities;
  const int width = level.width, height = level.height;
  const auto factor_of = [](int k) { return static_cast<float>(math::exp2(k / 256.0)); };
  const auto off_by = [&](int k) {
    const float factor = factor_of(k);
    return coverage(width, height, cutoff, threads,
                    [&](int y, float* out) {
                      const auto from =
                          opacities.subspan(static_cast<std::size_t>(y) * static_cast<std::size_t>(width),
                                            static_cast<std::size_t>(width));
                      for (std::size_t x = 0; x < from.size(); ++x)
                        out[x] = scaled_opacity(from[x], factor, level.largest, level.rounded);
                    }) -
           share;
  };
  // Coverage never falls as the factor grows, so the best k is the least one that gives enough coverage, or
  // the one before it. k needs to reach 2048 only: the factor 2^8 takes even code 1 above code 255.
  const double unscaled = off_by(0);
  if (unscaled == 0) return 1;
  // Most factors are near 1, so the bracket starts there and grows.
  constexpr int last = 2048;
  int low = unscaled < 0 ? 0 : -64, high = unscaled < 0 ? 64 : 0;
  while (unscaled < 0 && high < last && off_by(high) < 0) low = std::exchange(high, 4 * high);
  while (unscaled > 0 && low > -last && off_by(low) >= 0) high = std::exchange(low, 4 * low);
  low = std::max(low, -last);
  high = std::min(high, last);
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    (off_by(middle) < 0 ? low : high) = middle;
  }
  int best = 0;
  double least = std::abs(unscaled);
  for (const int k : {low, high})
    if (const double off = std::abs(off_by(k)); off < least) {
      least = off;
      best = k;
    }
  return factor_of(best);
}

}  // namespace etak::mip_detail
