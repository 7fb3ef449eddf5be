// SPDX-License-Identifier: Apache-2.0
#include "core/image/blocks/blocks.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>

namespace etak {
namespace {

constexpr int block_side = 4;

std::size_t blocks_along(int texels, int side) {
  return static_cast<std::size_t>((texels + side - 1) / side);
}

std::uint64_t number_of(const std::uint8_t* bytes, int count) {
  std::uint64_t out = 0;
  for (int i = count; i-- > 0;) out = out << 8 | bytes[i];
  return out;
}

// The 8-bit code nearest to 255 * share / whole.
std::uint8_t nearest_code(unsigned share, unsigned whole) {
  return static_cast<std::uint8_t>((2 * 255 * share + whole) / (2 * whole));
}

// Colour of BC1 to BC3: two colours of 5, 6 and 5 bits, two between them, and two bits a texel. In BC1, where the
// first is not the larger number, there is one colour between them, and the fourth index is black without alpha.
void colour_block(const std::uint8_t* block, bool always_four, BlockTexels& out) {
  struct Channel {
    int shift;
    unsigned most;
  };
  constexpr std::array<Channel, 3> channels{{{11, 31}, {5, 63}, {0, 31}}};
  const auto first = static_cast<unsigned>(number_of(block, 2)),
             second = static_cast<unsigned>(number_of(block + 2, 2));
  const bool four = always_four || first > second;
  BlockTexels colours{};
  for (std::size_t c = 0; c < 3; ++c) {
    const unsigned most = channels[c].most, a = first >> channels[c].shift & most,
                   b = second >> channels[c].shift & most;
    colours[0][c] = nearest_code(a, most);
    colours[1][c] = nearest_code(b, most);
    colours[2][c] = four ? nearest_code(2 * a + b, 3 * most) : nearest_code(a + b, 2 * most);
    colours[3][c] = four ? nearest_code(a + 2 * b, 3 * most) : std::uint8_t{0};
  }
  const std::uint64_t indices = number_of(block + 4, 4);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const std::size_t index = indices >> (2 * i) & 3;
    std::copy_n(colours[index].data(), 3, out[i].data());
    if (!four && index == 3) out[i][3] = 0;
  }
}

// One channel of BC3 to BC5: two codes, six codes between them (or four, 0 and 255), and three bits a texel.
void channel_block(const std::uint8_t* block, std::size_t channel, BlockTexels& out) {
  const unsigned a = block[0], b = block[1], steps = a > b ? 7 : 5;
  std::array<std::uint8_t, 8> codes{block[0], block[1], 0, 0, 0, 0, 0, 255};
  for (unsigned i = 1; i < steps; ++i) codes[i + 1] = nearest_code((steps - i) * a + i * b, 255 * steps);
  const std::uint64_t indices = number_of(block + 2, 6);
  for (std::size_t i = 0; i < out.size(); ++i) out[i][channel] = codes[indices >> (3 * i) & 7];
}

const BlockFormat* find_format(std::uint32_t number, std::uint32_t BlockFormat::*plain,
                               std::uint32_t BlockFormat::*srgb) {
  for (const BlockFormat& each : block_formats)
    if (number != 0 && (each.*plain == number || each.*srgb == number)) return &each;
  return nullptr;
}

// A level that decode() makes of its blocks, whole as they are at its right and lower edge.
template <class Value, class Decode>
Pixels<Value> level_by(const Decode& decode, std::string_view bytes, const BlockFormat& format, int width,
                       int height) {
  assert(bytes.size() == texture_level_bytes(&format, width, height));
  Pixels<Value> out(width, height, format.channels);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes of a file
  const auto* block = reinterpret_cast<const std::uint8_t*>(bytes.data());
  for (int top = 0; top < height; top += block_side)
    for (int left = 0; left < width; left += block_side, block += format.block_bytes) {
      const auto texels = decode(block);
      for (int y = top; y < std::min(height, top + block_side); ++y)
        for (int x = left; x < std::min(width, left + block_side); ++x)
          std::copy_n(texels[static_cast<std::size_t>(block_side * (y - top) + x - left)].data(),
                      format.channels, out.at(x, y).data());
    }
  return out;
}

// The value of a half float, exact.
float float_of(std::uint16_t half) {
  const std::uint32_t exponent = half >> 10 & 31, mantissa = half & 1023;
  if (exponent == 0)
    return (half & 0x8000) != 0 ? -0x1p-24f * static_cast<float>(mantissa)
                                : 0x1p-24f * static_cast<float>(mantissa);
  const std::uint32_t wide = exponent == 31 ? 255 : exponent + 127 - 15;
  return std::bit_cast<float>((half & 0x8000u) << 16 | wide << 23 | mantissa << 13);
}

}  // namespace

const BlockFormat* block_format_of_vk(std::uint32_t vk) {
  return find_format(vk, &BlockFormat::vk, &BlockFormat::vk_srgb);
}

const BlockFormat* block_format_of_dxgi(std::uint32_t dxgi) {
  return find_format(dxgi, &BlockFormat::dxgi, &BlockFormat::dxgi_srgb);
}

std::size_t texture_level_bytes(const BlockFormat* format, int width, int height) {
  if (format == nullptr) return 4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return blocks_along(width, format->block_width) * blocks_along(height, format->block_height) *
         format->block_bytes;
}

BlockTexels decode_block(BlockCode code, const std::uint8_t* block) {
  assert(code <= BlockCode::bc7 && code != BlockCode::bc6h);
  if (code == BlockCode::bc7) return decode_bc7(block);
  BlockTexels out;
  out.fill({0, 0, 0, 255});
  switch (code) {
    case BlockCode::bc2:
      colour_block(block + 8, true, out);
      for (std::size_t i = 0; i < out.size(); ++i)
        out[i][3] = static_cast<std::uint8_t>(17 * (number_of(block, 8) >> (4 * i) & 15));
      break;
    case BlockCode::bc3:
      colour_block(block + 8, true, out);
      channel_block(block, 3, out);
      break;
    case BlockCode::bc5:
      channel_block(block + 8, 1, out);
      [[fallthrough]];
    case BlockCode::bc4:
      channel_block(block, 0, out);
      break;
    default:
      colour_block(block, false, out);
  }
  return out;
}

Image8 level_of(std::string_view bytes, const BlockFormat* format, int width, int height) {
  if (format != nullptr && format->code != BlockCode::r8)
    return level_by<std::uint8_t>(
        [format](const std::uint8_t* block) { return decode_block(format->code, block); }, bytes, *format,
        width, height);
  assert(bytes.size() == texture_level_bytes(format, width, height));
  Image8 out(width, height, format != nullptr ? format->channels : 4);
  std::memcpy(out.values.data(), bytes.data(), bytes.size());
  return out;
}

Image float_level_of(std::string_view bytes, const BlockFormat& format, int width, int height) {
  assert(holds_floats(&format));
  const auto decode = [with_sign = format.code == BlockCode::bc6h_signed](const std::uint8_t* block) {
    const BlockHalves halves = decode_bc6h(block, with_sign);
    std::array<std::array<float, 3>, 16> out;
    for (std::size_t i = 0; i < out.size(); ++i) std::ranges::transform(halves[i], out[i].data(), float_of);
    return out;
  };
  return level_by<float>(decode, bytes, format, width, height);
}

}  // namespace etak
