// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/rects/masks.h"

namespace etak::rects {

/// A shape with its longest runs first: these find soonest that no column of a row is free.
struct ReadyMask {
  MaskShape shape;
  RowRuns longest_first;
  std::int64_t area = 0;

  explicit ReadyMask(MaskShape of);
};

struct MaskSpot {
  int x = 0, y = 0;
};

/// A page of a fixed width. Its answers for runs of any length are in masks.h.
class MaskPage {
 public:
  MaskPage(int width, int height);

  /// The lowest row up to `last`, and there the leftmost column, at which the shape is free.
  std::optional<MaskSpot> find(const ReadyMask& of, int last);
  /// Whether the shape lies on the page and meets nothing there.
  bool is_free(const MaskShape& shape, const MaskSpot& spot) const;
  void put(const MaskShape& shape, const MaskSpot& spot);

 private:
  using Word = std::uint64_t;
  const Word* row(int level, int y) const;
  Word* row(int level, int y);
  /// Bit x of level k says whether any of the units x .. x + 2^k - 1 is taken.
  void widen(int y);
  /// Adds to taken_ the columns at which a run of the shape meets what lies there.
  bool any_free(const ReadyMask& of, int y, int words);

  int width_, words_;
  std::size_t stride_;  // of rows; a word of zeros behind each
  std::vector<std::vector<Word>> levels_;
  std::vector<Word> taken_;
};

/// Puts a shape where it ends lowest, turned where that is better; none where it is free nowhere above `height`.
///   turned   null: only upright
std::optional<RectPlace> put_lowest(MaskPage& page, const ReadyMask& upright, const ReadyMask* turned,
                                    int height);

/// The shapes on the one page of an earlier layout, which may grow: those with a place there stay, the others come into
/// gaps, the largest first. None where no shape can stay, or where some find no place.
std::optional<RectLayout> keep_masks(std::span<const MaskShape> shapes, const RectOptions& options,
                                     const PreviousRects& previous);

}  // namespace etak::rects
