// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace etak {

// What deflate.h says of the functions and the class of the same names, without any library.
std::uint32_t plain_crc32(std::uint32_t crc, std::span<const std::uint8_t> bytes);
std::uint32_t plain_adler32(std::uint32_t adler, std::span<const std::uint8_t> bytes);
std::uint32_t plain_adler32_of_both(std::uint32_t first, std::uint32_t second, std::size_t second_size);

/// Deflates pieces of one stream by the fixed codes of RFC 1951: some tenths larger than zlib makes them.
class PlainDeflater {
 public:
  void append(std::span<const std::uint8_t> piece, bool last, std::vector<std::uint8_t>& out);

 private:
  std::vector<std::uint32_t>
      places_;  // behind the newest place where four bytes of that hash were; 0: nowhere
};

}  // namespace etak
