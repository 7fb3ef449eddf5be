// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/image/image.h"

namespace etak {

/// The ways in which a texture for a GPU keeps blocks of texels. R8 is one channel as it is, a block a texel.
enum class BlockCode { bc1, bc2, bc3, bc4, bc5, bc6h, bc7, bc6h_signed, astc, r8 };

/// A format of textures in blocks, with the numbers by which the headers of files name it; 0: it has none.
struct BlockFormat {
  std::string_view name;
  BlockCode code;
  std::size_t block_bytes;
  int channels;                   // of the decoded picture; see decode_block()
  std::uint32_t vk, vk_srgb;      // VkFormat, in KTX2
  std::uint32_t dxgi, dxgi_srgb;  // DXGI_FORMAT, in DDS
  int block_width = 4, block_height = 4;
};

inline constexpr std::array block_formats{
    BlockFormat{"BC1 without alpha", BlockCode::bc1, 8, 3, 131, 132, 0, 0},
    BlockFormat{"BC1", BlockCode::bc1, 8, 4, 133, 134, 71, 72},
    BlockFormat{"BC2", BlockCode::bc2, 16, 4, 135, 136, 74, 75},
    BlockFormat{"BC3", BlockCode::bc3, 16, 4, 137, 138, 77, 78},
    BlockFormat{"BC4", BlockCode::bc4, 8, 1, 139, 0, 80, 0},
    BlockFormat{"BC5", BlockCode::bc5, 16, 3, 141, 0, 83, 0},
    BlockFormat{"BC6H", BlockCode::bc6h, 16, 3, 143, 0, 95, 0},
    BlockFormat{"BC6H signed", BlockCode::bc6h_signed, 16, 3, 144, 0, 96, 0},
    BlockFormat{"BC7", BlockCode::bc7, 16, 4, 145, 146, 98, 99},
    BlockFormat{"ASTC 4x4", BlockCode::astc, 16, 4, 157, 158, 0, 0, 4, 4},
    BlockFormat{"ASTC 5x4", BlockCode::astc, 16, 4, 159, 160, 0, 0, 5, 4},
    BlockFormat{"ASTC 5x5", BlockCode::astc, 16, 4, 161, 162, 0, 0, 5, 5},
    BlockFormat{"ASTC 6x5", BlockCode::astc, 16, 4, 163, 164, 0, 0, 6, 5},
    BlockFormat{"ASTC 6x6", BlockCode::astc, 16, 4, 165, 166, 0, 0, 6, 6},
    BlockFormat{"ASTC 8x5", BlockCode::astc, 16, 4, 167, 168, 0, 0, 8, 5},
    BlockFormat{"ASTC 8x6", BlockCode::astc, 16, 4, 169, 170, 0, 0, 8, 6},
    BlockFormat{"ASTC 8x8", BlockCode::astc, 16, 4, 171, 172, 0, 0, 8, 8},
    BlockFormat{"R8", BlockCode::r8, 1, 1, 9, 0, 61, 0, 1, 1}};

inline double bits_per_texel(const BlockFormat& format) {
  return 8 * static_cast<double>(format.block_bytes) / (format.block_width * format.block_height);
}

/// Whether blocks hold floats in linear light (BC6H); those of all other formats, and RGBA8, which null stands for, hold
/// codes.
constexpr bool holds_floats(const BlockFormat* format) {
  return format != nullptr && (format->code == BlockCode::bc6h || format->code == BlockCode::bc6h_signed);
}

/// The row of block_formats whose number in KTX2 or DDS files this is, for sRGB-encoded colour or not; null for
/// others.
const BlockFormat* block_format_of_vk(std::uint32_t vk);
const BlockFormat* block_format_of_dxgi(std::uint32_t dxgi);
/// The same by its name.
constexpr const BlockFormat* block_format_named(std::string_view name) {
  for (const BlockFormat& each : block_formats)
    if (each.name == name) return &each;
  return nullptr;
}

/// The bytes of one mip level. Blocks at the right and the lower edge are whole where the level is not.
///   format   null: four bytes a texel
std::size_t texture_level_bytes(const BlockFormat* format, int width, int height);

/// The 16 texels of a block of BC1 to BC5 and BC7 as RGBA codes, row by row from the top, as a GPU samples them: what a format does not
/// hold is 0 in colour and 255 in alpha, so that BC5 has red and green alone and BC4 red. Every row of bytes is a block. BC7
/// is exact. Formats whose values lie between codes (BC1 to BC5) give the code nearest to the exact value.
///   block   block_bytes bytes
///   from    Khronos Data Format Specification 1.3, chapters 18 to 20 (S3TC, RGTC, BPTC); Direct3D 11.3 functional
///           specification, 19.5. A reserved mode of BC7 gives 0 in all channels
using BlockTexels = std::array<std::array<std::uint8_t, 4>, 16>;
BlockTexels decode_block(BlockCode code, const std::uint8_t* block);
BlockTexels decode_bc7(const std::uint8_t* block);

/// The 16 texels of a block of BC6H: red, green and blue as the bits of half floats, row by row from the top, exact. The
/// reserved modes give 0. Blocks without sign reach 0x7bff, 65504, the largest that is finite; those with sign reach
/// it and, from an end of -0x8000, minus infinity, as the arithmetic of the specification has it.
///   block       16 bytes
///   with_sign   of BC6H signed
///   from        as decode_block()
using BlockHalves = std::array<std::array<std::uint16_t, 3>, 16>;
BlockHalves decode_bc6h(const std::uint8_t* block, bool with_sign);

/// The texels of one mip level, with as many channels as the format has.
///   bytes    texture_level_bytes() bytes
///   format   null: RGBA8; any other but ASTC, which AstcDoor decodes, and those of float_level_of()
Image8 level_of(std::string_view bytes, const BlockFormat* format, int width, int height);
/// The same of a format that holds_floats().
Image float_level_of(std::string_view bytes, const BlockFormat& format, int width, int height);

}  // namespace etak
