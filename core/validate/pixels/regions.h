// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/validate/pixels/components.h"

namespace etak {

/// Which picture a kind is judged flat on: its luminance (or the metallic channel).
enum class RegionPlane { a, b, metallic };
RegionPlane plane_of(RegionKind kind);

/// Finds the plateaus of masks in one tile, row by row from the top, with a few rows of state.
///   mask -> eroded with a 3x3 square (what vanishes is a filtered edge) -> of that, where the 3x3 range of
///   the 5x5-median-filtered luminance code is at most 4 (what vanishes is a soft edge; noise stays) ->
///   8-connected components of at least the least area.
/// The tile is judged on its own: beyond its border the nearest texel counts on. Masks are worked on 64
/// texels at a time; luminance and median are computed only around what erosion leaves: on a clean picture,
/// nowhere.
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

  /// After the last row; one per kind, in their order.
  std::vector<PlateauSummary> finish();

  /// Told each row's plateau texels, before small components are dropped; for mask pictures.
  using Recorder = std::function<void(std::size_t kind, int y, const std::uint64_t* words)>;
  void record(Recorder recorder);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Median of 25 in every texel of 16: `rows` are five rows of codes, of which the texel's neighbourhood is
/// columns 0..4 to columns 15..19.
void median_5x5(const std::uint8_t* const rows[5], std::uint8_t out[16]);

}  // namespace etak
