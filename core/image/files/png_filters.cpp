// SPDX-License-Identifier: Apache-2.0
#include "core/image/files/png_filters.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>

namespace etak {
namespace {

// The value that a filter predicts for a byte, from the bytes to its left, above it, and above and to the
// left (`corner`).
int predicted(int filter, int left, int above, int corner) {
  switch (filter) {
    case 1:
      return left;
    case 2:
      return above;
    case 3:
      return (left + above) / 2;
    case 4: {
      const int to_left = std::abs(above - corner), to_above = std::abs(left - corner),
                to_corner = std::abs(left + above - 2 * corner);
      return to_left <= to_above && to_left <= to_corner ? left : to_above <= to_corner ? above : corner;
    }
    default:
      return 0;
  }
}

void filter_portable(const std::uint8_t* row, const std::uint8_t* above, std::size_t size, std::size_t pixel,
                     std::uint8_t* out) {
  std::array<std::size_t, 5> cost{};
  const auto byte = [&](int filter, std::size_t i) {
    const std::uint8_t *left = row + i - pixel, *corner = above + i - pixel;  // zeros before the first pixel
    return static_cast<std::uint8_t>(row[i] - predicted(filter, *left, above[i], *corner));
  };
  for (int filter = 0; filter < 5; ++filter)
    for (std::size_t i = 0; i < size; ++i) {
      const unsigned difference = byte(filter, i);
      cost[static_cast<std::size_t>(filter)] += std::min(difference, 256 - difference);
    }
  const int best = static_cast<int>(std::min_element(cost.begin(), cost.end()) - cost.begin());
  out[0] = static_cast<std::uint8_t>(best);
  for (std::size_t i = 0; i < size; ++i) out[i + 1] = byte(best, i);
}

void unfilter_portable(int filter, const std::uint8_t* row, const std::uint8_t* above, std::size_t size,
                       std::size_t pixel, std::uint8_t* out) {
  for (std::size_t i = 0; i < size; ++i) {
    const bool first = i < pixel;
    out[i] = static_cast<std::uint8_t>(
        row[i] + predicted(filter, first ? 0 : out[i - pixel], above[i], first ? 0 : above[i - pixel]));
  }
}

}  // namespace

const PngFilters& png_filters_portable() {
  static const PngFilters filters{"portable", filter_portable, unfilter_portable};
  return filters;
}

const PngFilters& png_filters() {
#ifdef ETAK_PNG_X86_64
  static const bool avx2 = (__builtin_cpu_init(), __builtin_cpu_supports("avx2") != 0);
  return avx2 ? png_filters_avx2() : png_filters_sse2();
#else
  return png_filters_portable();
#endif
}

}  // namespace etak
