// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/image/channels.h"

namespace etak {

/// What compression may change of a material: the 99th percentile over the texels that it reads, level by level.
///   diffuse, f0   CIEDE2000
///   gloss         percent of the exponent
///   alpha         percent of coverage; of materials with a mask no texel may change sides, whatever this says
struct BlockBudget {
  double diffuse = 1, f0 = 1, gloss = 10, alpha = 0.5;
  friend bool operator==(const BlockBudget&, const BlockBudget&) = default;
};

/// Reads "2" (twice the usual budget) or a list such as "gloss=5,alpha=1", which keeps what it does not name. Throws
/// Error that names the setting.
BlockBudget parse_block_budget(const std::string& text);

/// What becomes of the textures of KTX2 and DDS files.
///   bc7         blocks of BC7, whatever the error
///   automatic   the same for those textures of a page on which every material stays within the budget
enum class Compression { none, bc7, automatic };

/// How textures are compressed.
struct CompressOptions {
  Compression how = Compression::none;
  BlockBudget budget;
  int effort = 2;  // BlockEncoding::effort of the first try
};

/// What compression does to the texels of a material on one level of a texture, in the units of BlockBudget. Materials
/// that read the same texels are told by the name of the first.
struct BlockMaterial {
  std::string id;
  double colour_p99 = 0, colour_largest = 0, fourth_p99 = 0, fourth_largest = 0;
  bool met = true;  // the budget
};

/// One level of a texture that was compressed, or was tried to be.
///   fallback   some material did not keep to the budget, and the texture is written as RGBA8
///   escalated  blocks that took more than the first try
struct BlockLevel {
  int page = 0;
  Texture texture = Texture::diffuse_alpha;
  int level = 0;
  std::string format;                 // as it is written: "BC7" or "RGBA8"
  std::size_t bytes = 0, texels = 0;  // the same
  double seconds = 0;                 // of compressing alone
  std::size_t blocks = 0, escalated = 0, shared = 0;
  std::vector<BlockMaterial> materials;
  bool fallback = false;
};

}  // namespace etak
