// SPDX-License-Identifier: Apache-2.0
// Reads, writes and decodes BC7. Based on chapter 20 (BPTC) of the Khronos Data Format Specification 1.3.
#include <utility>

#include "core/image/blocks/bc7_block.h"
#include "core/image/blocks/blocks.h"
#include "core/image/blocks/bptc.h"

namespace etak {
namespace bc7 {
namespace {

using bptc::Bits;

// The bits of a block, from the lowest on.
class BlockBits {
 public:
  void add(unsigned value, unsigned bits) {
    if (at_ < 64) {
      low_ |= static_cast<std::uint64_t>(value) << at_;
      if (at_ + bits > 64) high_ |= static_cast<std::uint64_t>(value) >> (64 - at_);
    } else {
      high_ |= static_cast<std::uint64_t>(value) << (at_ - 64);
    }
    at_ += bits;
  }
  void store(std::uint8_t* out) const {
    for (std::size_t i = 0; i < 8; ++i) {
      out[i] = static_cast<std::uint8_t>(low_ >> (8 * i));
      out[8 + i] = static_cast<std::uint8_t>(high_ >> (8 * i));
    }
  }

 private:
  std::uint64_t low_ = 0, high_ = 0;
  unsigned at_ = 0;
};

// The texel of a part whose index has one bit less.
std::size_t anchor_of(const Block& block, std::size_t part) {
  if (part == 0) return 0;
  return modes[block.mode].subsets == 2 ? anchors_of_2[block.partition]
                                        : anchors_of_3[part - 1][block.partition];
}

bool is_anchor(const Block& block, std::size_t texel) {
  return texel == anchor_of(block, part_of(block, texel));
}

// Ends of a line change places where the index of its anchor needs it.
//   first, end   the channels of the line
void turn(Block& block, std::array<unsigned, 16>& index, unsigned bits, std::size_t part, std::size_t first,
          std::size_t end) {
  const unsigned greatest = (1u << bits) - 1;
  if (index[anchor_of(block, part)] <= greatest / 2) return;
  for (std::size_t c = first; c < end; ++c) std::swap(block.end[2 * part][c], block.end[2 * part + 1][c]);
  std::swap(block.last[2 * part], block.last[2 * part + 1]);
  for (std::size_t i = 0; i < index.size(); ++i)
    if (part_of(block, i) == part) index[i] = greatest - index[i];
}

}  // namespace

unsigned index_bits(const Block& block) {
  const Mode& mode = modes[block.mode];
  return block.selection != 0 ? mode.second_index_bits : mode.index_bits;
}

unsigned second_index_bits(const Block& block) {
  const Mode& mode = modes[block.mode];
  return block.selection != 0 ? mode.index_bits : mode.second_index_bits;
}

unsigned code_of(const Block& block, std::size_t end, std::size_t channel) {
  const Mode& mode = modes[block.mode];
  unsigned bits = end_bits(block, channel), value = block.end[end][channel];
  if (bits == 0) return 255;
  if (mode.own_p || mode.shared_p) value = value << 1 | block.last[end], ++bits;
  // Widened by repeating its first bits.
  value <<= 8 - bits;
  return value | value >> bits;
}

Block read_block(const std::uint8_t* bytes) {
  Block out;
  Bits bits(bytes);
  while (bits.take(1) == 0) ++out.mode;
  const Mode& mode = modes[out.mode];
  out.partition = bits.take(mode.partition_bits);
  out.rotation = bits.take(mode.rotation_bits);
  out.selection = bits.take(mode.selection_bits);
  const std::size_t ends = 2 * mode.subsets;
  for (std::size_t c = 0; c < 4; ++c)
    for (std::size_t e = 0; e < ends; ++e) out.end[e][c] = bits.take(end_bits(out, c));
  for (std::size_t e = 0; e < ends; ++e)
    if (mode.own_p || (mode.shared_p && e % 2 == 0))
      out.last[e] = bits.take(1);
    else if (mode.shared_p)
      out.last[e] = out.last[e - 1];
  for (std::size_t i = 0; i < out.index.size(); ++i)
    out.index[i] = bits.take(mode.index_bits - (is_anchor(out, i) ? 1 : 0));
  if (mode.second_index_bits != 0)
    for (std::size_t i = 0; i < out.second.size(); ++i)
      out.second[i] = bits.take(mode.second_index_bits - (i == 0 ? 1 : 0));
  if (out.selection != 0) std::swap(out.index, out.second);
  return out;
}

void store_block(Block block, std::uint8_t* bytes) {
  const Mode& mode = modes[block.mode];
  const bool split = mode.second_index_bits != 0;
  for (std::size_t part = 0; part < mode.subsets; ++part)
    turn(block, block.index, index_bits(block), part, 0, split ? 3 : 4);
  if (split) turn(block, block.second, second_index_bits(block), 0, 3, 4);
  BlockBits bits;
  bits.add(1u << block.mode, static_cast<unsigned>(block.mode) + 1);
  bits.add(static_cast<unsigned>(block.partition), mode.partition_bits);
  bits.add(block.rotation, mode.rotation_bits);
  bits.add(block.selection, mode.selection_bits);
  const std::size_t ends = 2 * mode.subsets;
  for (std::size_t c = 0; c < 4; ++c)
    for (std::size_t e = 0; e < ends; ++e)
      if (end_bits(block, c) > 0) bits.add(block.end[e][c], end_bits(block, c));
  for (std::size_t e = 0; e < ends; ++e)
    if (mode.own_p || (mode.shared_p && e % 2 == 0)) bits.add(block.last[e], 1);
  if (block.selection != 0) std::swap(block.index, block.second);
  for (std::size_t i = 0; i < block.index.size(); ++i)
    bits.add(block.index[i], mode.index_bits - (is_anchor(block, i) ? 1 : 0));
  if (split)
    for (std::size_t i = 0; i < block.second.size(); ++i)
      bits.add(block.second[i], mode.second_index_bits - (i == 0 ? 1 : 0));
  bits.store(bytes);
}

}  // namespace bc7

BlockTexels decode_bc7(const std::uint8_t* block) {
  BlockTexels out{};
  if (block[0] == 0) return out;  // the reserved mode
  const bc7::Block from = bc7::read_block(block);
  std::array<std::array<unsigned, 4>, 6> ends{};
  for (std::size_t e = 0; e < 2 * bc7::modes[from.mode].subsets; ++e)
    for (std::size_t c = 0; c < 4; ++c) ends[e][c] = bc7::code_of(from, e, c);
  const unsigned bits = bc7::index_bits(from), second_bits = bc7::second_index_bits(from);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const unsigned colour = bptc::weight(bits, from.index[i]),
                   fourth = second_bits == 0 ? colour : bptc::weight(second_bits, from.second[i]);
    const std::size_t part = bc7::part_of(from, i);
    for (std::size_t c = 0; c < 4; ++c)
      out[i][bc7::turned(from, c)] = static_cast<std::uint8_t>(
          bc7::between(ends[2 * part][c], ends[2 * part + 1][c], c < 3 ? colour : fourth));
  }
  return out;
}

}  // namespace etak
