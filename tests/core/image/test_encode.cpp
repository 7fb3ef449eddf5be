// SPDX-License-Identifier: Apache-2.0
#include "core/image/blocks/encode.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

namespace etak {
namespace {

// Blocks of noise, of ramps, of two colours, of one colour and of masks; in some of them not every texel counts.
std::vector<BlockSource> encode_corpus(unsigned seed, std::size_t count) {
  std::mt19937 random(seed);
  const auto code = [&](unsigned most) { return static_cast<int>(random() % (most + 1)); };
  std::vector<BlockSource> out(count);
  for (std::size_t b = 0; b < count; ++b) {
    const std::size_t kind = b % 6;
    std::array<std::array<int, 4>, 2> ends{};
    for (auto& end : ends)
      for (int& value : end) value = code(255);
    for (std::size_t i = 0; i < 16; ++i) {
      for (std::size_t c = 0; c < 4; ++c) {
        const int ramp = ends[0][c] + (ends[1][c] - ends[0][c]) * static_cast<int>(i) / 15;
        const int value = kind == 0   ? code(255)
                          : kind == 1 ? ramp + code(12) - 6
                          : kind == 2 ? ends[random() % 2][c]
                          : kind == 3 ? ends[0][c]
                          : c < 3     ? ends[0][c] + code(20)
                          : kind == 4 ? 255
                                      : 255 * code(1);
        out[b].texels[i][c] = static_cast<std::uint8_t>(std::clamp(value, 0, 255));
      }
      if (b % 7 == 0) out[b].weights = {3, 1, 0.5f, 2};
      out[b].shares[i] = b % 5 == 0 ? static_cast<float>(code(2)) : 1;
    }
  }
  return out;
}

bool counts(const BlockSource& block, std::size_t texel) {
  return block.shares[texel] > 0 || std::ranges::all_of(block.shares, [](float share) { return share == 0; });
}
double share_of(const BlockSource& block, std::size_t texel) {
  return counts(block, texel) ? std::max(1.0, static_cast<double>(block.shares[texel])) : 0;
}

// The exact value of a texel of BC4 or of one half of BC5.
double exact_value(const std::uint8_t* block, std::size_t texel) {
  unsigned index = 0;
  for (std::size_t bit = 0; bit < 3; ++bit)
    index |= (block[2 + (3 * texel + bit) / 8] >> (3 * texel + bit) % 8 & 1u) << bit;
  const double first = block[0], second = block[1];
  if (index < 2) return index == 0 ? first : second;
  if (block[0] > block[1]) return ((8 - index) * first + (index - 1) * second) / 7;
  return index > 5 ? (index == 6 ? 0 : 255) : ((6 - index) * first + (index - 1) * second) / 5;
}

struct Encoded {
  std::vector<std::uint8_t> bytes;
  std::vector<float> errors;
  friend bool operator==(const Encoded&, const Encoded&) = default;
};
template <class Encoder>
Encoded encoded(Encoder encode, const std::vector<BlockSource>& blocks, const BlockEncoding& how) {
  Encoded out{std::vector<std::uint8_t>((how.code == BlockCode::bc4 ? 8 : 16) * blocks.size()),
              std::vector<float>(blocks.size())};
  encode(std::span(blocks), how, out.bytes.data(), out.errors.data());
  return out;
}

std::vector<BlockEncoding> encodings() {
  std::vector<BlockEncoding> out{{BlockCode::bc4}, {BlockCode::bc5, {1, 3, 1, 1}}};
  for (int effort = 1; effort <= most_block_effort; ++effort)
    out.push_back({BlockCode::bc7, {1, 2, 0.5f, 4}, effort});
  return out;
}

}  // namespace

TEST_CASE("a compressed block is decoded to the error that its encoder states") {
  const std::vector<BlockSource> blocks = encode_corpus(1, 1500);
  for (const BlockEncoding& how : encodings()) {
    CAPTURE(static_cast<int>(how.code), how.effort);
    const Encoded out = encoded(encode_blocks, blocks, how);
    int wrong = 0;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      const std::uint8_t* bytes = &out.bytes[out.bytes.size() / blocks.size() * b];
      const BlockTexels decoded = decode_block(how.code, bytes);
      double error = 0;
      for (std::size_t i = 0; i < 16; ++i)
        for (std::size_t c = 0; c < (how.code == BlockCode::bc7   ? 4u
                                     : how.code == BlockCode::bc5 ? 2u
                                                                  : 1u);
             ++c) {
          const double value = how.code == BlockCode::bc7 ? decoded[i][c] : exact_value(bytes + 8 * c, i);
          const double off = value - blocks[b].texels[i][c];
          error +=
              share_of(blocks[b], i) * static_cast<double>(how.weights[c] * blocks[b].weights[c]) * off * off;
        }
      wrong += std::abs(error - static_cast<double>(out.errors[b])) > 1e-4 * error + 1e-3 ? 1 : 0;
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("the bytes of a block depend neither on its neighbours nor on the processor") {
  std::vector<BlockSource> blocks = encode_corpus(2, 203);
  for (std::size_t b = 0; b < blocks.size(); b += 3) blocks[b].pairs = {-0.3f, 0.1f, -0.2f};
  for (const BlockEncoding& how : encodings()) {
    CAPTURE(static_cast<int>(how.code), how.effort);
    const Encoded out = encoded(encode_blocks, blocks, how);
    CHECK(encoded(encode_blocks_portable, blocks, how) == out);
#ifdef ETAK_PNG_X86_64
    if (__builtin_cpu_supports("avx2") != 0) CHECK(encoded(encode_blocks_avx2, blocks, how) == out);
#endif
    const std::size_t size = out.bytes.size() / blocks.size();
    for (std::size_t b = 0; b < blocks.size(); b += 29) {
      const Encoded alone = encoded(encode_blocks, {blocks[b]}, how);
      CHECK(std::equal(alone.bytes.begin(), alone.bytes.end(), &out.bytes[size * b]));
    }
  }
}

TEST_CASE("one colour, and masks of 0 and 255 beside one colour, are exact at every effort") {
  std::mt19937 random(3);
  std::vector<BlockSource> blocks(512);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const std::array<std::uint8_t, 4> colour{
        static_cast<std::uint8_t>(b), static_cast<std::uint8_t>(random() % 256),
        static_cast<std::uint8_t>(random() % 256), static_cast<std::uint8_t>(random() % 256)};
    for (auto& texel : blocks[b].texels) {
      texel = colour;
      if (b >= 256) texel[3] = random() % 2 == 0 ? 0 : 255;
    }
  }
  for (int effort = 1; effort <= most_block_effort; ++effort)
    for (const float error : encoded(encode_blocks, blocks, {BlockCode::bc7, {1, 1, 1, 1}, effort}).errors)
      CHECK(error == 0);
  for (BlockSource& block : blocks)
    for (auto& texel : block.texels) texel[0] = texel[3];
  for (const float error : encoded(encode_blocks, blocks, {BlockCode::bc4}).errors) CHECK(error == 0);
}

TEST_CASE("where channels count together, their errors make up for one another") {
  // Grey noise of little weight, and colours that weigh much.
  std::mt19937 random(11);
  std::vector<BlockSource> apart(600);
  for (BlockSource& block : apart) {
    block.weights = {1, 1, 1, 0.01f};
    for (auto& texel : block.texels) {
      const auto grey = 60 + random() % 100;
      for (std::size_t c = 0; c < 3; ++c) texel[c] = static_cast<std::uint8_t>(grey + random() % 30);
      texel[3] = 255;
    }
    block.shares.fill(1);
  }
  std::vector<BlockSource> together = apart;
  for (BlockSource& block : together) block.pairs = {-0.45f, -0.45f, -0.45f};
  for (int effort = 1; effort <= most_block_effort; ++effort) {
    const auto counted = [&](const std::vector<BlockSource>& blocks) {
      const Encoded out = encoded(encode_blocks, blocks, {BlockCode::bc7, {1, 1, 1, 1}, effort});
      double sum = 0;
      for (std::size_t b = 0; b < blocks.size(); ++b) {
        const BlockTexels texels = decode_block(BlockCode::bc7, &out.bytes[16 * b]);
        for (std::size_t i = 0; i < 16; ++i) {
          std::array<double, 3> off{};
          for (std::size_t c = 0; c < 3; ++c) off[c] = texels[i][c] - blocks[b].texels[i][c];
          sum += off[0] * off[0] + off[1] * off[1] + off[2] * off[2] -
                 0.9 * (off[0] * off[1] + off[0] * off[2] + off[1] * off[2]);
        }
      }
      return sum;
    };
    CAPTURE(effort);
    CHECK(counted(together) < 0.98 * counted(apart));
  }
}

TEST_CASE("more effort leaves less error, and what no triangle reads leaves none") {
  std::vector<BlockSource> blocks = encode_corpus(4, 600);
  double before = 1e30;
  for (int effort = 1; effort <= most_block_effort; ++effort) {
    double sum = 0;
    for (const float error : encoded(encode_blocks, blocks, {BlockCode::bc7, {1, 1, 1, 4}, effort}).errors)
      sum += static_cast<double>(error);
    CHECK(sum < before);
    before = sum;
  }
  // Two texels count: they are the ends of a line, at most as far off as these are rounded in mode 6.
  for (BlockSource& block : blocks) {
    block.shares.fill(0);
    block.shares[3] = block.shares[12] = 1;
  }
  for (const float error : encoded(encode_blocks, blocks, {}).errors) CHECK(error <= 8);
}

}  // namespace etak
