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
  std::size_t start = 0;  // of its length field
  std::size_t size = 0;   // of its data
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

/// The data of an IHDR chunk.
struct PngForm {
  std::uint32_t width, height;
  int bits, colour, compression, filter, interlace;
};
PngForm png_form(std::string_view ihdr);

/// Which channels a colour type has; 0 for those that PNG does not have.
int png_channels(int colour);

/// The chunk at `start`; nullopt when it is not whole.
std::optional<PngChunk> png_chunk_at(ByteSource& bytes, std::size_t start);

/// The checksum that the file has for a chunk, and that of its type and data.
std::uint32_t stored_checksum(ByteSource& bytes, const PngChunk& chunk);
std::uint32_t checksum(ByteSource& bytes, const PngChunk& chunk);

}  // namespace etak
