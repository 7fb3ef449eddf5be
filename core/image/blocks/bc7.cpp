// SPDX-License-Identifier: Apache-2.0
// Decodes BC7. Based on chapter 20 (BPTC) of the Khronos Data Format Specification 1.3.
#include <utility>

#include "core/image/blocks/bc7_tables.h"
#include "core/image/blocks/blocks.h"
#include "core/image/blocks/bptc.h"

namespace etak {
namespace {

using namespace bc7;
using bptc::Bits, bptc::weight;

using Ends = std::array<std::array<unsigned, 4>, 6>;  // two for each subset, RGBA, in codes of 8 bits

// Widens `value` of `bits` bits to 8, by repeating its first bits.
unsigned widened(unsigned value, unsigned bits) {
  value <<= 8 - bits;
  return value | value >> bits;
}

Ends read_ends(const Mode& mode, Bits& bits) {
  Ends ends{};
  const std::size_t count = 2 * mode.subsets;
  const auto width = [&](std::size_t c) { return c < 3 ? mode.colour_bits : mode.alpha_bits; };
  for (std::size_t c = 0; c < 4; ++c)
    for (std::size_t e = 0; e < count; ++e) ends[e][c] = bits.take(width(c));
  const unsigned p_bits = mode.own_p || mode.shared_p ? 1 : 0;
  unsigned p = 0;
  for (std::size_t e = 0; e < count; ++e) {
    if (mode.own_p || (mode.shared_p && e % 2 == 0)) p = bits.take(1);
    for (std::size_t c = 0; c < 4; ++c)
      ends[e][c] = width(c) == 0 ? 255 : widened(ends[e][c] << p_bits | p, width(c) + p_bits);
  }
  return ends;
}

std::uint8_t between(unsigned first, unsigned second, unsigned share) {
  return static_cast<std::uint8_t>(((64 - share) * first + share * second + 32) >> 6);
}

}  // namespace

BlockTexels decode_bc7(const std::uint8_t* block) {
  BlockTexels out{};
  if (block[0] == 0) return out;  // the reserved mode
  Bits bits(block);
  std::size_t number = 0;
  while (bits.take(1) == 0) ++number;
  const Mode& mode = modes[number];
  const unsigned partition = bits.take(mode.partition_bits), rotation = bits.take(mode.rotation_bits),
                 selection = bits.take(mode.selection_bits);
  const Ends ends = read_ends(mode, bits);

  const auto subset_of = [&](std::size_t i) -> std::size_t {
    if (mode.subsets == 1) return 0;
    return mode.subsets == 2 ? partitions_of_2[partition] >> i & 1u
                             : partitions_of_3[partition] >> (2 * i) & 3u;
  };
  const auto is_anchor = [&](std::size_t i) {
    const std::size_t subset = subset_of(i);
    if (subset == 0) return i == 0;
    return i == (mode.subsets == 2 ? anchors_of_2[partition] : anchors_of_3[subset - 1][partition]);
  };
  std::array<unsigned, 16> first{}, second{};
  for (std::size_t i = 0; i < 16; ++i) first[i] = bits.take(mode.index_bits - (is_anchor(i) ? 1 : 0));
  if (mode.second_index_bits != 0)
    for (std::size_t i = 0; i < 16; ++i) second[i] = bits.take(mode.second_index_bits - (i == 0 ? 1 : 0));
  for (std::size_t i = 0; i < 16; ++i) {
    unsigned colour = weight(mode.index_bits, first[i]), alpha = colour;
    if (mode.second_index_bits != 0) alpha = weight(mode.second_index_bits, second[i]);
    if (selection != 0) std::swap(colour, alpha);
    const auto &a = ends[2 * subset_of(i)], &b = ends[2 * subset_of(i) + 1];
    for (std::size_t c = 0; c < 4; ++c) out[i][c] = between(a[c], b[c], c < 3 ? colour : alpha);
    if (rotation != 0) std::swap(out[i][3], out[i][rotation - 1]);
  }
  return out;
}

}  // namespace etak
