// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/image/blocks/encode.h"

namespace etak {

/// Moves the ends of a block of BC7 step by step, as long as less of its texels is beyond the bound: the sum of their shares,
/// each times the error where that is above 1, the larger one of colour and of the fourth channel. Keeps the block where
/// nothing better is found. The bytes depend on the arguments alone.
///   source   its weights and pairs are not read: `forms` takes their place, by texel
///   starts   0: from the block's own ends; else also from those of so many partitions, rotations and modes whose first ends
///            are nearest
///   block    16 bytes of a mode that is not the reserved one
void settle_bc7(const BlockSource& source, const std::array<TexelForm, 16>& forms, std::size_t starts,
                std::uint8_t* block);

}  // namespace etak
