// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "core/judge/settings.h"

namespace etak {

/// The linear value of an encoded one and back, both as fractions of full scale in [0, 1].
double decode_of(TextureTransfer transfer, double encoded);
double encode_of(TextureTransfer transfer, double linear);

/// The most that the rounding to a code takes from a value or adds to it. The zone's limits lie so much further in,
/// so that a value on a limit is not in the zone on whichever side its code has fallen.
inline constexpr double half_a_code = 0.5;

/// The linear value 1 in the integers of the byte pass, whose unit is 2^-24.
inline constexpr std::uint32_t linear_one = 1u << 24;

/// The values of the 256 codes under one transfer function, as integers, so that the byte pass only adds and
/// needs no floats. Y is by luminance_weights.
struct CodeTables {
  explicit CodeTables(TextureTransfer transfer);

  std::array<std::uint32_t, 256> linear{};                // round(2^24 decode(code))
  std::array<std::uint32_t, 256> red{}, green{}, blue{};  // the same times the channel's weight in Y
  std::array<double, 256> decoded{};

  /// Y of a texel, where 1 is linear_one.
  std::uint32_t luminance(const std::uint8_t* rgb) const {
    return red[rgb[0]] + green[rgb[1]] + blue[rgb[2]];
  }

  /// Code of the grey whose Y is nearest in codes: rounded half up on the encoded scale.
  std::uint8_t luminance_code(const std::uint8_t* rgb) const { return code_of(luminance(rgb)); }

  /// The code of a Y, or of any other linear value, of at most linear_one + 1.
  std::uint8_t code_of(std::uint32_t y) const {
    std::uint8_t code = code_start_[y >> code_shift];
    while (code < 255 && y >= code_first_[code + 1u]) ++code;
    return code;
  }

  /// The smallest grey code whose Y is at least `y`, where 1 is linear_one; 256: none.
  int first_code_at_least(std::uint32_t y) const;

  /// Code (rounded half up) of a linear value clamped to [0, 1].
  std::uint8_t encode(double linear) const;
  double decode(double code) const;  // also for codes with a fraction, as means have
  /// A linear limit so many codes further on; 0 and 1 stay where they are.
  double moved(double limit, double codes) const;

 private:
  static constexpr unsigned code_shift = 12;
  TextureTransfer transfer_;
  std::array<std::uint32_t, 256> code_first_{};  // least y that rounds to the code
  std::array<std::uint8_t, (linear_one >> code_shift) + 2> code_start_{};
};

/// The least integer of the byte pass that lies above (is at least) a linear limit.
std::uint32_t first_above(double limit);
std::uint32_t first_at_least(double limit);

/// Which of the codes 0..100 an 8-bit linear source can reach when it is encoded to sRGB: 33 of 101, the comb
/// of ETK404.
const std::array<bool, 101>& comb_codes();

/// Tables of a transfer function, made once per process.
const CodeTables& code_tables(TextureTransfer transfer);

}  // namespace etak
