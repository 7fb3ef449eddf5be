// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/validate/pixels/tile_pass.h"

namespace etak {

/// What lies around a tile in its atlas, and whether the tile is kept clean of it: gutter (ETK505), mips
/// (ETK504); and the tile's hash (ETK507). Sees the rows from reach() above the tile to reach() below it.
class TileFrame {
 public:
  TileFrame(const CheckTile& tile, int picture_width, int picture_height, const PassPlan& plan);

  int first_row() const;
  int last_row() const;  // inclusive

  /// Row y of the picture, whole; y ascends by 1 from first_row().
  void push(int y, const RowPointers& row);

  void finish(TileEvidence& evidence) const;

 private:
  /// The blocks of one mip level that lie partly outside of what is the tile's own but whose centre is in
  /// the tile.
  struct Level {
    int side = 2;
    int first_x = 0, last_x = 0, first_y = 0, last_y = 0;  // of all blocks with their centre inside
    std::vector<std::uint64_t> page, alone;                // 8 sums per block of the current block row
    double worst = 0;
  };
  void push_level(Level& level, int y, const RowPointers& row);
  void judge_row(Level& level, int block_y);
  void push_gutter(int y, const RowPointers& row);
  void compare_gutter(const std::uint8_t* texel, const std::uint8_t* inner, int x, int y);

  PixelBox tile_;
  PixelBox own_;  // with what is its own around it
  int width_, height_, gutter_, reach_;
  const PassPlan& plan_;
  std::vector<Level> levels_;
  std::vector<std::uint8_t> above_, last_;  // rows of A and B, the gutter's width on both sides
  std::uint64_t wrong_ = 0;
  int worst_ = 0;
  std::array<int, 2> place_{};
  std::array<std::uint64_t, 2> hash_{0x9e3779b97f4a7c15u, 0xc2b2ae3d27d4eb4fu};
};

}  // namespace etak
