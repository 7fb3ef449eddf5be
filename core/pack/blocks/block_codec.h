// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/image/blocks/astc_door.h"

namespace etak {

/// How hard blocks are tried.
///   effort    1 to most_block_effort
///   weights   by which those of each block are multiplied
///   settles   of BC7: what a block is so far is settled, from so many other starts too (core/image/blocks/bc7_settle.h)
struct BlockTry {
  int effort = 2;
  ChannelWeights weights{1, 1, 1, 1};
  std::optional<std::size_t> settles = {};
};

/// Compresses and decodes blocks of one format, sRGB-encoded: BC4, BC5 and BC7 by etak's own encoder, ASTC by the program's
/// door. BC5 holds gloss and the red of F0, which is read as grey; BC4 holds gloss alone, and its F0 means nothing.
/// Both throw Error where a format has no encoder. They may be called from any thread.
class BlockCodec {
 public:
  BlockCodec(const BlockFormat& format, const AstcDoor& astc) : format_(format), astc_(astc) {}

  const BlockFormat& format() const { return format_; }
  std::size_t texels() const {  // of a block
    return static_cast<std::size_t>(format_.block_width) * static_cast<std::size_t>(format_.block_height);
  }
  /// Writes block_bytes of each block, in their order. They depend on that block and `how` alone.
  void encode(std::vector<AnyBlock> blocks, const BlockTry& how, std::uint8_t* bytes) const;
  /// Settles a block of BC7 where it lies.
  ///   forms   of its texels
  void settle(const AnyBlock& block, const std::array<TexelForm, 16>& forms, std::size_t starts,
              std::uint8_t* bytes) const;
  /// The texels of `count` blocks, one block behind the other, with texels() each.
  std::vector<std::array<std::uint8_t, 4>> decode(const std::uint8_t* bytes, std::size_t count) const;

 private:
  const BlockFormat& format_;
  const AstcDoor& astc_;
};

}  // namespace etak
