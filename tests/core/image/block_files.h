// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "core/base/bytes/bytes_le.h"
#include "core/image/blocks/blocks.h"

/// KTX2 and DDS files of textures in blocks, written after the specifications without the writers of core.
namespace etak::test {

/// The levels of a texture, as bytes of whole blocks.
struct BlockTexture {
  int width = 0, height = 0;
  std::vector<std::string> levels;
};

inline std::string random_bytes(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::string out(count, '\0');
  std::ranges::generate(out, [&] { return static_cast<char>(random() & 0xff); });
  return out;
}

/// Random blocks with all mips. Every ninth block of BC7 has the reserved mode, the others have each mode in turn; every
/// ninth block of ASTC is of one colour (a void extent), and no other has that mode with reserved bits of its own.
inline BlockTexture random_blocks(const BlockFormat& format, int width, int height, unsigned seed) {
  BlockTexture out{width, height, {}};
  for (int w = width, h = height;; w = std::max(1, w / 2), h = std::max(1, h / 2)) {
    const auto blocks = texture_level_bytes(&format, w, h) / format.block_bytes;
    std::string bytes = random_bytes(blocks * format.block_bytes, seed++);
    if (format.name == "BC7")
      for (std::size_t i = 0; i < blocks; ++i) {
        auto first = static_cast<unsigned char>(bytes[16 * i]);
        const unsigned mode = static_cast<unsigned>(i % 9);
        bytes[16 * i] = static_cast<char>(mode == 8 ? 0 : (first >> mode | 1) << mode);
      }
    for (std::size_t i = 0; format.code == BlockCode::astc && i < blocks; ++i) {
      char* const block = &bytes[16 * i];
      const bool extent = block[0] == '\xfc' && (block[1] & 1) != 0;
      if (i % 9 == 8) block[0] = '\xfc';
      if (extent || i % 9 == 8) {
        block[1] = static_cast<char>(block[1] | 0xfd);  // bit 9 tells colours of 16 bits from half floats
        std::fill_n(block + 2, 6, '\xff');
      }
    }
    out.levels.push_back(bytes);
    if (w == 1 && h == 1) return out;
  }
}

/// A Zstandard frame (RFC 8878) that holds the bytes, fewer than 128 KiB, as they are.
inline std::string raw_zstd(const std::string& bytes) {
  std::string out("\x28\xb5\x2f\xfd\xa0", 5);  // one segment, with the size in four bytes
  bytes_le::append32(out, bytes.size());
  bytes_le::append(out, bytes.size() << 3 | 1, 3);  // the last block, raw
  return out + bytes;
}

/// The data format descriptor of a format in blocks, in words of 32 bits (Khronos Data Format 1.3, chapter 5).
///   samples   {first bit, bits, channel} of each
///   sides     of a block, each less 1: the height in bits 8 to 15, the width in bits 0 to 7
///   range     of a sample's values
inline std::string block_descriptor(unsigned model, bool srgb, unsigned block_bytes,
                                    const std::vector<std::array<unsigned, 3>>& samples,
                                    unsigned sides = 0x0303u,
                                    std::array<unsigned, 2> range = {0, 0xffffffffu}) {
  const auto size = static_cast<unsigned>(24 + 16 * samples.size());
  std::string out;
  for (const unsigned word :
       {size + 4, 0u, size << 16 | 2, (srgb ? 2u : 1u) << 16 | 1u << 8 | model, sides, block_bytes, 0u})
    bytes_le::append32(out, word);
  for (const auto& each : samples)
    for (const unsigned word : {each[2] << 24 | (each[1] - 1) << 16 | each[0], 0u, range[0], range[1]})
      bytes_le::append32(out, word);
  return out;
}

/// A KTX2 file of the Vulkan format, smallest level first, without key/value data.
inline std::string ktx2_of(const BlockTexture& texture, unsigned vk, const std::string& descriptor,
                           bool zstd) {
  const std::size_t count = texture.levels.size(), descriptor_at = 80 + 24 * count;
  std::string head("\xabKTX 20\xbb\r\n\x1a\n", 12);
  for (const std::size_t word :
       {std::size_t{vk}, std::size_t{1}, static_cast<std::size_t>(texture.width),
        static_cast<std::size_t>(texture.height), std::size_t{0}, std::size_t{0}, std::size_t{1}, count,
        std::size_t{zstd ? 2u : 0u}, descriptor_at, descriptor.size(), std::size_t{0}, std::size_t{0}})
    bytes_le::append32(head, word);
  head.append(16, '\0');
  std::string data = descriptor, index;
  for (std::size_t l = count; l-- > 0;) {
    while ((descriptor_at + data.size()) % 16 != 0) data.push_back('\0');
    const std::string level = zstd ? raw_zstd(texture.levels[l]) : texture.levels[l];
    std::string entry;
    bytes_le::append64(entry, descriptor_at + data.size());
    bytes_le::append64(entry, level.size());
    bytes_le::append64(entry, texture.levels[l].size());
    index = entry + index;
    data += level;
  }
  return head + index + data;
}

/// A DDS file: under a DX10 header where `dxgi` is not 0, else with the four characters of Direct3D 9.
inline std::string dds_of(const BlockTexture& texture, std::string_view four_cc, unsigned dxgi) {
  std::string out("DDS ");
  const std::size_t count = texture.levels.size();
  for (const std::size_t word :
       {std::size_t{124}, std::size_t{0xa1007}, static_cast<std::size_t>(texture.height),
        static_cast<std::size_t>(texture.width), texture.levels[0].size(), std::size_t{0}, count})
    bytes_le::append32(out, word);
  out.append(44, '\0');
  bytes_le::append32(out, 32);
  bytes_le::append32(out, 4);
  out += dxgi != 0 ? std::string_view("DX10") : four_cc;
  out.append(20, '\0');
  bytes_le::append32(out, 0x401008);
  out.append(16, '\0');
  if (dxgi != 0)
    for (const unsigned word : {dxgi, 3u, 0u, 1u, 0u}) bytes_le::append32(out, word);
  for (const std::string& level : texture.levels) out += level;
  return out;
}

}  // namespace etak::test
