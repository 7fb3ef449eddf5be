// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/files/input.h"
#include "core/base/system.h"

namespace etak {

/// SHA-256 (FIPS 180-4): tells in a report which bytes were judged, so that others can check it with their
/// own tools, and tells in a cache which bytes a result belongs to, also against somebody who makes
/// collisions on purpose.
class Sha256 {
 public:
  void add(std::string_view bytes);

  /// 64 hexadecimal digits of all that was added; this or finish_bytes() is the last call.
  std::string finish();
  /// The hash of all that was added, as 32 bytes.
  std::string finish_bytes();

 private:
  std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<std::uint8_t, 64> rest_{};
  std::size_t rest_size_ = 0;
  std::uint64_t length_ = 0;
};

std::string sha256(std::string_view bytes);

/// The hash of a whole file; empty when the file cannot be read.
///   info   what was known of the file before its bytes were read
std::string sha256_of_file(const std::string& path);
std::string sha256_of_file(const std::string& path, sys::FileInfo& info, SeenAsFile seen = SeenAsFile::no);

/// HMAC-SHA-256 (RFC 2104) of `bytes`: 64 hexadecimal digits that nobody can make without the key.
///   key   of any length; 32 random bytes are enough
std::string hmac_sha256(std::string_view key, std::string_view bytes);

/// Whether two digests are equal, in a time that does not depend on where they differ.
bool same_digest(std::string_view a, std::string_view b);

}  // namespace etak
