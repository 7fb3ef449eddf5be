// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/judge/finding.h"
#include "core/judge/pixels/code_tables.h"
#include "core/judge/rule.h"

namespace etak {

/// A region that the analysis has found: connected, flat and large enough.
struct Plateau {
  RegionKind kind = RegionKind::zone;
  PixelBox box;  // in the picture
  std::size_t area = 0;
  std::array<double, 3> specular{}, diffuse{};  // mean, linear
  double metallic = 0;                          // mean
  std::uint8_t least = 255, most = 0;           // extreme codes on the plane that was judged
  friend bool operator==(const Plateau&, const Plateau&) = default;
};

/// The sums over all plateaus of one kind in one tile, and the largest of them.
struct PlateauSummary {
  std::size_t masked = 0;  // texels that meet the condition
  std::size_t area = 0;    // of those, on plateaus that are large enough
  std::size_t regions = 0;
  PixelBox box;                           // around all of them
  std::vector<Plateau> largest;           // at most `kept`, largest first; equal ones from the top
  std::vector<std::size_t> area_by_code;  // 256, by the luminance code of the mean; empty when regions is 0
  PixelBox masked_box;                    // around all texels that meet the condition
  // Only for the zone: solid patches with hard edges that are too small for a region, and the largest of
  // them, whose box includes the texels that erosion has removed.
  std::size_t patches = 0;
  std::size_t patch_area = 0;  // of their boxes
  Plateau largest_patch;
  static constexpr std::size_t kept = 256;
};

/// The row of each picture that a run of texels lies in, from the tile's left edge on; null where there is no
/// such picture.
struct RowPointers {
  const std::uint8_t *a = nullptr, *b = nullptr, *metallic = nullptr;
};

/// Joins texels of successive rows into 8-connected components (runs and union-find), with sums over each. A
/// component is judged and forgotten as soon as a row adds nothing to it, so that memory grows with the width
/// only.
class Components {
 public:
  ///   tile         in the picture
  ///   least_area   components of fewer texels are dropped
  ///   eroded       how many texels erosion has removed on each side
  Components(RegionKind kind, const PixelBox& tile, std::size_t least_area, int eroded,
             const CodeTables& tables);

  /// Row y of the tile, y ascending by 1 from any row; bit i of word w is texel 64 w + i.
  ///   codes   codes of the judged plane in this row: of the texels that are set, and of the `edge_reach`
  ///           texels on both sides of each; beyond the first and last column their codes are repeated
  void add_row(int y, const std::uint64_t* words, std::size_t word_count, const RowPointers& rows,
               const std::uint8_t* codes);

  static constexpr int edge_reach = 5;

  /// A row without any texel.
  void add_empty_row();

  /// To be called after the last row: closes all components and fills in `summary`.
  void finish(PlateauSummary& summary);

 private:
  struct Sums {
    std::size_t area = 0;
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // inclusive, in the tile
    std::array<std::uint64_t, 3> specular{}, diffuse{};
    std::uint64_t metallic = 0;
    std::uint8_t least = 255, most = 0;
    std::size_t hard_ends = 0, soft_ends = 0;  // of runs; ends at the tile's border are neither
    bool touched = false;                      // the current row has added to it
  };
  struct Run {
    int first, last;
    std::uint32_t component;
  };

  std::uint32_t root(std::uint32_t component);
  std::uint32_t create();
  std::uint32_t join(std::uint32_t a, std::uint32_t b);
  void add_run(int y, const Run& run, const RowPointers& rows, const std::uint8_t* codes);
  Plateau plateau_of(const Sums& sums) const;
  void close(const Sums& sums);
  void close_small(const Sums& sums);
  void retire(bool all);

  RegionKind kind_;
  PixelBox tile_;
  std::size_t least_area_;
  int eroded_;
  const CodeTables& tables_;
  std::vector<Sums> sums_;
  std::vector<std::uint32_t> parent_, free_, open_;
  std::vector<Run> above_, current_;
  PlateauSummary result_;
};

}  // namespace etak
