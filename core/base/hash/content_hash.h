// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace etak {

/// A fingerprint of 128 bits of a run of bytes, at memory speed: for telling equal content, not for safety
/// against somebody who makes collisions on purpose. The same on every machine, however the bytes are cut
/// into pieces whose sizes are multiples of 32 (only the last may be odd).
class ContentHash {
 public:
  void add(const void* bytes, std::size_t count);
  void add(std::string_view text) { add(text.data(), text.size()); }

  /// Length included.
  std::array<std::uint64_t, 2> value() const;
  std::string hex() const;  // 32 digits

 private:
  std::array<std::uint64_t, 4> lanes_{0x243f6a8885a308d3, 0x13198a2e03707344, 0xa4093822299f31d0,
                                      0x082efa98ec4e6c89};  // first fraction bits of pi
  std::uint64_t length_ = 0;
};

}  // namespace etak
