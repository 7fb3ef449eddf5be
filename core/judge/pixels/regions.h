// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/judge/pixels/components.h"

namespace etak {

/// The plane on which regions of a kind must be flat: the luminance of A or B, or the metallic channel.
enum class RegionPlane { a, b, metallic };
RegionPlane plane_of(RegionKind kind);

/// Finds the plateaus of masks in one tile, row by row from the top, with a few rows of state, in three
/// steps:
///   1. The mask is eroded with a square of 3x3 (or 5x5) texels, by which filtered edges vanish.
///   2. Of the rest those texels stay where the 3x3 range of the 5x5-median-filtered luminance code is at
///      most 4, by which soft edges vanish and noise stays.
///   3. Plateaus are the 8-connected components of at least the least area.
/// The tile is judged on its own: beyond its border the nearest texel is repeated. Masks are handled 64
/// texels at a time. Luminance and median are computed only around the texels that erosion leaves: on a clean
/// picture, nowhere.
class RegionAnalysis {
 public:
  ///   tile     in the picture
  ///   erode    1 (off), 3 or 5; 0: the masks are recorded as they are, and nothing else is done
  RegionAnalysis(const PixelBox& tile, std::span<const RegionKind> kinds, int erode, std::size_t least_area,
                 const CodeTables& tables);
  ~RegionAnalysis();
  RegionAnalysis(RegionAnalysis&&) noexcept;

  /// Rows y (of the tile) that are still needed while row y is pushed: y - rows_kept + 1 ... y.
  static constexpr int rows_kept = 8;

  /// Row y of the tile; y ascends by 1 from 0. Bits beyond the width are 0.
  ///   masks   of kind k at masks[k * word_count()]
  ///   rows    where rows y - 7 ... y lie
  void push(int y, const std::uint64_t* masks, const std::function<RowPointers(int)>& rows);

  std::size_t word_count() const;

  /// To be called after the last row: one summary for each kind, in their order.
  std::vector<PlateauSummary> finish();

  /// Called with the plateau texels of each row, before small components are dropped; for mask pictures.
  using Recorder = std::function<void(std::size_t kind, int y, const std::uint64_t* words)>;
  void record(Recorder recorder);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The medians of the 5x5 codes around each of 16 texels in a row. `rows` are five rows of 20 codes; the
/// neighbourhood of texel i are the columns i to i + 4.
void median_5x5(const std::uint8_t* const rows[5], std::uint8_t out[16]);

}  // namespace etak
