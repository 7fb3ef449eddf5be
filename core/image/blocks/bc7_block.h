// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/image/blocks/bc7_tables.h"

namespace etak::bc7 {

/// The numbers that a block of BC7 is written with.
///   end      two of each part, red, green, blue and the fourth channel before the rotation, without their last bits
///   last     the last bit of all channels of an end, where the mode has one
///   index    of colours, by texel
///   second   the same of the lone fourth channel of modes 4 and 5
struct Block {
  std::size_t mode = 0, partition = 0;
  unsigned rotation = 0, selection = 0;
  std::array<std::array<unsigned, 4>, 6> end{};
  std::array<unsigned, 6> last{};
  std::array<unsigned, 16> index{}, second{};
};

/// How many bits the indices of colours have, and those of a lone channel.
unsigned index_bits(const Block& block);
unsigned second_index_bits(const Block& block);

/// The part of a block's partition in which a texel lies.
constexpr std::size_t part_of(const Block& block, std::size_t texel) {
  const unsigned subsets = modes[block.mode].subsets;
  if (subsets == 1) return 0;
  return subsets == 2 ? partitions_of_2[block.partition] >> texel & 1u
                      : partitions_of_3[block.partition] >> (2 * texel) & 3u;
}

/// The bits of a channel of an end, without the last one that channels share.
constexpr unsigned end_bits(const Block& block, std::size_t channel) {
  return channel < 3 ? modes[block.mode].colour_bits : modes[block.mode].alpha_bits;
}

/// The channel of a texel that a channel of the ends holds.
constexpr std::size_t turned(const Block& block, std::size_t channel) {
  if (block.rotation == 0) return channel;
  return channel == 3 ? block.rotation - 1 : channel == block.rotation - 1 ? 3 : channel;
}

/// A channel of an end in codes of 8 bits.
unsigned code_of(const Block& block, std::size_t end, std::size_t channel);

/// What lies between two codes, at a share of 64 of the second one.
constexpr unsigned between(unsigned first, unsigned second, unsigned share) {
  return ((64 - share) * first + share * second + 32) >> 6;
}

/// Reads 16 bytes, the first of which is not 0 (the reserved mode).
Block read_block(const std::uint8_t* bytes);

/// Writes them. The ends of a part change places where the first bit of an index, which is not stored, would be 1.
void store_block(Block block, std::uint8_t* bytes);

}  // namespace etak::bc7
