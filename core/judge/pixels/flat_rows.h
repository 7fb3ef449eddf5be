// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/judge/target.h"

namespace etak {

/// The rows of a texture that an atlas has left out, because it is constant in every tile: each tile and the
/// gutter around it have the tile's constant codes, and all other texels are 0, so that they are hidden. By
/// this the constants are judged like texels.
///   texture         0 diffuse, 1 specular
///   width, height   of the page; 0: just what the tiles reach
/// Null when some tile has no codes for it.
std::unique_ptr<RowSource> flat_rows(const CheckTarget& target, std::size_t texture, int width, int height);

/// The rows of F0 and gloss of `source`, the decoded rows of `file`, where that has no more channels than its materials read
/// (TargetFile::channels): F0 is what the tiles say where it is constant. Other sources come back as they are.
std::unique_ptr<RowSource> spread_rows(const CheckTarget& target, const TargetFile& file,
                                       std::unique_ptr<RowSource> source);

/// Gives the tiles of materials that are on no page places of their own, in rows.
void place_flat_tiles(Manifest& manifest);

/// Removes such a place from a finding, which is about constants.
void forget_place(Finding& finding);

}  // namespace etak
