// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace etak {

/// Tables that convert codes to scales on which they may be averaged, and back: sRGB codes to linear light,
/// and codes of gloss g, whose exponent is e = 2^(12 g), to the variance 1/e of the lobe. Codes are rounded
/// half up, like all 8-bit colours of etak. The way back needs no logarithm or power: a table gives a guess
/// of the code, and one comparison corrects it.
struct LinearTables {
  std::array<float, 256> srgb;     // linear light of a code, [0, 1]
  std::array<float, 256> inverse;  // 1/e of a gloss code, 1 down to 2^-12

  // srgb_step[c] is the least float whose code is c or more; gloss_step[c] is the largest 1/e whose code is c
  // or more. srgb_step[256] and gloss_step[0] are infinite, so that no value is beyond them.
  std::array<float, 257> srgb_step;
  std::array<float, 256> gloss_step;

  // Neighbouring sRGB codes are at least 1 / (12.92 * 255) = 1/3295 apart in linear light, so a slot of
  // 1/4096 holds at most one step. Neighbouring gloss codes differ by the factor 2^(12/255) = 1.033 in 1/e,
  // and the slots, each a 32nd of an octave, span a factor of at most 1.0313.
  static constexpr int srgb_slots = 4096, slots_per_octave = 32, octaves = 13;
  std::array<std::uint8_t, srgb_slots + 1> srgb_guess;
  std::array<std::uint8_t, slots_per_octave * octaves + 1> gloss_guess;
  std::array<std::uint8_t, 4> padding;  // vector loads of a guess also read the three bytes behind it

  static constexpr std::int32_t first_bits = (127 - octaves) << 23;  // the bits of the float 2^-13

  /// sRGB code of a value in linear light; values are clamped to [0, 1].
  std::uint8_t srgb_code(float linear) const {
    const float clamped = std::min(1.0f, std::max(0.0f, linear));
    const unsigned guess = srgb_guess[static_cast<std::size_t>(clamped * float{srgb_slots})];
    return static_cast<std::uint8_t>(guess + (clamped >= srgb_step[guess + 1] ? 1u : 0u));
  }

  /// Gloss code of 1/e, which must be above 0. Values above 1 (a lobe wider than that of gloss 0) count as 1,
  /// and values below 2^-12 as 2^-12.
  std::uint8_t gloss_code(float inverse_exponent) const {
    const auto slot = (std::bit_cast<std::int32_t>(inverse_exponent) - first_bits) >> 18;
    const unsigned guess =
        gloss_guess[static_cast<std::size_t>(std::clamp<std::int32_t>(slot, 0, slots_per_octave * octaves))];
    return static_cast<std::uint8_t>(guess - (inverse_exponent > gloss_step[guess] ? 1u : 0u));
  }
};

/// The tables, which are built on first use.
const LinearTables& linear_tables();

}  // namespace etak
