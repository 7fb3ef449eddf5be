// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/rects/rects.h"

namespace etak::rects {

// What the packing rules share. Lengths are whole units in all of them: texels divided by RectOptions::align.

struct Spot {
  int x = 0, y = 0;
  bool rotated = false;
};

/// The outcome of one try.
struct Outcome {
  bool all = false;           // every rectangle of the order has a spot
  std::int64_t placed = 0;    // area of the rectangles that have a spot
  int width = 0, height = 0;  // extent of what was placed
  std::int64_t work = 0;      // operations done, about nanoseconds: the same on every machine
};

/// The rectangles in canonical order (long side, short side, width; largest first), so that nothing below
/// depends on the order of the input.
struct Set {
  std::vector<RectSize> items;
  std::int64_t area = 0;
  int widest = 0, tallest = 0, longest_side = 0, longest_short_side = 0;
  int width_step = 1, height_step = 1;  // all widths are multiples of the first, all heights of the second

  Set() = default;
  explicit Set(std::vector<RectSize> canonical);
  Set turned() const;  // width and height swapped, the same indices
  int size() const { return static_cast<int>(items.size()); }
};

/// What an order of rectangles sorts by: the largest first, of equal ones the earlier in the set.
enum class Key { height, width, area, long_side, short_side, perimeter, difference, ratio };
inline constexpr int key_count = 8;
const char* name_of(Key key);

std::vector<int> ordered(const Set& set, std::span<const int> members, Key key);

}  // namespace etak::rects
