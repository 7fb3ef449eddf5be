// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace etak {

inline constexpr std::string_view hex_lower = "0123456789abcdef", hex_upper = "0123456789ABCDEF";

/// Appends the two digits of a byte.
///   digits   hex_lower or hex_upper
inline void append_hex(std::string& out, char byte, std::string_view digits = hex_lower) {
  const auto code = static_cast<unsigned char>(byte);
  out += digits[code >> 4];
  out += digits[code & 15];
}

/// Two digits for each byte.
inline std::string hex(std::string_view bytes) {
  std::string out;
  out.reserve(2 * bytes.size());
  for (const char byte : bytes) append_hex(out, byte);
  return out;
}

/// 16 digits.
inline std::string hex(std::uint64_t number) {
  std::string out(16, '0');
  for (std::size_t i = 16; i-- > 0; number >>= 4) out[i] = hex_lower[number & 15];
  return out;
}

}  // namespace etak
