// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/image/files/png.h"

namespace etak {

// The one door to zlib and ISA-L (Intel's Intelligent Storage Acceleration Library; used where it was found
// when etak was built). Deflate is RFC 1951, the stream around it RFC 1950.

/// CRC-32 of PNG chunks (ISO 3309), continued from `crc`; 0 to begin with.
std::uint32_t crc32_of(std::uint32_t crc, std::span<const std::uint8_t> bytes);

/// Adler-32, continued from `adler`; 1 to begin with.
std::uint32_t adler32_of(std::uint32_t adler, std::span<const std::uint8_t> bytes);

/// Adler-32 of two pieces one behind the other, the second `second_size` bytes long.
std::uint32_t adler32_of_both(std::uint32_t first, std::uint32_t second, std::size_t second_size);

/// The two bytes a zlib stream begins with, as zlib's own levels 1, 6 and 9 have them.
std::span<const std::uint8_t, 2> zlib_header(PngLevel level);

/// Deflates pieces of one stream, each without looking at the others, so that they can be made side by side.
class Deflater {
 public:
  explicit Deflater(PngLevel level);
  Deflater(Deflater&&) noexcept;
  Deflater& operator=(Deflater&&) noexcept;
  ~Deflater();

  /// Appends the deflated `piece` to `out`, ending on a whole byte.
  ///   last   closes the stream (the checksum behind it is the caller's)
  void append(std::span<const std::uint8_t> piece, bool last, std::vector<std::uint8_t>& out);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Inflates a zlib stream that comes in pieces, header and checksum included. The window is always 32 KiB:
/// some old programs write a smaller one into the header than their streams need, and whether zlib notices
/// depends on how its output is cut.
class Inflater {
 public:
  enum class Status {
    hungry,   // wants more input
    more,     // call again
    ended,    // the stream has ended and its checksum was right
    damaged,  // what() says why
  };

  Inflater();
  Inflater(Inflater&&) noexcept;
  Inflater& operator=(Inflater&&) noexcept;
  ~Inflater();

  /// The next piece of the stream, once the one before is used up (Status::hungry); must stay where it is
  /// until then.
  void feed(std::span<const std::uint8_t> input);

  /// Writes up to out.size() bytes (at least 1); `written` says how many, whatever the status.
  Status read(std::span<std::uint8_t> out, std::size_t& written);

  /// How much of the last piece fed has not been looked at: what lies behind the end of the stream.
  std::size_t unused() const;

  const char* what() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace etak
