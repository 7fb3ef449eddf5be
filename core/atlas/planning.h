// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/atlas/plan.h"

namespace etak::planning {

// The parts of plan_pages(), for its own sources: the cells of regions, and where the regions were in an earlier layout.

/// Blocks that hardware compresses have so many texels a side.
inline constexpr int block_side = 4;

inline int log2_floor(int value) {
  int out = 0;
  while (value > 1) value >>= 1, ++out;
  return out;
}

inline int rounded_up(int value, int multiple) {
  return (value + multiple - 1) / multiple * multiple;
}

/// Each region with its gutter, by region.
///   align   corners and sides are multiples of it
struct Cells {
  std::vector<RectSize> sizes;
  std::vector<int> gutters, clean;
  int align = 1;
};

/// Where the texels of a region lay on a page of an earlier layout.
struct EarlierPlace {
  int page = 0, x = 0, y = 0;
  bool rotated = false;
  int gutter = 0, mips = 1;
};

/// The regions that are planned, and where they were in an earlier layout.
struct Planning {
  const std::vector<Region>& regions;
  const std::vector<std::string>& names;  // of the materials
  const PlanOptions& options;
  const AtlasLayout* previous = nullptr;               // null: none, or not to be looked at
  std::vector<std::optional<EarlierPlace>> earlier{};  // by region; none: it is new
};

/// The cell of each region.
///   clean_limit   above 0: clean mips at most
Cells cells_of(const std::vector<Region>& regions, const PlanOptions& options, bool gutters,
               int clean_limit = 0);

/// Columns of a region's cell on its page that lie left of its gutter: where a shape is turned, those by which its height was
/// rounded up.
inline int columns_left(const Region& region, const RectSize& cell, int gutter, bool outlines, bool rotated) {
  return outlines && rotated ? cell.height - region.height() - 2 * gutter : 0;
}

/// Whether one page may hold each of the regions.
bool fits(const Planning& in, const Cells& cells);

/// Throws Error for the first region that no page can hold, and says what would hold it.
void check_sizes(const Planning& in, const Cells& cells, const RectOptions& options);

/// One page holds each region, but not all of them: throws Error that says so.
[[noreturn]] void refuse_too_many(const Planning& in, const Cells& cells,
                                  const std::vector<std::size_t>& which, const RectOptions& options);

/// Where the earlier layout held what the regions hold, by region: in a rectangle of the same box, or of an outline in
/// rectangles that are one island and hold all of its texels.
std::vector<std::optional<EarlierPlace>> earlier_places(const std::vector<Region>& regions,
                                                        const std::vector<std::string>& names,
                                                        const AtlasLayout& layout);

/// Regions of the earlier layout that are the same and lie elsewhere.
std::size_t moved(const Planning& in, const PackingPlan& plan);

/// The clean mips that unchanged regions had at most; 0 where the choice of mips itself is another one now.
int earlier_limit(const Planning& in);

/// Where the cells of the same regions were, on the pages of the same kind.
///   has        the textures of these pages
///   outlines   the cells are shapes (packed by pack_masks())
std::optional<PreviousRects> previous_rects(const Planning& in, const Cells& cells,
                                            const std::vector<std::size_t>& which, std::array<bool, 2> has,
                                            bool outlines);

}  // namespace etak::planning
