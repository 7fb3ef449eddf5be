// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/outline_pieces.h"

#include <algorithm>
#include <cstdint>

namespace etak {
namespace {

std::size_t index(int column, int row, int width) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
}
int units(int texels, int unit) {
  return (texels + unit - 1) / unit;
}

// The region's texels as squares of `step` texels of its box as stored, row by row.
enum BlockState : std::uint8_t { not_needed, needed, in_piece };
struct Blocks {
  int step, width, height;
  std::vector<BlockState> state;
};
Blocks blocks_of(const Region& region, int clean_levels) {
  Blocks out{1 << (clean_levels - 1), 0, 0, {}};
  const PixelBox box = stored_box(region);
  out.width = units(box.width, out.step);
  out.height = units(box.height, out.step);
  out.state.assign(index(0, out.height, out.width), not_needed);
  for (const RowRun& run : region.texels)
    for (int x = (run.begin - box.x) / out.step; x <= (run.end - 1 - box.x) / out.step; ++x)
      out.state[index(x, (run.row - box.y) / out.step, out.width)] = needed;
  return out;
}

// The region that each unit of a page belongs to.
class Owners {
 public:
  Owners(const PlannedPage& page, int unit)
      : unit_(unit),
        width_(units(page.width, unit)),
        height_(units(page.height, unit)),
        page_{0, 0, page.width, page.height},
        of_(index(0, height_, width_), nobody) {}

  void take(const MaskShape& shape, const PixelBox& cell, int region) {
    for (const RowRun& run : shape.runs)
      for (int x = run.begin; x < run.end; ++x)
        of_[index(cell.x / unit_ + x, cell.y / unit_ + run.row, width_)] = region;
  }
  void take(const PixelBox& box, int region) {
    each(box, [&](int& owner) { return owner = region, true; });
  }
  /// The box in whole units: these belong to the region of the box.
  PixelBox in_units(const PixelBox& box) const {
    const int x = box.x / unit_ * unit_, y = box.y / unit_ * unit_;
    return {x, y, units(box.x + box.width - x, unit_) * unit_, units(box.y + box.height - y, unit_) * unit_};
  }
  /// Whether the box lies on the page and holds no texel of another region.
  bool may_take(const PixelBox& box, int region) {
    return common_part(box, page_) == box &&
           each(box, [&](int owner) { return owner == nobody || owner == region; });
  }

 private:
  static constexpr int nobody = -1;

  template <class Act>
  bool each(const PixelBox& box, const Act& act) {
    for (int y = box.y / unit_; y < units(box.y + box.height, unit_); ++y)
      for (int x = box.x / unit_; x < units(box.x + box.width, unit_); ++x)
        if (!act(of_[index(x, y, width_)])) return false;
    return true;
  }

  int unit_, width_, height_;
  PixelBox page_;
  std::vector<int> of_;
};

class Cutter {
 public:
  Cutter(const Region& region, const PlannedPlace& place, int number, Owners& owners)
      : region_(region),
        place_(place),
        number_(number),
        owners_(owners),
        blocks_(blocks_of(region, place.clean_levels)) {}

  void run(int outline, PlacedRegions& out) {
    for (int y = 0; y < blocks_.height; ++y)
      for (int x = 0; x < blocks_.width; ++x) {
        if (blocks_.state[index(x, y, blocks_.width)] != needed) continue;
        const PixelBox across = grown_from({x, y, 1, 1}, true), down = grown_from({x, y, 1, 1}, false);
        const PixelBox& best = needed_in(down) > needed_in(across) ? down : across;
        for (int row = best.y; row < best.y + best.height; ++row)
          std::fill_n(blocks_.state.begin() + static_cast<std::ptrdiff_t>(index(best.x, row, blocks_.width)),
                      best.width, in_piece);
        owners_.take(cell_of(best), number_);
        add(best, outline, out);
      }
  }

 private:
  // Columns and rows of the box of the region, as stored, that some blocks are.
  PixelBox in_box(const PixelBox& blocks) const {
    const int x = blocks.x * blocks_.step, y = blocks.y * blocks_.step;
    return {x, y, std::min(region_.width() - x, blocks.width * blocks_.step),
            std::min(region_.height() - y, blocks.height * blocks_.step)};
  }
  PixelBox on_page(const PixelBox& blocks) const {
    const PixelBox box = in_box(blocks);
    if (!place_.rotated) return {place_.x + box.x, place_.y + box.y, box.width, box.height};
    return {place_.x + region_.height() - box.y - box.height, place_.y + box.x, box.height, box.width};
  }
  PixelBox cell_of(const PixelBox& blocks) const { return grown(on_page(blocks), place_.gutter); }

