// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/image/files/png.h"

namespace etak {

// Deflate is RFC 1951; the zlib stream around it is RFC 1950. deflate.cpp is the only source of etak that uses zlib and
// ISA-L (Intel's Intelligent Storage Acceleration Library, which is used where it was found when etak was built);
// deflate_without_zlib.cpp takes its place where there is neither.

/// The CRC-32 that PNG chunks use (ISO 3309), continued from `crc`, which is 0 for the first bytes.
std::uint32_t crc32_of(std::uint32_t crc, std::span<const std::uint8_t> bytes);

/// The Adler-32 checksum of `bytes`, continued from `adler`, which is 1 for the first bytes.
std::uint32_t adler32_of(std::uint32_t adler, std::span<const std::uint8_t> bytes);

/// The Adler-32 of two consecutive pieces from the Adler-32 of each; the second is `second_size` bytes long.
std::uint32_t adler32_of_both(std::uint32_t first, std::uint32_t second, std::size_t second_size);

/// The two bytes that a zlib stream begins with, as zlib writes them for its levels 1, 6 and 9. The first one (CMF) says
/// deflate with a 32 KiB window. The second one (FLG) has the class of the level, and 5 bits that make both bytes, as one
/// number, a multiple of 31.
constexpr std::array<std::uint8_t, 2> zlib_header(PngLevel level) {
  return {0x78, static_cast<std::uint8_t>(level == PngLevel::fast    ? 0x01
                                          : level == PngLevel::small ? 0x9C
                                                                     : 0xDA)};
}

/// Deflates pieces of one stream. No piece refers to another, so several threads can make them at once.
class Deflater {
 public:
  explicit Deflater(PngLevel level);
  Deflater(Deflater&&) noexcept;
  Deflater& operator=(Deflater&&) noexcept;
  ~Deflater();

  /// Appends the deflated `piece` to `out`; the output ends on a whole byte.
  ///   last   true: closes the stream (the caller writes the checksum behind it)
  void append(std::span<const std::uint8_t> piece, bool last, std::vector<std::uint8_t>& out);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Inflates a zlib stream, with its header and checksum, from input in pieces. The window is always 32 KiB:
/// some old programs write a smaller window into the header than their streams need, and whether zlib notices
/// depends on how much output is asked for with each call.
class Inflater {
 public:
  enum class Status {
    hungry,   // more input is needed: call feed()
    more,     // call read() again
    ended,    // the stream has ended and its checksum was right
    damaged,  // what() says why
  };

  Inflater();
  Inflater(Inflater&&) noexcept;
  Inflater& operator=(Inflater&&) noexcept;
  ~Inflater();

  /// Gives the next piece of the stream. The piece before must be used up (Status::hungry), and this one must
  /// stay in memory until it is.
  void feed(std::span<const std::uint8_t> input);

  /// Writes up to out.size() bytes, which must be at least 1. `written` is how many were written, with any
  /// status.
  Status read(std::span<std::uint8_t> out, std::size_t& written);

  /// How many bytes of the last piece lie behind the end of the stream.
  std::size_t unused() const;

  /// Why the stream is damaged, in words; for Status::damaged.
  const char* what() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace etak
