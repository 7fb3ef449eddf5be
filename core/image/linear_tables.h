// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace etak {

/// Codes to the scales on which their mean means something, and back: sRGB to linear light, gloss g of
/// exponent e = 2^(12 g) to the lobe's variance 1/e. Codes come back rounded half up, as the core's 8-bit
/// colours do, without a logarithm or a power: a table guesses the code and one comparison settles it.
struct LinearTables {
  std::array<float, 256> srgb;     // linear light of a code, [0, 1]
  std::array<float, 256> inverse;  // 1/e of a gloss code, 1 down to 2^-12

  // srgb_step[c]: the least float whose code is c or more; gloss_step[c]: the largest float (of 1/e) whose
  // code is c or more. The entries past the ends are never passed.
  std::array<float, 257> srgb_step;
  std::array<float, 256> gloss_step;

  // Codes are nowhere closer than 1 / (12.92 * 255) = 1/3295 in linear light, so a slot of 1/4096 holds at
  // most one step. Gloss codes are 2^(12/255) = 1.033 apart, and a 32nd of an octave is at most 1.0313.
  static constexpr int srgb_slots = 4096, slots_per_octave = 32, octaves = 13;
  std::array<std::uint8_t, srgb_slots + 1> srgb_guess;
  std::array<std::uint8_t, slots_per_octave * octaves + 1> gloss_guess;
  std::array<std::uint8_t, 4> behind;  // vector loads of a guess take in the bytes that follow

  static constexpr std::int32_t first_bits = (127 - octaves) << 23;  // of 2^-13

  /// sRGB code of linear light; below 0 counts as 0 and above 1 as 1.
  std::uint8_t srgb_code(float linear) const {
    const float clamped = std::min(1.0f, std::max(0.0f, linear));
    const unsigned guess = srgb_guess[static_cast<std::size_t>(clamped * float{srgb_slots})];
    return static_cast<std::uint8_t>(guess + (clamped >= srgb_step[guess + 1] ? 1u : 0u));
  }

  /// Gloss code of 1/e > 0; above 1 (wider than gloss 0) counts as 1, below 2^-12 as that.
  std::uint8_t gloss_code(float inverse_exponent) const {
    const auto slot = (std::bit_cast<std::int32_t>(inverse_exponent) - first_bits) >> 18;
    const unsigned guess =
        gloss_guess[static_cast<std::size_t>(std::clamp<std::int32_t>(slot, 0, slots_per_octave * octaves))];
    return static_cast<std::uint8_t>(guess - (inverse_exponent > gloss_step[guess] ? 1u : 0u));
  }
};

/// Built on first use.
const LinearTables& linear_tables();

}  // namespace etak
