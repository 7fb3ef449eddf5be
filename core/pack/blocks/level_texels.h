// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/image/blocks/budget.h"
#include "core/image/pixels_view.h"
#include "core/pack/blocks/block_uses.h"
#include "core/pack/blocks/compress_page.h"

namespace etak {

/// Differences between texels of a block that count and what they were.
///   share   how much of them is read
struct BlockDifferences {
  std::array<double, most_block_texels> colour, fourth;
  std::array<std::uint8_t, most_block_texels> share;
  std::size_t count = 0;
};

/// The texels of one level of a page's texture, in blocks, and what of them counts.
class LevelTexels {
 public:
  /// What is passed must outlive it.
  LevelTexels(const BlockJob& job, const BlockMeasure& measure, int level, const TexelsShown& shown);

  const BlockUses uses;
  const BlockMeasure& measure;

  /// A block's texels, with the weights of its channels. Beyond the edge of the level they repeat it and do not count.
  AnyBlock block(std::size_t number) const;
  /// How squared errors of a block's texels count, of the first 16.
  std::array<TexelForm, 16> forms(std::size_t number) const;

  /// The differences of a block that has an owner.
  ///   texels    as the block has them
  ///   returns   those beyond the budget, in budgets, summed by how much of the texels is read
  double compare(std::size_t number, const std::array<std::uint8_t, 4>* texels, BlockDifferences& to) const;

  /// Whether a material's opacity is a mask, which is kept exact.
  bool is_mask(std::size_t material) const;

 private:
  AnyBlock bare_block(std::size_t number) const;

  const BlockJob& job_;
  ConstPixelsView8 view_;
};

}  // namespace etak
