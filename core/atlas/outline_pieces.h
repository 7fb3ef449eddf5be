// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/atlas/plan.h"

namespace etak {

/// The cell of a region: its texels, in whole texels of its clean mips, with the gutter around each.
///   unit      texels a side of a unit of the shape
///   returns   (0, 0) is the corner of the gutter around the region's box
MaskShape cell_shape(const Region& region, int gutter, int clean_levels, int unit);

/// Regions and their places, by index.
struct PlacedRegions {
  std::vector<Region> regions;
  std::vector<PlannedPlace> places;
};

/// The outlines of a plan as boxes, so that all that reads regions knows boxes alone. The pieces of an outline lie
/// as the outline does: shifted by the same, turned alike, behind each other in the outline's place in the list.
/// Together they hold its texels, each once. A piece may hold more texels of the picture, where the page has room for
/// them, and its gutter lies over other pieces of its outline, which hold the same there; of other outlines it holds
/// nothing, with its gutter.
PlacedRegions outline_pieces(const std::vector<Region>& regions, const PackingPlan& plan);

}  // namespace etak
