// SPDX-License-Identifier: Apache-2.0
#include "core/pack/blocks/block_codec.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "core/base/error.h"
#include "core/base/setting.h"
#include "core/image/blocks/bc7_settle.h"
#include "core/image/blocks/encode.h"

namespace etak {
namespace {

BlockSource own_source(const AnyBlock& block, BlockCode code) {
  BlockSource out;
  for (std::size_t i = 0; i < out.texels.size(); ++i) {
    const auto& [red, green, blue, gloss] = block.texels[i];
    out.texels[i] = code == BlockCode::bc4   ? std::array<std::uint8_t, 4>{gloss, 0, 0, 0}
                    : code == BlockCode::bc5 ? std::array<std::uint8_t, 4>{red, gloss, 0, 0}
                                             : block.texels[i];
  }
  for (std::size_t i = 0; i < out.shares.size(); ++i)
    out.shares[i] = (block.counting >> i & 1) != 0 ? static_cast<float>(block.shares[i]) / 255 : 0;
  out.weights = block.weights;
  out.pairs = block.pairs;
  return out;
}

}  // namespace

void BlockCodec::encode(std::vector<AnyBlock> blocks, const BlockTry& how, std::uint8_t* bytes) const {
  if (format_.code != BlockCode::astc) {
    std::vector<BlockSource> sources(blocks.size());
    std::ranges::transform(blocks, sources.begin(),
                           [&](const AnyBlock& block) { return own_source(block, format_.code); });
    encode_blocks(sources, {format_.code, how.weights, how.effort}, bytes);
    return;
  }
  if (!astc_.encode)
    throw Error::at(setting("compress"), "this program has no encoder of ASTC", "none, auto or bc7");
  for (AnyBlock& block : blocks)
    std::ranges::transform(block.weights, how.weights, block.weights.begin(), std::multiplies());
  astc_.encode(blocks, {&format_, true, how.effort}, bytes);
}

void BlockCodec::settle(const AnyBlock& block, const std::array<TexelForm, 16>& forms, std::size_t starts,
                        std::uint8_t* bytes) const {
  settle_bc7(own_source(block, format_.code), forms, starts, bytes);
}

std::vector<std::array<std::uint8_t, 4>> BlockCodec::decode(const std::uint8_t* bytes,
                                                            std::size_t count) const {
  std::vector<std::array<std::uint8_t, 4>> out(count * texels());
  if (format_.code != BlockCode::astc) {
    for (std::size_t b = 0; b < count; ++b)
      std::ranges::copy(decode_block(format_.code, bytes + format_.block_bytes * b),
                        out.begin() + static_cast<std::ptrdiff_t>(texels() * b));
    for (auto& [red, green, blue, gloss] : out) {
      if (format_.code == BlockCode::bc4) gloss = red;
      if (format_.code == BlockCode::bc5) gloss = std::exchange(green, red), blue = red;
    }
    return out;
  }
  // A picture that is one block high, of which each column of blocks is one.
  const auto width = static_cast<std::size_t>(format_.block_width);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes of a file
  const std::string_view all(reinterpret_cast<const char*>(bytes), format_.block_bytes * count);
  const Image8 strip = astc_.decode(all, {&format_, true}, static_cast<int>(width * count),
                                    format_.block_height, setting("compress"));
  for (std::size_t b = 0; b < count; ++b)
    for (std::size_t i = 0; i < texels(); ++i) {
      const auto texel = strip.at(static_cast<int>(width * b + i % width), static_cast<int>(i / width));
      std::copy_n(texel.data(), 4, out[texels() * b + i].data());
    }
  return out;
}

}  // namespace etak
