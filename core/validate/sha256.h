// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace etak {

/// SHA-256 (FIPS 180-4): tells in a report which bytes were judged, so that others can check it with their
/// own tools.
class Sha256 {
 public:
  void add(std::string_view bytes);

  /// 64 hexadecimal digits of all that was added; the last call.
  std::string finish();

 private:
  void block(const std::uint8_t* bytes);

  std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<std::uint8_t, 64> rest_{};
  std::size_t rest_size_ = 0;
  std::uint64_t length_ = 0;
};

/// Of a whole file; empty when it cannot be read.
std::string sha256_of_file(const std::string& path);

}  // namespace etak
