// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/atlas/outputs.h"
#include "core/atlas/sources/sources.h"
#include "core/image/blocks/astc_door.h"
#include "core/pack/blocks/compress_options.h"
#include "core/pack/blocks/texels_shown.h"
#include "core/pack/decision.h"

namespace etak {

class PagePixels;

/// A texture of a page that was compressed, or was tried to be.
struct CompressedTexture {
  std::optional<TextureInBlocks> blocks;  // none: it stays RGBA8
  std::vector<BlockLevel> report;
};

/// What is compressed: a texture of a page whose levels are whole.
struct BlockJob {
  const PackDecision& decision;
  const std::vector<PackInput>& materials;
  int page;
  Texture texture;
  const PagePixels& pixels;
  const TexelsShown& shown;  // of level 0
  GlossForm gloss;
  const CompressOptions& how;  // with a format
  const AstcDoor& astc;
  unsigned threads;
  bool may_end = false;       // levels that miss the budget may be left to a texture of their own, as RGBA8
  bool fourth_apart = false;  // it is kept as it is beside the blocks, which hold colour alone
};

/// Compresses every level from its own exact texels. Blocks by which a material misses the budget are tried again with
/// more effort, and then with more weight on what they miss. The same for any number of threads.
CompressedTexture compress_texture(const BlockJob& job);

}  // namespace etak
