// SPDX-License-Identifier: Apache-2.0
#include "core/image/files/png_chunks.h"

#include <algorithm>
#include <span>

#include "core/image/files/deflate.h"
#include "core/image/files/png.h"

namespace etak {
namespace {

// A chunk may be as long as the file: it is summed in pieces that stay in the second-level cache.
constexpr std::size_t piece_bytes = std::size_t{64} << 10;

}  // namespace

std::uint32_t big_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t out = 0;
  for (std::size_t i = 0; i < 4; ++i) out = out << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return out;
}

std::optional<PngChunk> png_chunk_at(ByteSource& bytes, std::size_t start) {
  if (start > bytes.size() || bytes.size() - start < png_chunk_overhead) return std::nullopt;
  const std::string_view head = bytes.view(start, 8);
  const std::size_t size = big_endian(head, 0);
  if (size > bytes.size() - start - png_chunk_overhead) return std::nullopt;
  return PngChunk{start, size, std::string(head.substr(4))};
}

bool has_png_signature(ByteSource& bytes) {
  return bytes.size() >= png_signature.size() && bytes.view(0, png_signature.size()) == png_signature;
}

std::uint32_t stored_checksum(ByteSource& bytes, const PngChunk& chunk) {
  return big_endian(bytes.view(chunk.end() - 4, 4), 0);
}

std::uint32_t checksum(ByteSource& bytes, const PngChunk& chunk) {
  std::uint32_t out = 0;
  for (std::size_t at = chunk.start + 4, left = chunk.size + 4; left > 0;) {
    const std::size_t take = std::min(left, piece_bytes);
    out = crc32_of(out, octets(bytes.view(at, take)));
    at += take;
    left -= take;
  }
  return out;
}

PngColour png_colour(std::string_view in_memory) {
  PngColour out;
  BytesInMemory bytes(in_memory);
  if (!has_png_signature(bytes)) return out;
  for (auto chunk = png_chunk_at(bytes, png_signature.size()); chunk && chunk->type != "IDAT";
       chunk = png_chunk_at(bytes, chunk->end())) {
    if (chunk->type == "sRGB") out.srgb = true;
    if (chunk->type == "iCCP") out.icc_profile = true;
    if (chunk->type == "gAMA" && chunk->size == 4)
      out.gamma = big_endian(bytes.view(chunk->data(), 4), 0) / 1e5;
  }
  return out;
}

}  // namespace etak
