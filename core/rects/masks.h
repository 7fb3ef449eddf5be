// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/row_runs.h"
#include "core/rects/rects.h"

namespace etak {

// Packing of shapes that are no rectangles: one may lie inside the bounding box of another.

/// A shape of units: `runs` inside width x height, at least one unit.
struct MaskShape {
  int width = 0, height = 0;
  RowRuns runs;
  friend bool operator==(const MaskShape&, const MaskShape&) = default;
};

/// The shape after a turn as of RectPlace: its unit (x, y) then lies in column height - 1 - y and row x.
MaskShape turned(const MaskShape& shape);

/// Places shapes on one page of any sides and of little area, without common units. All lengths are in units.
///   options   multiple, largest_side, rotate and threads are looked at; threads never change the layout
///   previous  where some of them were on the one page of an earlier layout: they stay there, but for those that would meet
///             others now, and the rest goes around them, on a page that may grow. Not looked at where none can stay
///   returns   none where no page that was tried holds them
///
/// A shape goes to the lowest row, then to the leftmost column where it is free. All columns of a row are
/// tried at once, 64 to a word: a run of n units is free at column x where no bit of page[x .. x + n - 1] is
/// set, and the page keeps, of each row, that answer for every power of two. Several orders of the shapes are
/// tried at several widths. With `rotate` the page is never larger than without. From: Baker, Coffman and Rivest 1980 (bottom left).
std::optional<RectLayout> pack_masks(std::span<const MaskShape> shapes, const RectOptions& options,
                                     const PreviousRects* previous = nullptr);

}  // namespace etak
