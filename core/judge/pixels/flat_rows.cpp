// SPDX-License-Identifier: Apache-2.0
#include "core/judge/pixels/flat_rows.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "core/judge/rule_check.h"

namespace etak {

namespace {

// Large enough that erosion leaves a region that counts.
constexpr int flat_side = 16;
constexpr int most_flat_in_row = 64;

// Finds the tiles of each row, from the top.
class RowsOfTiles : public RowSource {
 public:
  RowsOfTiles(const CheckTarget& target, PictureHeader header)
      : RowSource(std::move(header)), target_(target) {
    coming_.resize(target.manifest.tiles.size());
    std::iota(coming_.begin(), coming_.end(), std::size_t{0});
    std::ranges::stable_sort(coming_, std::ranges::greater{},
                             [&](std::size_t i) { return rows_of(i).first; });
  }

  void read_rows(std::uint8_t* rgba, std::size_t stride, int count) override {
    const Manifest& manifest = target_.manifest;
    for (int i = 0; i < count; ++i, ++next_, rgba += stride) {
      start_row(rgba, stride);
      find_tiles_of_row();
      for (const std::size_t at : here_) {
        const CheckTile& tile = manifest.tiles[at];
        const int gutter = tile.gutter.value_or(manifest.gutter);
        const PixelBox& box = tile.box;
        const std::span<const std::uint8_t> codes = codes_of(tile);
        const int end = std::min(header_.width, box.x + box.width + gutter);
        for (int x = std::max(0, box.x - gutter); x < end; ++x) std::ranges::copy(codes, rgba + 4 * x);
      }
    }
  }

 private:
  // What a row holds without its tiles.
  virtual void start_row(std::uint8_t* rgba, std::size_t stride) = 0;
  // The first channels of all texels of a tile.
  virtual std::span<const std::uint8_t> codes_of(const CheckTile& tile) const = 0;

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
  std::vector<std::size_t> coming_;  // tiles that begin later, the next ones at the end
  // The tiles of the current row in the manifest's order: a later one covers an earlier one.
  std::vector<std::size_t> here_;
  int next_ = 0;
};

class FlatRows : public RowsOfTiles {
 public:
  FlatRows(const CheckTarget& target, std::size_t texture, int width, int height)
      : RowsOfTiles(target, {width, height, 4}), texture_(texture) {
    header_.format = "memory";
    // Where alpha is 255 in every tile, the texture counts as one without alpha.
    if (texture == 0)
      header_.channels = std::ranges::all_of(target.manifest.tiles,
                                             [](const CheckTile& tile) { return (*tile.flat[0])[3] == 255; })
                             ? 3
                             : 4;
  }

 private:
  void start_row(std::uint8_t* rgba, std::size_t) override {
    std::memset(rgba, 0, 4 * static_cast<std::size_t>(header_.width));
  }
  std::span<const std::uint8_t> codes_of(const CheckTile& tile) const override {
    return *tile.flat[texture_];
  }

  const std::size_t texture_;
};

class SpreadRows : public RowsOfTiles {
 public:
  SpreadRows(const CheckTarget& target, std::size_t gloss, std::unique_ptr<RowSource> source)
      : RowsOfTiles(target, source->header()), gloss_(gloss), source_(std::move(source)) {
    header_.channels = 4;
    header_.colour_space = "srgb";
  }

 private:
  void start_row(std::uint8_t* rgba, std::size_t stride) override {
    source_->read_rows(rgba, stride, 1);
    for (int x = 0; x < header_.width; ++x, rgba += 4) {
      rgba[3] = rgba[gloss_];
      rgba[1] = rgba[2] = rgba[0] = gloss_ == 0 ? std::uint8_t{0} : rgba[0];
    }
  }
  std::span<const std::uint8_t> codes_of(const CheckTile& tile) const override {
    if (!tile.flat_f0) return {};
    return *tile.flat_f0;
  }

  const std::size_t gloss_;  // the channel that holds it
  const std::unique_ptr<RowSource> source_;
};

}  // namespace

std::unique_ptr<RowSource> spread_rows(const CheckTarget& target, const TargetFile& file,
                                       std::unique_ptr<RowSource> source) {
  if (!source || file.role != FileRole::specular_gloss || (file.channels != "g" && file.channels != "fg"))
    return source;
  return std::make_unique<SpreadRows>(target, file.channels.size() - 1, std::move(source));
}

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
