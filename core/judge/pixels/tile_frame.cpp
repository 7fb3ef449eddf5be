// SPDX-License-Identifier: Apache-2.0
#include "core/judge/pixels/tile_frame.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <cstring>

namespace etak {

namespace {

constexpr int gutter_difference = 2;  // codes

// First and last block of `side` texels whose centre lies in [begin, end).
int first_block(int begin, int side) {
  return (begin + side / 2 - 1) / side;
}
int last_block(int end, int side) {
  return (end - 1 + side / 2) / side - 1;
}

void mix(std::array<std::uint64_t, 2>& hash, const std::uint8_t* bytes, std::size_t count) {
  for (std::size_t i = 0; i < count; i += 8) {
    std::uint64_t v = 0;
    std::memcpy(&v, bytes + i, std::min<std::size_t>(8, count - i));
    hash[0] = std::rotl((hash[0] ^ v) * 0x9fb21c651e98df25u, 29);
    hash[1] = std::rotl((hash[1] + v) * 0xd6e8feb86659fd93u, 31) ^ hash[0];
  }
}

}  // namespace

TileFrame::TileFrame(const CheckTile& whole, int picture_width, int picture_height, const PassPlan& plan)
    : tile_(whole.box),
      own_(common_part(grown(whole.box, whole.own_around), {0, 0, picture_width, picture_height})),
      width_(picture_width),
      height_(picture_height),
      gutter_(plan.gutter_of(whole)),
      reach_(gutter_),
      plan_(plan) {
  const PixelBox& tile = tile_;
  for (int k = 1; k <= plan.mips_of(whole); ++k) {
    Level level;
    level.side = 1 << k;
    level.first_x = first_block(tile.x, level.side);
    level.last_x = last_block(tile.x + tile.width, level.side);
    level.first_y = first_block(tile.y, level.side);
    level.last_y = last_block(tile.y + tile.height, level.side);
    const int blocks = std::max(0, level.last_x - level.first_x + 1);
    level.page.resize(8 * static_cast<std::size_t>(blocks));
    level.alone.resize(level.page.size());
    levels_.push_back(std::move(level));
    reach_ = std::max(reach_, 1 << k);
  }
}

int TileFrame::first_row() const {
  return std::max(0, tile_.y - reach_);
}

int TileFrame::last_row() const {
  return std::min(height_, tile_.y + tile_.height + reach_) - 1;
}

void TileFrame::push(int y, const RowPointers& row) {
  for (Level& level : levels_) push_level(level, y, row);
  if (gutter_ > 0) push_gutter(y, row);
  if (plan_.hashes && y >= tile_.y && y < tile_.y + tile_.height) {
    const auto bytes = 4 * static_cast<std::size_t>(tile_.width);
    mix(hash_, row.a + 4 * tile_.x, bytes);
    mix(hash_, row.b + 4 * tile_.x, bytes);
  }
}

void TileFrame::push_level(Level& level, int y, const RowPointers& row) {
  const int block_y = y / level.side;
  if (block_y < level.first_y || block_y > level.last_y || level.first_x > level.last_x) return;
  const int top = block_y * level.side, bottom = std::min(height_, top + level.side);
  if (y == top) {
    std::fill(level.page.begin(), level.page.end(), 0);
    std::fill(level.alone.begin(), level.alone.end(), 0);
  }
  const int right = own_.x + own_.width, below = own_.y + own_.height;
  const bool edge_row = top < own_.y || bottom > below;
  // For `alone` the edge is repeated beyond what is the tile's own: edge rows and columns also get the weight of
  // the rows and columns outside.
  std::uint64_t row_weight = 0;
  if (y >= own_.y && y < below)
    row_weight = 1 + static_cast<std::uint64_t>((y == own_.y ? std::max(0, own_.y - top) : 0) +
                                                (y == below - 1 ? std::max(0, bottom - below) : 0));
  const auto& linear = plan_.tables->linear;
  const auto add_block = [&](int block_x) {
    const int x0 = block_x * level.side, x1 = std::min(width_, x0 + level.side);
    std::uint64_t* page = level.page.data() + 8 * static_cast<std::size_t>(block_x - level.first_x);
    std::uint64_t* alone = level.alone.data() + 8 * static_cast<std::size_t>(block_x - level.first_x);
    for (int x = x0; x < x1; ++x) {
      std::uint64_t weight = row_weight;
      if (x < own_.x || x >= right)
        weight = 0;
      else if (weight != 0)
        weight *= 1 + static_cast<std::uint64_t>((x == own_.x ? std::max(0, own_.x - x0) : 0) +
                                                 (x == right - 1 ? std::max(0, x1 - right) : 0));
      for (std::size_t c = 0; c < 8; ++c) {
        // The pointer is chosen in a step of its own: GCC 12 turns `(p ? a : b)[i]` into `p ? a[i] : b[i]`,
        // and with its sanitizer for undefined behaviour it computes c % 4 in the first branch only.
        const std::uint8_t* texels = c < 4 ? row.a : row.b;
        const std::uint8_t code = texels[4 * x + static_cast<int>(c % 4)];
        const std::uint64_t value = c % 4 == 3 ? code * (linear_one / 255) : linear[code];
        page[c] += value;
        alone[c] += weight * value;
      }
    }
  };
  if (edge_row) {
    for (int block = level.first_x; block <= level.last_x; ++block) add_block(block);
  } else {
    if (level.first_x * level.side < own_.x) add_block(level.first_x);
    const bool right_edge = (level.last_x + 1) * level.side > right;
    if (right_edge && (level.last_x != level.first_x || level.first_x * level.side >= own_.x))
      add_block(level.last_x);
  }
  if (y == bottom - 1) judge_row(level, block_y);
}

void TileFrame::judge_row(Level& level, int block_y) {
  const int rows = std::min(height_, (block_y + 1) * level.side) - block_y * level.side;
  for (int block = level.first_x; block <= level.last_x; ++block) {
    const int columns = std::min(width_, (block + 1) * level.side) - block * level.side;
    const double scale = 1 / (static_cast<double>(rows) * columns * linear_one);
    for (std::size_t c = 0; c < 8; ++c) {
      const std::size_t i = 8 * static_cast<std::size_t>(block - level.first_x) + c;
      const std::uint64_t a = level.page[i], b = level.alone[i];
      level.worst = std::max(level.worst, static_cast<double>(a > b ? a - b : b - a) * scale);
    }
  }
}

void TileFrame::compare_gutter(const std::uint8_t* texel, const std::uint8_t* inner, int x, int y) {
  int difference = 0;
  for (int c = 0; c < 4; ++c) difference = std::max(difference, std::abs(texel[c] - inner[c]));
  if (difference <= gutter_difference) return;
  ++wrong_;
  if (difference > worst_) {
    worst_ = difference;
    place_ = {x, y};
  }
}

void TileFrame::push_gutter(int y, const RowPointers& row) {
  const int g = gutter_;
  if (y < tile_.y - g || y >= tile_.y + tile_.height + g) return;
  const int x0 = std::max(0, tile_.x - g), x1 = std::min(width_, tile_.x + tile_.width + g);
  const auto bytes = 4 * static_cast<std::size_t>(x1 - x0);
  const auto keep = [&](std::vector<std::uint8_t>& to) {
    to.insert(to.end(), row.a + 4 * x0, row.a + 4 * x0 + bytes);
    to.insert(to.end(), row.b + 4 * x0, row.b + 4 * x0 + bytes);
  };
  const auto inner_column = [&](int x) { return std::clamp(x, tile_.x, tile_.x + tile_.width - 1); };
  if (y < tile_.y) {
    keep(above_);
    return;
  }
  if (y == tile_.y) {
    const int kept = static_cast<int>(above_.size() / (2 * bytes));
    for (int i = 0; i < kept; ++i)
      for (int x = x0; x < x1; ++x) {
        const std::uint8_t* a = above_.data() + 2 * bytes * static_cast<std::size_t>(i) + 4 * (x - x0);
        compare_gutter(a, row.a + 4 * inner_column(x), x, tile_.y - kept + i);
        compare_gutter(a + bytes, row.b + 4 * inner_column(x), x, tile_.y - kept + i);
      }
    above_.clear();
  }
  if (y < tile_.y + tile_.height) {
    for (int x = x0; x < x1; ++x) {
      if (x >= tile_.x && x < tile_.x + tile_.width) continue;
      compare_gutter(row.a + 4 * x, row.a + 4 * inner_column(x), x, y);
      compare_gutter(row.b + 4 * x, row.b + 4 * inner_column(x), x, y);
    }
    if (y == tile_.y + tile_.height - 1) keep(last_);
    return;
  }
  for (int x = x0; x < x1; ++x) {
    const std::uint8_t* inner = last_.data() + 4 * (inner_column(x) - x0);
    compare_gutter(row.a + 4 * x, inner, x, y);
    compare_gutter(row.b + 4 * x, inner + bytes, x, y);
  }
}

void TileFrame::finish(TileEvidence& evidence) const {
  evidence.gutter_wrong = wrong_;
  evidence.gutter_worst = worst_;
  evidence.gutter_place = place_;
  for (std::size_t i = 0; i < levels_.size() && i < evidence.mip_bleed.size(); ++i)
    evidence.mip_bleed[i] = levels_[i].worst;
  evidence.hash = hash_;
  evidence.hashed = plan_.hashes;
}

}  // namespace etak
