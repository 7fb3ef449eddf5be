// SPDX-License-Identifier: Apache-2.0
#include "core/judge/pixels/byte_masks.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace etak {

namespace {

constexpr int lanes = 16;

#if defined(__SSE2__)

using V = __m128i;

inline V load(const std::uint8_t* p) {
  return _mm_loadu_si128(reinterpret_cast<const __m128i*>(p));
}
inline void store(std::uint8_t* p, V v) {
  _mm_storeu_si128(reinterpret_cast<__m128i*>(p), v);
}
inline V all(std::uint8_t value) {
  return _mm_set1_epi8(static_cast<char>(value));
}
inline V larger(V a, V b) {
  return _mm_max_epu8(a, b);
}
inline V smaller(V a, V b) {
  return _mm_min_epu8(a, b);
}
inline V equal(V a, V b) {
  return _mm_cmpeq_epi8(a, b);
}
inline V bit_and(V a, V b) {
  return _mm_and_si128(a, b);
}
inline V bit_or(V a, V b) {
  return _mm_or_si128(a, b);
}
inline V without(V a, V b) {
  return _mm_andnot_si128(b, a);
}
inline V minus(V a, V b) {
  return _mm_sub_epi8(a, b);
}
inline std::uint64_t truth_bits(V v) {
  return static_cast<std::uint32_t>(_mm_movemask_epi8(v));
}
inline std::uint64_t sum_of_two(V v) {
  return static_cast<std::uint64_t>(_mm_cvtsi128_si64(_mm_add_epi64(v, _mm_unpackhi_epi64(v, v))));
}
inline void add_sums(V v, std::uint64_t& sum, std::uint64_t& squares) {
  const V zero = _mm_setzero_si128();
  sum += sum_of_two(_mm_sad_epu8(v, zero));
  const V low = _mm_unpacklo_epi8(v, zero), high = _mm_unpackhi_epi8(v, zero);
  const V pairs = _mm_add_epi32(_mm_madd_epi16(low, low), _mm_madd_epi16(high, high));
  squares += sum_of_two(_mm_add_epi64(_mm_unpacklo_epi32(pairs, zero), _mm_unpackhi_epi32(pairs, zero)));
}

template <class Planes>
inline void planes_of(const std::uint8_t* p, Planes& out) {
  const V low_byte = _mm_set1_epi32(0xff);
  for (int i = 0; i < 4; ++i) {
    const V v[4] = {load(p + 64 * i), load(p + 64 * i + 16), load(p + 64 * i + 32), load(p + 64 * i + 48)};
    const auto plane = [&](int shift) {
      V part[4];
      for (int j = 0; j < 4; ++j) part[j] = _mm_and_si128(_mm_srli_epi32(v[j], shift), low_byte);
      return _mm_packus_epi16(_mm_packs_epi32(part[0], part[1]), _mm_packs_epi32(part[2], part[3]));
    };
    out.red[i] = plane(0);
    out.green[i] = plane(8);
    out.blue[i] = plane(16);
    out.fourth[i] = plane(24);
  }
}

#else  // any other processor: the same operations in loops

struct V {
  std::uint8_t v[lanes];
};

template <class Act>
inline V each(Act act) {
  V out;
  for (int i = 0; i < lanes; ++i) out.v[i] = static_cast<std::uint8_t>(act(i));
  return out;
}
inline void store(std::uint8_t* p, const V& v) {
  for (int i = 0; i < lanes; ++i) p[i] = v.v[i];
}
inline V all(std::uint8_t value) {
  return each([&](int) { return value; });
}
inline V larger(const V& a, const V& b) {
  return each([&](int i) { return a.v[i] > b.v[i] ? a.v[i] : b.v[i]; });
}
inline V smaller(const V& a, const V& b) {
  return each([&](int i) { return a.v[i] < b.v[i] ? a.v[i] : b.v[i]; });
}
inline V equal(const V& a, const V& b) {
  return each([&](int i) { return a.v[i] == b.v[i] ? 255 : 0; });
}
inline V bit_and(const V& a, const V& b) {
  return each([&](int i) { return a.v[i] & b.v[i]; });
}
inline V bit_or(const V& a, const V& b) {
  return each([&](int i) { return a.v[i] | b.v[i]; });
}
inline V without(const V& a, const V& b) {
  return each([&](int i) { return a.v[i] & ~b.v[i]; });
}
inline V minus(const V& a, const V& b) {
  return each([&](int i) { return a.v[i] - b.v[i]; });
}
inline std::uint64_t truth_bits(const V& v) {
  std::uint64_t bits = 0;
  for (int i = 0; i < lanes; ++i) bits |= static_cast<std::uint64_t>(v.v[i] >> 7) << i;
  return bits;
}
inline void add_sums(const V& v, std::uint64_t& sum, std::uint64_t& squares) {
  for (int i = 0; i < lanes; ++i) {
    sum += v.v[i];
    squares += std::uint64_t{v.v[i]} * v.v[i];
  }
}
template <class Planes>
inline void planes_of(const std::uint8_t* p, Planes& out) {
  for (int i = 0; i < 64; ++i) {
    out.red[i / lanes].v[i % lanes] = p[4 * i];
    out.green[i / lanes].v[i % lanes] = p[4 * i + 1];
    out.blue[i / lanes].v[i % lanes] = p[4 * i + 2];
    out.fourth[i / lanes].v[i % lanes] = p[4 * i + 3];
  }
}

#endif

#include "core/judge/pixels/byte_masks.inc"

}  // namespace

ByteMasks byte_masks_plain() {
  return &masks_of;
}

ByteMasks byte_masks() {
#if defined(ETAK_BYTE_MASKS_AVX2)
  static const bool avx2 = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("popcnt") != 0;
  if (avx2) return byte_masks_avx2();
#endif
  return byte_masks_plain();
}

}  // namespace etak