  // Whether a piece may grow by these blocks: no other piece has them, and no other region's texels are near.
  bool may_have(const PixelBox& blocks) const {
    for (int y = blocks.y; y < blocks.y + blocks.height; ++y)
      for (int x = blocks.x; x < blocks.x + blocks.width; ++x)
        if (blocks_.state[index(x, y, blocks_.width)] == in_piece) return false;
    return owners_.may_take(cell_of(blocks), number_);
  }

  PixelBox grown_from(PixelBox box, bool across_first) const {
    for (const bool across : {across_first, !across_first}) {
      if (across) {
        while (box.x + box.width < blocks_.width && may_have({box.x + box.width, box.y, 1, box.height}))
          ++box.width;
        while (box.x > 0 && may_have({box.x - 1, box.y, 1, box.height})) --box.x, ++box.width;
      } else {
        while (box.y + box.height < blocks_.height && may_have({box.x, box.y + box.height, box.width, 1}))
          ++box.height;
        while (box.y > 0 && may_have({box.x, box.y - 1, box.width, 1})) --box.y, ++box.height;
      }
    }
    return box;
  }

  int needed_in(const PixelBox& box) const {
    int out = 0;
    for (int y = box.y; y < box.y + box.height; ++y)
      for (int x = box.x; x < box.x + box.width; ++x)
        out += blocks_.state[index(x, y, blocks_.width)] == needed ? 1 : 0;
    return out;
  }

  void add(const PixelBox& blocks, int outline, PlacedRegions& out) const {
    const PixelBox box = in_box(blocks), page = on_page(blocks);
    Region& piece = out.regions.emplace_back(region_);
    piece.texels.clear();
    piece.outline = outline;
    const int level = region_.shrink;
    piece.box = {region_.box.x + (box.x << level), region_.box.y + (box.y << level), box.width << level,
                 box.height << level};
    PlannedPlace& place = out.places.emplace_back(place_);
    place.x = page.x;
    place.y = page.y;
    place.cell = owners_.in_units(cell_of(blocks));
    place.cell_texels = 0;
  }

  const Region& region_;
  const PlannedPlace& place_;
  int number_;
  Owners& owners_;
  Blocks blocks_;
};

}  // namespace

MaskShape cell_shape(const Region& region, int gutter, int clean_levels, int unit) {
  const int width = region.width() + 2 * gutter, height = region.height() + 2 * gutter;
  MaskShape out{units(width, unit), units(height, unit), {}};
  if (region.texels.empty()) {
    for (int y = 0; y < out.height; ++y) out.runs.push_back({y, 0, out.width});
    return out;
  }
  const Blocks blocks = blocks_of(region, clean_levels);
  std::vector<std::uint8_t> taken(index(0, out.height, out.width), 0);
  // Block i takes the texels of the cell from i * step to the end of its gutter on the other side.
  const auto first = [&](int block) { return block * blocks.step / unit; };
  const auto end = [&](int block, int most) {
    return units(std::min(most, (block + 1) * blocks.step + 2 * gutter), unit);
  };
  RowRuns rows;
  for (int y = 0; y < blocks.height; ++y)
    add_row(rows, y, 0, blocks.width,
            [&](int x) { return blocks.state[index(x, y, blocks.width)] == needed; });
  for (const RowRun& run : rows)
    for (int y = first(run.row); y < end(run.row, height); ++y)
      std::fill(taken.begin() + static_cast<std::ptrdiff_t>(index(first(run.begin), y, out.width)),
                taken.begin() + static_cast<std::ptrdiff_t>(index(end(run.end - 1, width), y, out.width)),
                std::uint8_t{1});
  for (int y = 0; y < out.height; ++y)
    add_row(out.runs, y, 0, out.width, [&](int x) { return taken[index(x, y, out.width)] != 0; });
  return out;
}

PlacedRegions outline_pieces(const std::vector<Region>& regions, const PackingPlan& plan) {
  if (plan.shapes.empty()) return {regions, plan.places};
  std::vector<Owners> pages;
  for (const PlannedPage& page : plan.pages) pages.emplace_back(page, plan.unit);
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const PlannedPlace& place = plan.places[i];
    const MaskShape& shape = plan.shapes[i];
    if (!regions[i].own_page)
      pages[static_cast<std::size_t>(place.page)].take(place.rotated ? turned(shape) : shape, place.cell,
                                                       static_cast<int>(i));
  }
  PlacedRegions out;
  int outlines = 0;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const PlannedPlace& place = plan.places[i];
    if (regions[i].texels.empty() || regions[i].own_page) {
      out.regions.push_back(regions[i]);
      out.places.push_back(place);
    } else {
      Cutter(regions[i], place, static_cast<int>(i), pages[static_cast<std::size_t>(place.page)])
          .run(++outlines, out);
    }
  }
  return out;
}

}  // namespace etak
