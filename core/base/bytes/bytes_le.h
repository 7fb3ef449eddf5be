// SPDX-License-Identifier: Apache-2.0
#pragma once

// Little-endian numbers in files.

#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace etak::bytes_le {

inline void append(std::string& out, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out.push_back(static_cast<char>(value >> (8 * i) & 0xff));
}
inline void append32(std::string& out, std::uint64_t value) {
  append(out, value, 4);
}
inline void append64(std::string& out, std::uint64_t value) {
  append(out, value, 8);
}
inline void append_float(std::string& out, float value) {
  append32(out, std::bit_cast<std::uint32_t>(value));
}

/// The caller has looked whether the bytes are there.
inline std::uint64_t number(std::string_view bytes, std::size_t at, int count) {
  assert(at + static_cast<std::size_t>(count) <= bytes.size());
  std::uint64_t value = 0;
  // One load, where GCC would build the number byte by byte.
  if constexpr (std::endian::native == std::endian::little)
    std::memcpy(&value, bytes.data() + at, static_cast<std::size_t>(count));
  else
    for (int i = count; i-- > 0;)
      value = value << 8 | static_cast<std::uint8_t>(bytes[at + static_cast<std::size_t>(i)]);
  return value;
}
inline std::uint32_t number32(std::string_view bytes, std::size_t at) {
  return static_cast<std::uint32_t>(number(bytes, at, 4));
}
inline std::uint64_t number64(std::string_view bytes, std::size_t at) {
  return number(bytes, at, 8);
}

}  // namespace etak::bytes_le
