// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/judge/pixels/tile_pass.h"

namespace etak {

/// The result of a pass over the pixels.
struct PassResult {
  std::vector<TileEvidence> tiles;  // in the order of the argument
  std::optional<FloatFacts> a_floats, b_floats;
  CheckStats stats;
};

/// Reads the pictures once, in strips of rows, and looks at the tiles. Memory: four strips of each picture,
/// and the tiles that the current strip crosses.
///   tiles       inside the pictures
///   every_row   per tile: whether its detail is taken from every row
///   plan        its number of workers never changes the result; with two or more, A and B are decoded at
///               once
PassResult pixel_pass(PictureRows& pictures, std::span<const CheckTile> tiles,
                      const std::vector<bool>& every_row, const PassPlan& plan);

}  // namespace etak
