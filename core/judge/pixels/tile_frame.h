// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/judge/pixels/tile_pass.h"

namespace etak {

/// Checks the surroundings of a tile in its atlas: whether the gutter repeats the tile's edge (ETK505), and
/// whether the mips are free of the neighbours (ETK504). It also computes the tile's hash (ETK507). It needs
/// the rows from first_row() to last_row().
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
    // 8 sums for each block of the current block row: of the page, and of the tile with its edge repeated.
    std::vector<std::uint64_t> page, alone;
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
  // Rows of A and B with the gutter on both sides: those above the tile, and the last one of the tile.
  std::vector<std::uint8_t> above_, last_;
  std::uint64_t wrong_ = 0;
  int worst_ = 0;
  std::array<int, 2> place_{};
  std::array<std::uint64_t, 2> hash_{0x9e3779b97f4a7c15u, 0xc2b2ae3d27d4eb4fu};
};

}  // namespace etak
