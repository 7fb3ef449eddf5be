// SPDX-License-Identifier: Apache-2.0
// SHA-256 by the processor's own instructions (Intel SHA Extensions), six times as fast as the plain loop.
// Based on Gulley, Gopal, Yap, Feghali, Guilford and Wolrich 2013, "Intel SHA Extensions".
#include <immintrin.h>

#include <utility>

#include "core/base/hash/sha256_blocks.h"

namespace etak {

namespace {

__m128i loaded(const void* from) {
  return _mm_loadu_si128(static_cast<const __m128i*>(from));
}

void store(void* to, __m128i value) {
  _mm_storeu_si128(static_cast<__m128i*>(to), value);
}

// A text on its way into its state. The instructions want the eight words as ABEF and CDGH.
struct Lane {
  __m128i abef, cdgh, old_abef, old_cdgh;
  // The message words of the last sixteen rounds, four in each.
  __m128i w[4];  // std::array would drop the alignment that belongs to the type
  const std::uint8_t* bytes;

  void begin(const std::array<std::uint32_t, 8>& state, const std::uint8_t* from) {
    const __m128i cdab = _mm_shuffle_epi32(loaded(state.data()), 0xB1);
    const __m128i efgh = _mm_shuffle_epi32(loaded(state.data() + 4), 0x1B);
    abef = _mm_alignr_epi8(cdab, efgh, 8);
    cdgh = _mm_blend_epi16(efgh, cdab, 0xF0);
    bytes = from;
  }
  void begin_block() {
    const __m128i big_endian = _mm_set_epi64x(0x0c0d0e0f08090a0b, 0x0405060700010203);
    old_abef = abef;
    old_cdgh = cdgh;
    for (std::size_t i = 0; i < 4; ++i) w[i] = _mm_shuffle_epi8(loaded(bytes + 16 * i), big_endian);
    bytes += 64;
  }
  // Four rounds, of which `i` must be known to the compiler, so that the message words stay in registers.
  [[gnu::always_inline]] void step(std::size_t i) {
    __m128i& now = w[i % 4];
    if (i >= 4) {
      const __m128i last = w[(i + 3) % 4];
      now =
          _mm_add_epi32(_mm_sha256msg1_epu32(now, w[(i + 1) % 4]), _mm_alignr_epi8(last, w[(i + 2) % 4], 4));
      now = _mm_sha256msg2_epu32(now, last);
    }
    const __m128i sum = _mm_add_epi32(now, loaded(sha256_constants.data() + 4 * i));
    cdgh = _mm_sha256rnds2_epu32(cdgh, abef, sum);
    abef = _mm_sha256rnds2_epu32(abef, cdgh, _mm_shuffle_epi32(sum, 0x0E));
  }
  void end_block() {
    abef = _mm_add_epi32(abef, old_abef);
    cdgh = _mm_add_epi32(cdgh, old_cdgh);
  }
  void end(std::array<std::uint32_t, 8>& state) const {
    const __m128i feba = _mm_shuffle_epi32(abef, 0x1B), dchg = _mm_shuffle_epi32(cdgh, 0xB1);
    store(state.data(), _mm_blend_epi16(feba, dchg, 0xF0));
    store(state.data() + 4, _mm_alignr_epi8(dchg, feba, 8));
  }
};

using Steps = std::make_index_sequence<16>;

template <std::size_t... i>
void all_steps(Lane& lane, std::index_sequence<i...>) {
  (lane.step(i), ...);
}

}  // namespace

void sha256_blocks_x86(std::array<std::uint32_t, 8>& state, const std::uint8_t* bytes, std::size_t blocks) {
  Lane lane;
  lane.begin(state, bytes);
  for (; blocks > 0; --blocks) {
    lane.begin_block();
    all_steps(lane, Steps());
    lane.end_block();
  }
  lane.end(state);
}

}  // namespace etak
