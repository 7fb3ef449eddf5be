// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/files/steady_file.h"

namespace etak {

// The chunks that a PNG file is made of (W3C, "Portable Network Graphics", section 5).

inline constexpr std::string_view png_signature("\x89PNG\r\n\x1a\n", 8);
inline constexpr std::size_t png_chunk_overhead = 12;  // length, type, checksum

struct PngChunk {
  std::size_t start = 0;  // offset of the length field, with which a chunk begins
  std::size_t size = 0;   // of the data, in bytes
  std::string type;

  std::size_t data() const { return start + 8; }
  std::size_t end() const { return start + png_chunk_overhead + size; }
  bool critical() const { return (static_cast<unsigned char>(type[0]) & 32) == 0; }
};

/// Four bytes as a number, the most significant first.
std::uint32_t big_endian(std::string_view bytes, std::size_t at);

inline std::span<const std::uint8_t> octets(std::string_view bytes) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): characters as bytes
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

bool has_png_signature(ByteSource& bytes);

/// The fields of an IHDR chunk. `colour` is the colour type, and `bits` the bit depth.
struct PngForm {
  std::uint32_t width, height;
  int bits, colour, compression, filter, interlace;
};
PngForm png_form(std::string_view ihdr);

/// How many channels a colour type has; 0 for colour types that PNG does not define.
int png_channels(int colour);

/// The chunk that begins at `start`; nullopt when the file ends before the chunk does.
std::optional<PngChunk> png_chunk_at(ByteSource& bytes, std::size_t start);

/// The checksum that the file stores for a chunk, and the checksum of its type and data as they are.
std::uint32_t stored_checksum(ByteSource& bytes, const PngChunk& chunk);
std::uint32_t checksum(ByteSource& bytes, const PngChunk& chunk);

}  // namespace etak
