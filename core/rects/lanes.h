// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#include "core/base/clones.h"

namespace etak::rects {

// Eight numbers at a time through the compiler's vector types: plain C++ wherever these have no registers.
// Only for use inside one function; LANES_FUNCTION compiles it for AVX2 too and picks at run time.

using Lanes [[gnu::vector_size(32)]] = int;
inline constexpr int lane_count = 8;

#define LANES_FUNCTION ETAK_CLONES("avx2")

/// One bit for each lane of a comparison that holds.
[[gnu::always_inline]] inline unsigned lane_bits(const Lanes& holds) {
  const Lanes bits = holds & Lanes{1, 2, 4, 8, 16, 32, 64, 128};
  std::uint64_t parts[4];
  std::memcpy(parts, &bits, sizeof parts);
  const std::uint64_t all = (parts[0] | parts[1]) | (parts[2] | parts[3]);
  return static_cast<unsigned>((all | all >> 32) & 255);
}

/// Puts the least number into every lane.
[[gnu::always_inline]] inline void spread_least(Lanes& a) {
  Lanes b = __builtin_shufflevector(a, a, 4, 5, 6, 7, 0, 1, 2, 3);
  a = a < b ? a : b;
  b = __builtin_shufflevector(a, a, 2, 3, 0, 1, 6, 7, 4, 5);
  a = a < b ? a : b;
  b = __builtin_shufflevector(a, a, 1, 0, 3, 2, 5, 4, 7, 6);
  a = a < b ? a : b;
}

inline int lowest_lane(unsigned bits) {
  return std::countr_zero(bits);
}

inline int highest_lane(unsigned bits) {
  return static_cast<int>(std::bit_width(bits)) - 1;
}

}  // namespace etak::rects
