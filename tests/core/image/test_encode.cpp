// SPDX-License-Identifier: Apache-2.0
#include "core/image/blocks/encode.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "core/image/blocks/bc7_block.h"
#include "core/image/blocks/bc7_settle.h"

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

namespace {

using Forms = std::array<TexelForm, 16>;

// What the texels of a block cost by the words of settle_bc7(), in another way: from the decoded codes.
double settled_cost(const BlockSource& source, const Forms& forms, const std::uint8_t* block) {
  const BlockTexels decoded = decode_block(BlockCode::bc7, block);
  double out = 0;
  for (std::size_t i = 0; i < 16; ++i) {
    std::array<double, 4> off{};
    for (std::size_t c = 0; c < 4; ++c) off[c] = source.texels[i][c] - decoded[i][c];
    double colour = 0;
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b)
        colour += double{a == b ? forms[i].weights[a] : forms[i].pairs[a + b - 1]} * off[a] * off[b];
    const double error = std::max(colour, double{forms[i].weights[3]} * off[3] * off[3]);
    out += double{source.shares[i]} * (error > 1 ? std::sqrt(error) : 0.05 * error);
  }
  return out;
}

struct SettleCase {
  BlockSource source;
  Forms forms;
};

// Ramps with noise, opaque or not, whose texels have errors of their own.
std::vector<SettleCase> settle_cases(std::size_t count) {
  std::mt19937 random(5);
  const auto code = [&](unsigned most) { return static_cast<int>(random() % (most + 1)); };
  std::vector<SettleCase> out(count);
  for (std::size_t b = 0; b < count; ++b) {
    auto& [source, forms] = out[b];
    std::array<std::array<int, 4>, 3> ends{};
    for (auto& end : ends)
      for (int& value : end) value = code(200) + 20;
    const int noise = code(16) + 1;
    for (std::size_t i = 0; i < 16; ++i) {
      const std::size_t part = b % 3 == 0 && i % 4 > 1 ? 1 : 0;
      for (std::size_t c = 0; c < 4; ++c) {
        const int line = ends[part][c] + (ends[part + 1][c] - ends[part][c]) * static_cast<int>(i) / 24;
        source.texels[i][c] = c == 3 && b % 2 == 0
                                  ? 255
                                  : static_cast<std::uint8_t>(std::clamp(
                                        line + code(static_cast<unsigned>(2 * noise)) - noise, 0, 255));
      }
      source.shares[i] = b % 5 == 0 ? static_cast<float>(code(2)) / 2 : 1;
      const float weight = static_cast<float>(code(8) + 1) / 100;
      forms[i] = {{weight, 2 * weight, weight / 2, b % 7 == 0 ? 0 : weight},
                  {weight / 3, -weight / 4, weight / 5}};
    }
  }
  return out;
}

}  // namespace

TEST_CASE("a block of BC7 of any mode that is read and stored again has the same bytes") {
  std::mt19937 random(3);
  int others = 0;
  for (unsigned b = 0; b < 100'000; ++b) {
    std::array<std::uint8_t, 16> block{}, again{};
    for (std::uint8_t& byte : block) byte = static_cast<std::uint8_t>(random());
    const unsigned mode = b % 8;
    block[0] = static_cast<std::uint8_t>((block[0] << (mode + 1) & 0xff) | 1u << mode);
    bc7::store_block(bc7::read_block(block.data()), again.data());
    others += block != again;
  }
  CHECK(others == 0);
}

TEST_CASE("settling leaves less of a block beyond the bound, less from more starts, and never more") {
  double before = 0, own = 0, some = 0;
  int worse = 0, turns = 0;
  std::set<std::size_t> modes;
  for (const auto& [source, forms] : settle_cases(600)) {
    std::array<std::uint8_t, 16> first{};
    encode_blocks(std::span(&source, 1), {BlockCode::bc7, {0.05f, 0.1f, 0.03f, 0.05f}, 2}, first.data());
    std::array<std::uint8_t, 16> settled = first, far = first, again = first;
    settle_bc7(source, forms, 0, settled.data());
    settle_bc7(source, forms, 4, far.data());
    settle_bc7(source, forms, 4, again.data());
    turns += far != again;
    const double costs[]{settled_cost(source, forms, first.data()),
                         settled_cost(source, forms, settled.data()),
                         settled_cost(source, forms, far.data())};
    constexpr double rounding = 1 + 1e-4;
    worse += costs[1] > costs[0] * rounding || costs[2] > costs[1] * rounding;
    before += costs[0], own += costs[1], some += costs[2];
    modes.insert(bc7::read_block(far.data()).mode);
  }
  CHECK(worse == 0);
  CHECK(turns == 0);
  CAPTURE(before, own, some);
  CHECK(own < 0.9 * before);
  CHECK(some < 0.8 * own);
  CHECK(modes.size() >= 5);
}

}  // namespace etak
