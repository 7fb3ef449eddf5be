// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace etak {

/// A fingerprint of 128 bits of a run of bytes, at memory speed: for telling equal content. Without a secret it
/// is no safety against somebody who makes collisions on purpose (that is sha256.h). The same on every machine,
/// however the bytes are cut into pieces.
///   from   XXH3, 128 bits, seed 0 (xxHash by Collet)
class ContentHash {
 public:
  static constexpr std::size_t secret_size = 192;

  /// Throws std::bad_alloc.
  ///   secret   of that size, in place of the bytes that all programs have; stays the caller's as long as this
  ///            lives; empty: none
  explicit ContentHash(std::string_view secret = {});

  void add(const void* bytes, std::size_t count);
  void add(std::string_view text) { add(text.data(), text.size()); }
  /// Adds a text as one of several: with its length, so that neighbours cannot be cut in another place.
  void add_part(std::string_view text) {
    add(std::to_string(text.size()) + ':');
    add(text);
  }

  /// High half first. More may be added afterwards.
  std::array<std::uint64_t, 2> value() const;
  std::string hex() const;  // 32 digits, as xxh128sum prints them

 private:
  struct Release {
    void operator()(void* state) const;
  };
  std::unique_ptr<void, Release> state_;  // of the library
};

/// The hash of a whole file in hexadecimal digits; empty where the file cannot be read.
std::string content_hash_of_file(const std::string& path);

}  // namespace etak
