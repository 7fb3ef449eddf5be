// SPDX-License-Identifier: Apache-2.0
#include "core/judge/pixels/flat_rows.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

#include "core/judge/rule_check.h"

namespace etak {

namespace {

// Large enough that erosion leaves a region that counts.
constexpr int flat_side = 16;
constexpr int most_flat_in_row = 64;

class FlatRows : public RowSource {
 public:
  FlatRows(const CheckTarget& target, std::size_t texture, int width, int height)
      : RowSource({width, height, 4}), target_(target), texture_(texture) {
    header_.format = "memory";
    // Where alpha is 255 in every tile, the texture counts as one without alpha.
    if (texture == 0)
      header_.channels = std::ranges::all_of(target.manifest.tiles,
                                             [](const CheckTile& tile) { return (*tile.flat[0])[3] == 255; })
                             ? 3
                             : 4;
    coming_.resize(target.manifest.tiles.size());
    std::iota(coming_.begin(), coming_.end(), std::size_t{0});
    std::ranges::stable_sort(coming_, std::ranges::greater{},
                             [&](std::size_t i) { return rows_of(i).first; });
  }

  void read_rows(std::uint8_t* rgba, std::size_t stride, int count) override {
    const Manifest& manifest = target_.manifest;
    for (int i = 0; i < count; ++i, ++next_, rgba += stride) {
      std::memset(rgba, 0, 4 * static_cast<std::size_t>(header_.width));
      find_tiles_of_row();
      for (const std::size_t at : here_) {
        const CheckTile& tile = manifest.tiles[at];
        const int gutter = tile.gutter.value_or(manifest.gutter);
        const PixelBox& box = tile.box;
        const int end = std::min(header_.width, box.x + box.width + gutter);
        for (int x = std::max(0, box.x - gutter); x < end; ++x)
          std::memcpy(rgba + 4 * x, tile.flat[texture_]->data(), 4);
      }
    }
  }

 private:
  // The first row that a tile covers, and the one behind the last.
  std::pair<int, int> rows_of(std::size_t at) const {
    const CheckTile& tile = target_.manifest.tiles[at];
    const int gutter = tile.gutter.value_or(target_.manifest.gutter);
    return {tile.box.y - gutter, tile.box.y + tile.box.height + gutter};
  }

  // Takes in the tiles that begin at the next row and drops those that end before it.
  void find_tiles_of_row() {
    std::erase_if(here_, [&](std::size_t at) { return rows_of(at).second <= next_; });
    const std::size_t before = here_.size();
    for (; !coming_.empty() && rows_of(coming_.back()).first <= next_; coming_.pop_back())
      if (rows_of(coming_.back()).second > next_) here_.push_back(coming_.back());
    if (here_.size() > before) std::ranges::sort(here_);
  }

  const CheckTarget& target_;
  const std::size_t texture_;
  std::vector<std::size_t> coming_;  // tiles that begin later, the next ones at the end
  // The tiles of the current row in the manifest's order: a later one covers an earlier one.
  std::vector<std::size_t> here_;
  int next_ = 0;
};

}  // namespace

std::unique_ptr<RowSource> flat_rows(const CheckTarget& target, std::size_t texture, int width, int height) {
  const auto& tiles = target.manifest.tiles;
  if (tiles.empty() || std::ranges::any_of(tiles, [&](const CheckTile& tile) { return !tile.flat[texture]; }))
    return nullptr;
  if (width == 0)
    for (const CheckTile& tile : tiles) {
      width = std::max(width, tile.box.x + tile.box.width);
      height = std::max(height, tile.box.y + tile.box.height);
    }
  return std::make_unique<FlatRows>(target, texture, width, height);
}

void place_flat_tiles(Manifest& manifest) {
  for (std::size_t i = 0; i < manifest.tiles.size(); ++i) {
    CheckTile& tile = manifest.tiles[i];
    tile.box = {flat_side * static_cast<int>(i % most_flat_in_row),
                flat_side * static_cast<int>(i / most_flat_in_row), flat_side, flat_side};
    tile.gutter = 0;
    tile.mips = 0;
  }
}

void forget_place(Finding& finding) {
  const std::string area = " on " + area_text(finding.area_px, std::size_t{flat_side} * flat_side);
  if (const std::size_t at = finding.message.find(area); at != finding.message.npos)
    finding.message.erase(at, area.size());
  finding.box.reset();
  finding.area_px = 0;
  finding.area_share = 0;
}

}  // namespace etak
