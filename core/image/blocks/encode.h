// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/image/blocks/blocks.h"

namespace etak {

/// How much squared errors of red, green, blue and the fourth channel count, each 0 or more.
using ChannelWeights = std::array<float, 4>;

/// How much the products of the errors of red and green, red and blue, green and blue count, twice: an error of all three
/// weighs less than alone where what they change makes up for one another. No error may count less than nothing.
using PairWeights = std::array<float, 3>;

/// The squared error of one texel: as a quadratic form of its colour, and of its fourth channel apart, each 1 where it is at
/// its bound.
struct TexelForm {
  ChannelWeights weights{1, 1, 1, 1};
  PairWeights pairs{};
};

/// A block of 4 x 4 texels to compress.
///   texels    RGBA codes, row by row from the top
///   shares    how much the error of each texel counts, 0 or more; 0 for texels that nothing reads. All 0 counts as
///             all 1
///   weights   of this block, by which those of BlockEncoding are multiplied
///   pairs     the same, by the roots of the products of two of those; of BC7 alone
struct BlockSource {
  BlockTexels texels{};
  std::array<float, 16> shares{};
  ChannelWeights weights{1, 1, 1, 1};
  PairWeights pairs{};
};

/// How blocks are compressed.
///   code      bc4 (red alone), bc5 (red and green) or bc7
///   effort    of BC7, 1 (mode 6, and mode 5 as the channels lie) to 4 (all of modes 1, 3, 4, 5, 6 and 7, and ends
///             moved one by one)
struct BlockEncoding {
  BlockCode code = BlockCode::bc7;
  ChannelWeights weights{1, 1, 1, 1};
  int effort = 2;
};
inline constexpr int most_block_effort = 4;

/// Compresses blocks. The bytes of a block depend on that block and `how` alone, and are the same on every processor.
///   bytes    block_bytes of each block, in their order
///   errors   null, or of each block the sum over its texels of share * weight * squared difference in codes between
///            the texels and the exact values of the block; of BC7 these are decode_block()'s codes, and pairs are added
///            but for those of a channel that is kept apart
void encode_blocks(std::span<const BlockSource> blocks, const BlockEncoding& how, std::uint8_t* bytes,
                   float* errors = nullptr);

// The same loops compiled for the processors that encode_blocks() chooses between, for tests.
void encode_blocks_portable(std::span<const BlockSource> blocks, const BlockEncoding& how,
                            std::uint8_t* bytes, float* errors);
void encode_blocks_avx2(std::span<const BlockSource> blocks, const BlockEncoding& how, std::uint8_t* bytes,
                        float* errors);

}  // namespace etak
