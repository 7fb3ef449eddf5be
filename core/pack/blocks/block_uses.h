// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/pack/blocks/texels_shown.h"
#include "core/pack/decision.h"

namespace etak {

/// What the blocks of one level of a page hold, of one of its textures.
///   owner    by block the material that reads its texels; none: no material reads this level there
///   used     by texel, how much of it materials read, 255: all; gutters, what lies between regions and what no triangle
///            reads are 0
///   shared   blocks that hold texels of two regions with their gutters, on levels whose texels are of one region each
struct BlockUses {
  int across = 0, down = 0;
  std::vector<std::optional<std::uint32_t>> owner;
  std::vector<std::uint8_t> used;
  std::size_t shared = 0;
};

///   side    of the blocks, which are square
///   shown   of the level
BlockUses block_uses(const PackDecision& decision, const TexelsShown& shown, int page, Texture texture,
                     int level, int side);

}  // namespace etak
