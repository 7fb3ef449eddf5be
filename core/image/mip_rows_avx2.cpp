// SPDX-License-Identifier: Apache-2.0
// The loops of mip_rows.h with AVX2: eight texels at a time, one register for each channel. CMakeLists.txt
// sets the compiler's flag. Fused multiply-add is not used, because it rounds differently from the plain
// loops.
#include <immintrin.h>

#include "core/image/mip_chain.h"
#include "core/image/mip_rows.h"

// Casts that intrinsics ask for.
// NOLINTBEGIN(cppcoreguidelines-pro-type-reinterpret-cast)
namespace etak::mip_detail {
namespace {

using Floats = __m256;
using Ints = __m256i;

struct Channels {
  Floats r, g, b, w;
};

Floats all(float value) {
  return _mm256_set1_ps(value);
}
Floats choose(Floats mask, Floats yes, Floats no) {
  return _mm256_blendv_ps(no, yes, mask);
}
Ints byte_of(Ints texels, int channel) {
  return _mm256_and_si256(_mm256_srli_epi32(texels, 8 * channel), _mm256_set1_epi32(255));
}

// Sixteen texels of a row, split into those of even and those of odd columns.
struct Columns {
  Ints even, odd;
};
Columns columns(const std::uint8_t* codes) {
  const auto* from = reinterpret_cast<const __m256i*>(codes);
  const Floats low = _mm256_castsi256_ps(_mm256_loadu_si256(from)),
               high = _mm256_castsi256_ps(_mm256_loadu_si256(from + 1));
  const auto in_order = [](Floats pairs) {
    return _mm256_permute4x64_epi64(_mm256_castps_si256(pairs), 0xD8);
  };
  return {in_order(_mm256_shuffle_ps(low, high, 0x88)), in_order(_mm256_shuffle_ps(low, high, 0xDD))};
}

// Codes as numbers that may be averaged. The fourth channel becomes 1/e for gloss, and stays a code for
// opacity.
template <bool gloss>
Channels decoded(Ints texels, const LinearTables& tables) {
  const auto linear = [&](int channel) {
    return _mm256_i32gather_ps(tables.srgb.data(), byte_of(texels, channel), 4);
  };
  const Ints last = _mm256_srli_epi32(texels, 24);
  return {linear(0), linear(1), linear(2),
          gloss ? _mm256_i32gather_ps(tables.inverse.data(), last, 4) : _mm256_cvtepi32_ps(last)};
}

// 0.25 ((p0 + p1) + (p2 + p3)), the order in which average_rows() adds.
template <class Get>
Floats mean(const Channels (&p)[4], Get get) {
  return _mm256_mul_ps(
      all(0.25f), _mm256_add_ps(_mm256_add_ps(get(p[0]), get(p[1])), _mm256_add_ps(get(p[2]), get(p[3]))));
}
Channels plain_mean(const Channels (&p)[4]) {
  return {mean(p, [](const Channels& c) { return c.r; }), mean(p, [](const Channels& c) { return c.g; }),
          mean(p, [](const Channels& c) { return c.b; }), mean(p, [](const Channels& c) { return c.w; })};
}
Channels weighted_mean(const Channels (&p)[4]) {
  return {mean(p, [](const Channels& c) { return _mm256_mul_ps(c.r, c.w); }),
          mean(p, [](const Channels& c) { return _mm256_mul_ps(c.g, c.w); }),
          mean(p, [](const Channels& c) { return _mm256_mul_ps(c.b, c.w); }), _mm256_setzero_ps()};
}

Floats luminance(const Channels& c) {
  return _mm256_add_ps(_mm256_add_ps(_mm256_mul_ps(all(luminance_weights<float>[0]), c.r),
                                     _mm256_mul_ps(all(luminance_weights<float>[1]), c.g)),
                       _mm256_mul_ps(all(luminance_weights<float>[2]), c.b));
}

void store(const Channels& c, Texel* out) {
  const Floats rg_low = _mm256_unpacklo_ps(c.r, c.g), rg_high = _mm256_unpackhi_ps(c.r, c.g);
  const Floats bw_low = _mm256_unpacklo_ps(c.b, c.w), bw_high = _mm256_unpackhi_ps(c.b, c.w);
  const Floats t04 = _mm256_shuffle_ps(rg_low, bw_low, 0x44), t15 = _mm256_shuffle_ps(rg_low, bw_low, 0xEE);
  const Floats t26 = _mm256_shuffle_ps(rg_high, bw_high, 0x44),
               t37 = _mm256_shuffle_ps(rg_high, bw_high, 0xEE);
  auto* to = reinterpret_cast<float*>(out);
  _mm256_storeu_ps(to, _mm256_permute2f128_ps(t04, t15, 0x20));
  _mm256_storeu_ps(to + 8, _mm256_permute2f128_ps(t26, t37, 0x20));
  _mm256_storeu_ps(to + 16, _mm256_permute2f128_ps(t04, t15, 0x31));
  _mm256_storeu_ps(to + 24, _mm256_permute2f128_ps(t26, t37, 0x31));
}

Channels load(const Texel* texels) {
  const auto* from = reinterpret_cast<const float*>(texels);
  const Floats v0 = _mm256_loadu_ps(from), v1 = _mm256_loadu_ps(from + 8);
  const Floats v2 = _mm256_loadu_ps(from + 16), v3 = _mm256_loadu_ps(from + 24);
  const Floats t04 = _mm256_permute2f128_ps(v0, v2, 0x20), t15 = _mm256_permute2f128_ps(v0, v2, 0x31);
  const Floats t26 = _mm256_permute2f128_ps(v1, v3, 0x20), t37 = _mm256_permute2f128_ps(v1, v3, 0x31);
  const Floats rg01 = _mm256_unpacklo_ps(t04, t15), bw01 = _mm256_unpackhi_ps(t04, t15);
  const Floats rg23 = _mm256_unpacklo_ps(t26, t37), bw23 = _mm256_unpackhi_ps(t26, t37);
  return {_mm256_shuffle_ps(rg01, rg23, 0x44), _mm256_shuffle_ps(rg01, rg23, 0xEE),
          _mm256_shuffle_ps(bw01, bw23, 0x44), _mm256_shuffle_ps(bw01, bw23, 0xEE)};
}

int average(const std::uint8_t* a0, const std::uint8_t* a1, const std::uint8_t* b0, const std::uint8_t* b1,
            int count, bool weigh_by_opacity, const LinearTables& tables, Texel* a, Texel* b) {
  const Floats zero = _mm256_setzero_ps();
  int x = 0;
  for (; x + 8 <= count; x += 8, a0 += 64, a1 += 64, b0 += 64, b1 += 64) {
    const Columns upper_a = columns(a0), lower_a = columns(a1);
    const Channels four_a[4] = {decoded<false>(upper_a.even, tables), decoded<false>(upper_a.odd, tables),
                                decoded<false>(lower_a.even, tables), decoded<false>(lower_a.odd, tables)};
    Channels mean_a = plain_mean(four_a);
    if (weigh_by_opacity) {
      const Channels weighted = weighted_mean(four_a);
      const Floats visible = _mm256_cmp_ps(mean_a.w, zero, _CMP_GT_OQ),
                   share = _mm256_div_ps(all(1), mean_a.w);
      mean_a.r = choose(visible, _mm256_mul_ps(weighted.r, share), mean_a.r);
      mean_a.g = choose(visible, _mm256_mul_ps(weighted.g, share), mean_a.g);
      mean_a.b = choose(visible, _mm256_mul_ps(weighted.b, share), mean_a.b);
    }
    store(mean_a, a + x);

    const Columns upper_b = columns(b0), lower_b = columns(b1);
    const Channels four_b[4] = {decoded<true>(upper_b.even, tables), decoded<true>(upper_b.odd, tables),
                                decoded<true>(lower_b.even, tables), decoded<true>(lower_b.odd, tables)};
    Channels mean_b = plain_mean(four_b);
    const Floats whole = luminance(mean_b), part = luminance(weighted_mean(four_b));
    const Floats counts =
        _mm256_and_ps(_mm256_cmp_ps(whole, zero, _CMP_GT_OQ), _mm256_cmp_ps(part, zero, _CMP_GT_OQ));
    mean_b.w = choose(counts, _mm256_div_ps(part, whole), mean_b.w);
    store(mean_b, b + x);
  }
  return x;
}

Ints srgb_codes(Floats linear, const LinearTables& tables) {
  const Floats clamped = _mm256_min_ps(_mm256_max_ps(linear, _mm256_setzero_ps()), all(1));
  const Ints slot = _mm256_cvttps_epi32(_mm256_mul_ps(clamped, all(float{LinearTables::srgb_slots})));
  const Ints guess =
      byte_of(_mm256_i32gather_epi32(reinterpret_cast<const int*>(tables.srgb_guess.data()), slot, 1), 0);
  const Floats step = _mm256_i32gather_ps(tables.srgb_step.data() + 1, guess, 4);
  // A lane whose comparison is true is -1, so subtracting it adds 1.
  return _mm256_sub_epi32(guess, _mm256_castps_si256(_mm256_cmp_ps(clamped, step, _CMP_GE_OQ)));
}

Ints gloss_codes(Floats inverse, const LinearTables& tables) {
  constexpr int last_slot = LinearTables::slots_per_octave * LinearTables::octaves;
  Ints slot = _mm256_srai_epi32(
      _mm256_sub_epi32(_mm256_castps_si256(inverse), _mm256_set1_epi32(LinearTables::first_bits)), 18);
  slot = _mm256_min_epi32(_mm256_max_epi32(slot, _mm256_setzero_si256()), _mm256_set1_epi32(last_slot));
  const Ints guess =
      byte_of(_mm256_i32gather_epi32(reinterpret_cast<const int*>(tables.gloss_guess.data()), slot, 1), 0);
  const Floats step = _mm256_i32gather_ps(tables.gloss_step.data(), guess, 4);
  return _mm256_add_epi32(guess, _mm256_castps_si256(_mm256_cmp_ps(inverse, step, _CMP_GT_OQ)));
}

void store_codes(const Channels& c, Ints last, const LinearTables& tables, std::uint8_t* out) {
  const Ints low = _mm256_or_si256(srgb_codes(c.r, tables), _mm256_slli_epi32(srgb_codes(c.g, tables), 8));
  const Ints high =
      _mm256_or_si256(_mm256_slli_epi32(srgb_codes(c.b, tables), 16), _mm256_slli_epi32(last, 24));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), _mm256_or_si256(low, high));
}

int encode(const Texel* a, const Texel* b, int count, const LinearTables& tables, float widest,
           std::uint8_t* out_a, std::uint8_t* out_b, std::size_t& wider) {
  int x = 0;
  for (; x + 8 <= count; x += 8, out_a += 32, out_b += 32) {
    const Channels texels_a = load(a + x), texels_b = load(b + x);
    store_codes(texels_a, _mm256_cvttps_epi32(_mm256_add_ps(texels_a.w, all(0.5f))), tables, out_a);
    store_codes(texels_b, gloss_codes(texels_b.w, tables), tables, out_b);
    const int mask = _mm256_movemask_ps(_mm256_cmp_ps(texels_b.w, all(widest), _CMP_GT_OQ));
    wider += static_cast<std::size_t>(__builtin_popcount(static_cast<unsigned>(mask)));
  }
  return x;
}

}  // namespace
// NOLINTEND(cppcoreguidelines-pro-type-reinterpret-cast)

const MipRows& mip_rows_avx2() {
  static const MipRows rows{average, encode};
  return rows;
}

}  // namespace etak::mip_detail
