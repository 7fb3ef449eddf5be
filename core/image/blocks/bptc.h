// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

/// What the decoders of BC6H and BC7 have in common (Khronos Data Format Specification 1.3, chapter 20, BPTC).
namespace etak::bptc {

// Shares of the second end of a line by index, of 64.
inline constexpr std::array<std::uint8_t, 4> weights_of_2_bits{0, 21, 43, 64};
inline constexpr std::array<std::uint8_t, 8> weights_of_3_bits{0, 9, 18, 27, 37, 46, 55, 64};
inline constexpr std::array<std::uint8_t, 16> weights_of_4_bits{0,  4,  9,  13, 17, 21, 26, 30,
                                                                34, 38, 43, 47, 51, 55, 60, 64};

constexpr unsigned weight(unsigned bits, unsigned index) {
  return bits == 2   ? weights_of_2_bits[index]
         : bits == 3 ? weights_of_3_bits[index]
                     : weights_of_4_bits[index];
}

/// The bits of a block of 16 bytes from its lowest on.
class Bits {
 public:
  explicit Bits(const std::uint8_t* block) {
    for (int i = 8; i-- > 0;) {
      low_ = low_ << 8 | block[i];
      high_ = high_ << 8 | block[i + 8];
    }
  }
  /// The next `count` bits, 0 to 8.
  unsigned take(unsigned count) {
    if (count == 0) return 0;
    const auto out = static_cast<unsigned>(low_ & ((1u << count) - 1));
    low_ = low_ >> count | high_ << (64 - count);
    high_ >>= count;
    return out;
  }

 private:
  std::uint64_t low_ = 0, high_ = 0;
};

}  // namespace etak::bptc
