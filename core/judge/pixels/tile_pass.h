// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

#include "core/judge/pixels/byte_masks.h"
#include "core/judge/pixels/evidence.h"
#include "core/judge/pixels/regions.h"

namespace etak {

/// What a pass over the pixels looks for, the same for all tiles.
struct PassPlan {
  const CodeTables* tables = nullptr;
  ByteLimits limits;
  // The exact limits of the levels, where 1 is linear_one: a Y of at least the limit is at or above the
  // level.
  std::array<std::uint32_t, ByteLimits::b_levels> b_y{};
  std::array<std::uint32_t, ByteLimits::a_levels> a_y{};
  std::uint64_t energy_limit = 0, energy_far_limit = 0;  // where 1 is linear_one
  std::vector<RegionKind> kinds;
  ZoneSettings zone;
  bool has_a = false, has_b = false, has_metallic = false;
  bool transparency = false;     // only alpha 255 is opaque
  bool fringe = false;           // hidden texels are looked at (ETK502)
  bool specular_weighs = false;  // the shader reduces diffuse: ETK201 tests Kd (1 - max Ks) + Ks
  bool frames = false;           // an atlas: gutters and mips are looked at
  bool check_gutter = false, check_mips = false;
  int gutter = 0, mips = 0;  // of an atlas, where a tile does not say
  bool hashes = false;
  unsigned workers = 1;
  RegionAnalysis::Recorder recorder;

  int gutter_of(const CheckTile& tile) const {
    return check_gutter ? std::clamp(tile.gutter.value_or(gutter), 0, 256) : 0;
  }
  int mips_of(const CheckTile& tile) const {
    return check_mips ? std::clamp(tile.mips.value_or(mips), 0, 8) : 0;
  }
};

/// Indices of the levels of Y in ByteLimits.
enum BLevel { b_low, b_gem, b_zone, b_metal };  // by default 0.017, 0.0812, and the ends of the zone
enum ALevel { a_dark, a_bright };

/// Gathers the evidence of one tile while its rows go by. count_row() may run on several threads for
/// different rows. follow_row() does the work that needs the rows in their order, and may be a strip behind.
class TilePass {
 public:
  TilePass(const CheckTile& tile, const PassPlan& plan, int strip_rows, bool every_row);

  const PixelBox& box() const { return evidence_.tile.box; }

  /// Row y of the picture; `row` lies at the tile's left edge.
  void count_row(unsigned worker, int y, const RowPointers& row);

  /// Follows a row of the picture that was counted; y ascends. `rows` gives rows of the picture at the tile's left edge.
  void follow_row(int y, const std::function<RowPointers(int)>& rows);

  /// The evidence, after the last row.
  TileEvidence finish();

 private:
  void count_words(ByteCounts& counts, const std::vector<MaskWords>& words, int y, const RowPointers& row,
                   std::uint64_t* masks);
  std::uint64_t sum_is_from(std::uint64_t doubt, const std::uint8_t* texels, std::uint32_t limit) const;
  void count_energy(ByteCounts& counts, std::uint64_t doubt, int x0, int y, const RowPointers& row);
  void count_middle(ByteCounts& counts, std::uint64_t bits, int x0, const RowPointers& row);
  void add_detail(Detail& detail, const RowPointers& row);
  void follow_fringe(int y, const std::function<RowPointers(int)>& rows);
  std::uint64_t* masks_of_row(int y);
  std::uint64_t* invisible_row(int y);

  const PassPlan& plan_;
  TileEvidence evidence_;
  int strip_rows_;
  int sample_step_;
  std::size_t words_;
  std::vector<ByteCounts> counts_;               // per worker
  std::vector<MaskCounts> mask_counts_;          // per worker
  std::vector<Detail> details_;                  // per worker
  std::vector<std::vector<MaskWords>> scratch_;  // per worker
  std::vector<std::uint64_t> masks_;             // strip rows x kinds x words
  std::vector<std::uint64_t> invisible_;         // ring of rows of alpha = 0
  std::unique_ptr<RegionAnalysis> regions_;
};

}  // namespace etak
