// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "core/validate/settings.h"

namespace etak {

/// One unit of linear light in the integers of the byte pass.
inline constexpr std::uint32_t linear_one = 1u << 24;

/// What the 256 codes stand for under one transfer function, as integers: the byte pass adds, never
/// multiplies, and knows no floats. Y by luminance_weights.
struct CodeTables {
  explicit CodeTables(TextureTransfer transfer);

  std::array<std::uint32_t, 256> linear{};                // round(2^24 decode(code))
  std::array<std::uint32_t, 256> red{}, green{}, blue{};  // the same times the channel's weight in Y
  std::array<double, 256> decoded{};

  /// Y of a texel, of linear_one.
  std::uint32_t luminance(const std::uint8_t* rgb) const {
    return red[rgb[0]] + green[rgb[1]] + blue[rgb[2]];
  }

  /// Code of the grey whose Y is nearest in codes: rounded half up on the encoded scale.
  std::uint8_t luminance_code(const std::uint8_t* rgb) const { return code_of(luminance(rgb)); }

  /// The same of a Y (or any linear value of linear_one, at most linear_one + 1).
  std::uint8_t code_of(std::uint32_t y) const {
    std::uint8_t code = code_start_[y >> code_shift];
    while (code < 255 && y >= code_first_[code + 1u]) ++code;
    return code;
  }

  /// Smallest grey code whose Y is at least `y` (of linear_one); 256: none.
  int first_code_at_least(std::uint32_t y) const;

  /// Code (rounded half up) of a linear value clamped to [0, 1].
  std::uint8_t encode(double linear) const;
  double decode(double code) const;  // codes between whole ones: of means

 private:
  static constexpr unsigned code_shift = 12;
  TextureTransfer transfer_;
  std::array<std::uint32_t, 256> code_first_{};  // least y that rounds to the code
  std::array<std::uint8_t, (linear_one >> code_shift) + 2> code_start_{};
};

/// Integer above which (or from which on) a linear value lies: floor(2^24 v) + 1 for v > limit.
std::uint32_t first_above(double limit);
std::uint32_t first_at_least(double limit);

/// Which of the codes 0..100 an 8-bit linear source can reach when it is encoded to sRGB: 33 of 101, the comb
/// of ETK404.
const std::array<bool, 101>& comb_codes();

/// Tables of a transfer function, made once per process.
const CodeTables& code_tables(TextureTransfer transfer);

}  // namespace etak
