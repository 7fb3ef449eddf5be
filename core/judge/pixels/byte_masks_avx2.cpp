// SPDX-License-Identifier: Apache-2.0
// This source is compiled with -mavx2 and called only where the processor has AVX2.
#include "core/judge/pixels/byte_masks.h"

#include <immintrin.h>

namespace etak {

namespace {

using V = __m256i;
constexpr int lanes = 32;

inline V load(const std::uint8_t* p) {
  return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(p));
}
inline void store(std::uint8_t* p, V v) {
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(p), v);
}
inline V all(std::uint8_t value) {
  return _mm256_set1_epi8(static_cast<char>(value));
}
inline V larger(V a, V b) {
  return _mm256_max_epu8(a, b);
}
inline V smaller(V a, V b) {
  return _mm256_min_epu8(a, b);
}
inline V equal(V a, V b) {
  return _mm256_cmpeq_epi8(a, b);
}
inline V bit_and(V a, V b) {
  return _mm256_and_si256(a, b);
}
inline V bit_or(V a, V b) {
  return _mm256_or_si256(a, b);
}
inline V without(V a, V b) {
  return _mm256_andnot_si256(b, a);
}
inline V minus(V a, V b) {
  return _mm256_sub_epi8(a, b);
}
inline std::uint64_t truth_bits(V v) {
  return static_cast<std::uint32_t>(_mm256_movemask_epi8(v));
}
inline std::uint64_t sum_of_four(V v) {
  const __m128i half = _mm_add_epi64(_mm256_castsi256_si128(v), _mm256_extracti128_si256(v, 1));
  return static_cast<std::uint64_t>(_mm_cvtsi128_si64(_mm_add_epi64(half, _mm_unpackhi_epi64(half, half))));
}
inline void add_sums(V v, std::uint64_t& sum, std::uint64_t& squares) {
  const V zero = _mm256_setzero_si256();
  sum += sum_of_four(_mm256_sad_epu8(v, zero));
  const V low = _mm256_unpacklo_epi8(v, zero), high = _mm256_unpackhi_epi8(v, zero);
  const V pairs = _mm256_add_epi32(_mm256_madd_epi16(low, low), _mm256_madd_epi16(high, high));
  squares +=
      sum_of_four(_mm256_add_epi64(_mm256_unpacklo_epi32(pairs, zero), _mm256_unpackhi_epi32(pairs, zero)));
}

// Sorts 64 texels into planes of red, green, blue and the fourth channel. A vector of 8 texels gives 8 bytes
// of each channel; four of them make one vector of each plane.
template <class Planes>
inline void planes_of(const std::uint8_t* p, Planes& out) {
  const V by_channel = _mm256_setr_epi8(0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15, 0, 4, 8, 12, 1,
                                        5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15);
  const V by_lane = _mm256_setr_epi32(0, 4, 1, 5, 2, 6, 3, 7);
  for (int i = 0; i < 2; ++i) {
    V part[4];
    for (int j = 0; j < 4; ++j)
      part[j] =
          _mm256_permutevar8x32_epi32(_mm256_shuffle_epi8(load(p + 128 * i + 32 * j), by_channel), by_lane);
    // part[j]: red green | blue fourth, 8 bytes each, of the 8 texels from 8 j on
    const V red_a = _mm256_unpacklo_epi64(part[0], part[1]), red_b = _mm256_unpacklo_epi64(part[2], part[3]);
    const V green_a = _mm256_unpackhi_epi64(part[0], part[1]),
            green_b = _mm256_unpackhi_epi64(part[2], part[3]);
    out.red[i] = _mm256_permute2x128_si256(red_a, red_b, 0x20);
    out.blue[i] = _mm256_permute2x128_si256(red_a, red_b, 0x31);
    out.green[i] = _mm256_permute2x128_si256(green_a, green_b, 0x20);
    out.fourth[i] = _mm256_permute2x128_si256(green_a, green_b, 0x31);
  }
}

#include "core/judge/pixels/byte_masks.inc"

}  // namespace

ByteMasks byte_masks_avx2() {
  return &masks_of;
}

}  // namespace etak
