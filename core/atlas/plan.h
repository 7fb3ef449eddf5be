// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/atlas/layout.h"
#include "core/image/pixels_view.h"
#include "core/rects/masks.h"

namespace etak {

// Where the regions of an atlas go: gutters and alignment follow from the mips, then rectangles are packed.

/// A part of a material's texels that gets a place of its own.
struct Region {
  std::size_t material = 0;            // index of the owner
  PixelBox box;                        // in its picture
  std::array<bool, 2> in{true, true};  // by Texture: which of the two textures must hold the region
  bool own_page = false;               // a page of just its size, whose edges wrap
  int levels = 0;                      // mips that its samplers read, level 0 among them; 0: all
  int shrink = 0;                      // stored as the mip of this level: sides halved so many times
  // Which texels of the box are kept, at the level that is stored; empty: all. They are packed as they lie.
  RowRuns texels = {};
  int outline = 0;  // of pieces of one outline (outline_pieces.h) its number, from 1 on

  // Texels a side as stored.
  int width() const { return std::max(1, box.width >> shrink); }
  int height() const { return std::max(1, box.height >> shrink); }
  std::uint64_t area() const {
    return texels.empty() ? static_cast<std::uint64_t>(width()) * static_cast<std::uint64_t>(height())
                          : count_of(texels);
  }
  friend bool operator==(const Region&, const Region&) = default;
};

/// The region's box in texels of the level that is stored.
inline PixelBox stored_box(const Region& region) {
  return {region.box.x >> region.shrink, region.box.y >> region.shrink, region.width(), region.height()};
}

/// How regions are placed on pages.
struct PlanOptions {
  RectOptions rects;          // form, side, rotation, effort, threads
  bool free_first = false;    // one page of any sides where that holds everything, else `rects.form`
  int levels = 1;             // mips that will be sampled, level 0 among them; 0: down to 1 x 1
  std::optional<int> gutter;  // texels on every side at least; none: from the mips of each region
  int least_gutter = 0;       // where gutters come from the mips: at least so many texels
  int block_side =
      0;  // above 0: no block of so many texels a side of a clean mip holds texels of two regions
  bool may_inset = true;       // no gutters where they would cost more than a quarter of the area
  bool bare_alone = true;      // without inset: the only region takes a page of just its size
  bool split_textures = true;  // regions that one texture can do without may go to pages of their own
  double most_extra_area =
      0.05;  // regions stay in place while that takes this share more than the least area
};

/// A region's place. The texels lie at x, y; around them are `gutter` texels that repeat the edge.
struct PlannedPlace {
  int page = 0, x = 0, y = 0;
  bool rotated = false;
  int gutter = 0;
  int clean_levels = 1;  // levels on which bilinear filtering reads no texel of a neighbour
  PixelBox cell;         // the texels of this region alone: with the gutter, rounded up to the alignment
  std::uint64_t cell_texels = 0;  // of an outline: how many of the cell are of this region alone; 0: all
  friend bool operator==(const PlannedPlace&, const PlannedPlace&) = default;
};

/// Where the region's texels of level 0 lie on its page, without the gutter.
inline PixelBox box_on_page(const Region& region, const PlannedPlace& at) {
  return {at.x, at.y, at.rotated ? region.height() : region.width(),
          at.rotated ? region.width() : region.height()};
}

/// The size of a page, and which of the two textures it has.
struct PlannedPage {
  int width = 0, height = 0;
  std::array<bool, 2> has{true, true};  // by Texture
  friend bool operator==(const PlannedPage&, const PlannedPage&) = default;
};

/// The places of all regions on the pages, and how they were found.
struct PackingPlan {
  std::vector<PlannedPage> pages;
  std::vector<PlannedPlace> places;  // in the order of the regions
  bool inset = false;  // no gutters: UVs must stay half a texel of the last clean mip inside the region
  std::string method;
  int tries = 0;
  bool cut_by_time = false, kept_previous = false;
  std::size_t moved = 0;  // regions of the earlier layout that lie elsewhere now
  // Above 0: new regions have no more clean mips than this, so that the others could stay on their grid.
  int clean_limit = 0;
  // The cells of the regions in plans with outlines, in units of so many texels a side.
  std::vector<MaskShape> shapes = {};
  int unit = 1;

  std::uint64_t page_texels() const;  // of both textures
  /// Mips of a page that are free of neighbours; further ones are made of the whole page.
  int clean_levels(int page) const;
};

/// Mips that a region of these sides keeps clean at a gutter of a 32nd of its smaller side: 1 below 64
/// texels.
int default_clean_levels(int width, int height);

/// Mips that a region gets at most, level 0 among them.
///   asked, read   by the pages and by the samplers; 0: all
int levels_wanted(int asked, int read);

/// Mips that a region of these sides keeps clean, of `wanted` at most.
///   gutter   around the region; 0 and none: as its mips need
int clean_levels(int width, int height, int wanted, std::optional<int> gutter);

/// Deterministic in the set of regions: their order plays no part beyond ties of equal sizes, which go by
/// index.
///   previous   of the same materials, matched by name, island and size. Of the layouts that take at most
///              `most_extra_area` more than the least, the one that moves the fewest regions is taken
/// Throws Error for a region that fits no page.
PackingPlan plan_pages(const std::vector<Region>& regions, const std::vector<std::string>& names,
                       const PlanOptions& options, const AtlasLayout* previous = nullptr);

}  // namespace etak
