// SPDX-License-Identifier: Apache-2.0
#include <cstring>

#include "core/atlas/sources/plane.h"
#if defined(__x86_64__)
#include <immintrin.h>
#define ETAK_X86_64
#endif

namespace etak {
namespace {

// The first values of the four channels, and how many bytes lie from one to the next; 0: the channel is a constant.
struct ChannelBytes {
  const std::uint8_t *r, *g, *b, *a;
  std::size_t color_step, grey_step;
};

// Channels in any layout; `from` is a copy, which the bytes that are written cannot change.
void interleave_any(std::uint8_t* rgba, std::size_t texels, const ChannelBytes from) {
  const auto [r, g, b, a, color_step, grey_step] = from;
  for (std::size_t i = 0; i < texels; ++i) {
    rgba[4 * i] = r[i * color_step];
    rgba[4 * i + 1] = g[i * color_step];
    rgba[4 * i + 2] = b[i * color_step];
    rgba[4 * i + 3] = a[i * grey_step];
  }
}

#ifdef ETAK_X86_64
// RGB and grey without gaps, the usual pair; returns how many texels were done (the last few are not: a
// 16-byte load of 12 would read past the row).
__attribute__((target("ssse3"))) std::size_t interleave_rgb_grey(std::uint8_t* rgba, std::size_t texels,
                                                                 const std::uint8_t* rgb,
                                                                 const std::uint8_t* grey) {
  const __m128i spread = _mm_setr_epi8(0, 1, 2, -1, 3, 4, 5, -1, 6, 7, 8, -1, 9, 10, 11, -1);
  const __m128i to_fourth = _mm_setr_epi8(-1, -1, -1, 0, -1, -1, -1, 1, -1, -1, -1, 2, -1, -1, -1, 3);
  std::size_t i = 0;
  for (; i + 6 <= texels; i += 4) {
    __m128i color;
    std::memcpy(&color, rgb + 3 * i, sizeof color);
    std::int32_t four = 0;
    std::memcpy(&four, grey + i, sizeof four);
    const __m128i out =
        _mm_or_si128(_mm_shuffle_epi8(color, spread), _mm_shuffle_epi8(_mm_cvtsi32_si128(four), to_fourth));
    std::memcpy(rgba + 4 * i, &out, sizeof out);
  }
  return i;
}

bool has_ssse3() {
  static const bool found = [] {
    __builtin_cpu_init();
    return __builtin_cpu_supports("ssse3") != 0;
  }();
  return found;
}
#endif

}  // namespace

void interleave(std::uint8_t* rgba, std::size_t texels, const std::uint8_t* color,
                const PlaneRows& color_rows, const std::uint8_t* grey, const PlaneRows& grey_rows) {
  std::size_t done = 0;
  const std::array<int, 3> pick = color_rows.pick();
  const auto color_step = static_cast<std::size_t>(color == nullptr ? 0 : color_rows.step());
  const auto grey_step = static_cast<std::size_t>(grey == nullptr ? 0 : grey_rows.step());
#ifdef ETAK_X86_64
  if (color_step == 3 && grey_step == 1 && pick == std::array{0, 1, 2} && has_ssse3())
    done = interleave_rgb_grey(rgba, texels, color, grey);
#endif
  const std::uint8_t* r = color == nullptr ? &color_rows.source().constant[0] : color + pick[0];
  const std::uint8_t* g = color == nullptr ? &color_rows.source().constant[1] : color + pick[1];
  const std::uint8_t* b = color == nullptr ? &color_rows.source().constant[2] : color + pick[2];
  const std::uint8_t* a = grey == nullptr ? &grey_rows.source().constant[0] : grey + grey_rows.pick()[0];
  interleave_any(rgba + 4 * done, texels - done,
                 {r + done * color_step, g + done * color_step, b + done * color_step, a + done * grey_step,
                  color_step, grey_step});
}

}  // namespace etak
