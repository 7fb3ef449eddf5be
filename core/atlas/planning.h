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

/// The regions that are planned, and where they were in an earlier layout.
struct Planning {
  const std::vector<Region>& regions;
  const std::vector<std::string>& names;  // of the materials
  const PlanOptions& options;
  const AtlasLayout* previous = nullptr;    // null: none, or not to be looked at
  std::vector<const AtlasRect*> earlier{};  // by region; null: it is new
};

/// The cell of each region.
///   clean_limit   above 0: clean mips at most
Cells cells_of(const std::vector<Region>& regions, const PlanOptions& options, bool gutters,
               int clean_limit = 0);

/// Whether one page may hold each of the regions.
bool fits(const Planning& in, const Cells& cells);

/// Throws Error for the first region that no page can hold, and says what would hold it.
void check_sizes(const Planning& in, const Cells& cells, const RectOptions& options);

/// One page holds each region, but not all of them: throws Error that says so.
[[noreturn]] void refuse_too_many(const Planning& in, const Cells& cells,
                                  const std::vector<std::size_t>& which, const RectOptions& options);

/// The rectangles of the earlier layout that hold what the regions hold.
std::vector<const AtlasRect*> earlier_rects(const std::vector<Region>& regions,
                                            const std::vector<std::string>& names, const AtlasLayout& layout);

/// Regions of the earlier layout that are the same and lie elsewhere.
std::size_t moved(const Planning& in, const PackingPlan& plan);

/// The clean mips that unchanged regions had at most; 0 where the choice of mips itself is another one now.
int earlier_limit(const Planning& in);

/// Where the same regions were, on the pages of the same kind.
///   has   the textures of these pages
std::optional<PreviousRects> previous_rects(const Planning& in, const Cells& cells,
                                            const std::vector<std::size_t>& which, std::array<bool, 2> has);

}  // namespace etak::planning
