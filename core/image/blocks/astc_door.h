// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "core/image/blocks/blocks.h"
#include "core/image/blocks/encode.h"

namespace etak {

/// The most texels of a block of any format.
inline constexpr std::size_t most_block_texels = 64;

/// The texels of a block of any format, row by row from the top.
///   counting   bit i: something reads texel i. Where none does, all count. Encoders may let all texels count alike
///   shares     of 255, how much the errors of a texel that counts do; encoders may take them alike
///   weights    how much squared errors of its channels count
///   pairs      and products of two of them; ASTC goes without
struct AnyBlock {
  std::array<std::array<std::uint8_t, 4>, most_block_texels> texels{};
  std::uint64_t counting = 0;
  std::array<std::uint8_t, most_block_texels> shares = [] {
    std::array<std::uint8_t, most_block_texels> out{};
    out.fill(255);
    return out;
  }();
  ChannelWeights weights{1, 1, 1, 1};
  PairWeights pairs{};
};

/// How blocks of ASTC are compressed.
///   format   of block_formats, of BlockCode::astc, with at most most_block_texels texels a block
///   srgb     the codes of colour are sRGB-encoded, and decoders read them so
///   effort   1 (astcenc's "fast") to most_block_effort ("very thorough")
struct AstcEncoding {
  const BlockFormat* format = nullptr;
  bool srgb = true;
  int effort = 2;
};

/// The functions that compress and decode ASTC. The program chooses them: astc_door() of core/image/astc_codec.h, or
/// functions that load astcenc when they are first needed. Where they are empty, such textures are refused.
struct AstcDoor {
  /// Writes block_bytes of each block, in their order. The bytes of a block depend on that block and `how` alone. May
  /// be called from any thread.
  std::function<void(std::span<const AnyBlock> blocks, const AstcEncoding& how, std::uint8_t* bytes)> encode;
  /// The texels of a level as RGBA codes; a block that is an error by the format is magenta, as the Khronos Data Format
  /// Specification 1.3, 23.27 says. Throws Error that names `place`. May be called from any thread.
  ///   bytes   texture_level_bytes() of the format and the size
  std::function<Image8(std::string_view bytes, const AstcEncoding& how, int width, int height,
                       const std::string& place)>
      decode;
};

}  // namespace etak
