// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_set>

#include "core/maps/map_evidence.h"

namespace etak {

/// Looks for the traces of JPEG (ITU-T T.81) in a picture that may have become any other format since: the
/// brightness of its blocks of 8 x 8 texels, as cosines, has coefficients that are multiples of a step.
/// Chroma is not looked at, since it may have been subsampled. Found from steps of 3 codes (quality 85) to
/// 24 (about 35), where at least 40 different blocks have something of a frequency: finer steps drown in the
/// rounding of the colours. Not where the picture was cropped or scaled since, which moves the blocks.
class JpegCombSearch {
 public:
  /// A block of 8 x 8 texels, 4 bytes each, rows `stride` bytes apart. Equal blocks count once.
  ///   aligned   on multiples of 8; else 4 texels aside, for comparison: there a JPEG leaves no comb
  void add_block(const std::uint8_t* rgba, std::size_t stride, bool aligned);
  std::optional<JpegComb> finish() const;

 private:
  static constexpr std::size_t frequencies = 8;
  // Coefficients by quarters of a code, from -64 to 64; what lies outside is left out.
  static constexpr int bins_a_code = 4, most_code = 64;
  using Bins = std::array<std::uint32_t, std::size_t{2} * bins_a_code * most_code + 1>;
  struct Grid {
    std::array<Bins, frequencies> bins{};
    std::unordered_set<std::uint64_t> seen;
  };
  static JpegComb comb_of(const Grid& grid);

  std::array<Grid, 2> grids_;  // aligned, aside
};

}  // namespace etak
