// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/image/blocks/blocks.h"
#include "core/image/blocks/budget.h"
#include "core/image/channels.h"
#include "core/image/image.h"

namespace etak {

/// Reads "2" (twice the usual budget) or a list such as "gloss=5,alpha=1", which keeps what it does not name. Throws
/// Error that names the setting.
BlockBudget parse_block_budget(const std::string& text);

/// What becomes of the textures of KTX2 and DDS files.
///   format       BC7 or ASTC, of square blocks; null: they stay RGBA8
///   falls_back   textures of a page on which some material does not keep to the budget stay RGBA8 all the same
///   fits         F0 and gloss are in BC4 or BC5 on pages on which that holds all that materials read (fitting_format())
///   once         blocks by which a material misses the budget are not tried again
///   effort       of the first try, as encode_blocks() and AstcEncoding have it
struct CompressOptions {
  const BlockFormat* format = nullptr;
  bool falls_back = false, fits = false, once = false;
  BlockBudget budget;
  int effort = 2;
};

/// The options of a word: none, bc7, astc:4x4, astc:5x5, astc:6x6 or astc:8x8; with a fallback auto (BC7,
/// and what fits) and astc (4x4).
CompressOptions compress_word(std::string_view word);

/// How far a material looks from what it was under light, CIEDE2000 and the mean of FLIP (core/pack/blocks/shaded.h).
struct BlockShaded {
  double p99 = 0, largest = 0, flip = 0;
};

/// What compression does to the texels of a material on one level of a texture, in the units of BlockBudget. Materials
/// that read the same texels are told by the name of the first.
struct BlockMaterial {
  std::size_t number = 0;  // among those of the input
  std::string id;
  double colour_p99 = 0, colour_largest = 0, fourth_p99 = 0, fourth_largest = 0;
  bool met = true;                    // the budget
  std::optional<BlockShaded> shaded;  // with both textures, on level 0 of those in blocks
};

/// One level of a texture that was compressed, or was tried to be.
///   fallback       some material did not keep to the budget, and the texture is written as RGBA8
///   fourth_apart   the fourth channel is as it is, in R8 beside the blocks; `bytes` counts both
///   tail           some material did not on this level, which is not the first: this level and all that are smaller are RGBA8
///                  in a texture of their own
///   escalated      blocks that took more than the first try
struct BlockLevel {
  int page = 0;
  Texture texture = Texture::diffuse_alpha;
  int level = 0;
  std::string tried;                  // the name of the format of blocks
  std::string format;                 // as it is written: the same, or "RGBA8"
  std::size_t bytes = 0, texels = 0;  // the same
  double seconds = 0;                 // of compressing alone
  std::size_t blocks = 0, escalated = 0, shared = 0;
  std::vector<BlockMaterial> materials;
  bool fallback = false, fourth_apart = false, tail = false;
};

/// A part of a material under light, as its textures are and as their blocks hold them (core/pack/blocks/shaded.h).
///   x, y          its place on the page, in texels
///   degrees       between the normal and the direction from which it is seen
///   difference    CIEDE2000 as grey: black for none, white for white_difference and more
struct BlockPicture {
  int page = 0;
  std::string material;
  BlockShaded shaded;
  int x = 0, y = 0;
  double degrees = 0;
  Image8 exact, held, difference;  // of one size, red, green and blue
};
inline constexpr double white_difference = 4;

}  // namespace etak
