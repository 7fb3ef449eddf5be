// SPDX-License-Identifier: Apache-2.0
// Decodes BC6H. Based on chapter 20 (BPTC) of the Khronos Data Format Specification 1.3 and on the BC6H format of
// Direct3D 11.
#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "core/image/blocks/bc7_tables.h"
#include "core/image/blocks/blocks.h"
#include "core/image/blocks/bptc.h"

namespace etak {
namespace {

// The bits behind the number of a mode, from the lowest on, as the tables of the specification have them: r, g or b, one
// of the ends w and x of the first subset, y and z of the second, and its bits, the last of which comes first in the
// block.
constexpr std::array<std::string_view, 14> mode_layouts{
    "gy4 by4 bz4 rw9:0 gw9:0 bw9:0 rx4:0 gz4 gy3:0 gx4:0 bz0 gz3:0 bx4:0 bz1 by3:0 ry4:0 bz2 rz4:0 bz3",
    "gy5 gz4 gz5 rw6:0 bz0 bz1 by4 gw6:0 by5 bz2 gy4 bw6:0 bz3 bz5 bz4 rx5:0 gy3:0 gx5:0 gz3:0 bx5:0 by3:0 ry5:0 rz5:0",
    "rw9:0 gw9:0 bw9:0 rx4:0 rw10 gy3:0 gx3:0 gw10 bz0 gz3:0 bx3:0 bw10 bz1 by3:0 ry4:0 bz2 rz4:0 bz3",
    "rw9:0 gw9:0 bw9:0 rx3:0 rw10 gz4 gy3:0 gx4:0 gw10 gz3:0 bx3:0 bw10 bz1 by3:0 ry3:0 bz0 bz2 rz3:0 gy4 bz3",
    "rw9:0 gw9:0 bw9:0 rx3:0 rw10 by4 gy3:0 gx3:0 gw10 bz0 gz3:0 bx4:0 bw10 by3:0 ry3:0 bz1 bz2 rz3:0 bz4 bz3",
    "rw8:0 by4 gw8:0 gy4 bw8:0 bz4 rx4:0 gz4 gy3:0 gx4:0 bz0 gz3:0 bx4:0 bz1 by3:0 ry4:0 bz2 rz4:0 bz3",
    "rw7:0 gz4 by4 gw7:0 bz2 gy4 bw7:0 bz3 bz4 rx5:0 gy3:0 gx4:0 bz0 gz3:0 bx4:0 bz1 by3:0 ry5:0 rz5:0",
    "rw7:0 bz0 by4 gw7:0 gy5 gy4 bw7:0 gz5 bz4 rx4:0 gz4 gy3:0 gx5:0 gz3:0 bx4:0 bz1 by3:0 ry4:0 bz2 rz4:0 bz3",
    "rw7:0 bz1 by4 gw7:0 by5 gy4 bw7:0 bz5 bz4 rx4:0 gz4 gy3:0 gx4:0 bz0 gz3:0 bx5:0 by3:0 ry4:0 bz2 rz4:0 bz3",
    "rw5:0 gz4 bz0 bz1 by4 gw5:0 gy5 by5 bz2 gy4 bw5:0 gz5 bz3 bz5 bz4 rx5:0 gy3:0 gx5:0 gz3:0 bx5:0 by3:0 ry5:0 rz5:0",
    "rw9:0 gw9:0 bw9:0 rx9:0 gx9:0 bx9:0",
    "rw9:0 gw9:0 bw9:0 rx8:0 rw10 gx8:0 gw10 bx8:0 bw10",
    "rw9:0 gw9:0 bw9:0 rx7:0 rw10:11 gx7:0 gw10:11 bx7:0 bw10:11",
    "rw9:0 gw9:0 bw9:0 rx3:0 rw10:15 gx3:0 gw10:15 bx3:0 bw10:15"};
constexpr std::size_t modes_of_2_subsets = 10, first_plain_mode = 9, last_plain_mode = 10;

// Where the bits behind the number of a mode belong, in the order of the block.
//   width   bits of each end's channels
struct ModeLayout {
  struct Bit {
    std::uint8_t end, channel, place;
  };
  std::array<Bit, 75> bits{};
  std::size_t count = 0;
  std::array<std::array<std::uint8_t, 3>, 4> width{};
};

constexpr ModeLayout parsed_layout(std::string_view text) {
  ModeLayout out;
  std::size_t at = 0;
  const auto number = [&] {
    int value = 0;
    for (; at < text.size() && text[at] >= '0' && text[at] <= '9'; ++at) value = 10 * value + text[at] - '0';
    return value;
  };
  const auto byte = [](auto value) { return static_cast<std::uint8_t>(value); };
  for (; at < text.size(); ++at) {
    const std::uint8_t channel = byte(std::string_view("rgb").find(text[at++]));
    const std::uint8_t end = byte(std::string_view("wxyz").find(text[at++]));
    const int last = number(), first = at < text.size() && text[at] == ':' ? (++at, number()) : last;
    const int step = first <= last ? 1 : -1;
    for (int place = first; place != last + step; place += step) {
      out.bits[out.count++] = {end, channel, byte(place)};
      out.width[end][channel] = std::max(out.width[end][channel], byte(place + 1));
    }
  }
  return out;
}

constexpr auto parsed_layouts = [] {
  std::array<ModeLayout, mode_layouts.size()> out{};
  std::ranges::transform(mode_layouts, out.begin(), parsed_layout);
  return out;
}();

// A number in two's complement of `bits` bits.
int with_its_sign(int value, unsigned bits) {
  const int top = 1 << (bits - 1);
  return ((value & (2 * top - 1)) ^ top) - top;
}

using LineEnds = std::array<std::array<int, 3>, 4>;

// LineEnds of `bits` bits in 16 bits, or in 15 with a sign.
int widened_end(int value, unsigned bits, bool with_sign) {
  if (!with_sign) {
    if (bits >= 15 || value == 0) return value;
    return value == (1 << bits) - 1 ? 0xffff : ((value << 16) + 0x8000) >> bits;
  }
  if (bits >= 16 || value == 0) return value;
  const int size = std::abs(value);
  const int wide = size >= (1 << (bits - 1)) - 1 ? 0x7fff : ((size << 15) + 0x4000) >> (bits - 1);
  return value < 0 ? -wide : wide;
}

LineEnds read_line_ends(const ModeLayout& layout, bool two, bool differences, bool with_sign,
                        bptc::Bits& bits) {
  LineEnds ends{};
  for (std::size_t i = 0; i < layout.count; ++i) {
    const auto& [end, channel, place] = layout.bits[i];
    ends[end][channel] |= static_cast<int>(bits.take(1) << place);
  }
  for (std::size_t e = 0; e < (two ? 4u : 2u); ++e)
    for (std::size_t c = 0; c < 3; ++c) {
      const unsigned width = layout.width[0][c];
      int& end = ends[e][c];
      if (e > 0 && differences)
        end = (ends[0][c] + with_its_sign(end, layout.width[e][c])) & ((1 << width) - 1);
      if (with_sign) end = with_its_sign(end, width);
    }
  for (auto& end : ends)
    for (std::size_t c = 0; c < 3; ++c) end[c] = widened_end(end[c], layout.width[0][c], with_sign);
  return ends;
}

}  // namespace

BlockHalves decode_bc6h(const std::uint8_t* block, bool with_sign) {
  BlockHalves out{};
  bptc::Bits bits(block);
  // Numbers of two bits are 0 and 1; to 2 and 3 three bits more belong.
  std::size_t mode = bits.take(2);
  if (mode >= 2) mode = bits.take(3) + (mode == 2 ? 2u : modes_of_2_subsets);
  if (mode >= parsed_layouts.size()) return out;  // reserved
  const bool two = mode < modes_of_2_subsets, differences = mode < first_plain_mode || mode > last_plain_mode;
  const LineEnds ends = read_line_ends(parsed_layouts[mode], two, differences, with_sign, bits);
  const unsigned partition = two ? bits.take(5) : 0, index_bits = two ? 3 : 4;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const bool anchor = i == 0 || (two && i == bc7::anchors_of_2[partition]);
    const auto share = static_cast<int>(bptc::weight(index_bits, bits.take(index_bits - (anchor ? 1 : 0))));
    const std::size_t subset = two ? bc7::partitions_of_2[partition] >> i & 1u : 0u;
    for (std::size_t c = 0; c < 3; ++c) {
      const int value = ((64 - share) * ends[2 * subset][c] + share * ends[2 * subset + 1][c] + 32) >> 6;
      // 31 / 64 of 16 bits, or 31 / 32 of 15 bits, are the bits of half floats up to the largest that is finite.
      const int half = !with_sign ? value * 31 >> 6 : value < 0 ? 0x8000 | -value * 31 >> 5 : value * 31 >> 5;
      out[i][c] = static_cast<std::uint16_t>(half);
    }
  }
  return out;
}

}  // namespace etak
